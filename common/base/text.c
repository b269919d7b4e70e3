#include "common/base/text.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unictype.h>
#include <unistd.h>
#include <unistr.h>

/* What is there instead of a text file; NULL when it is one. Without O_NONBLOCK the opening alone
 * of a FIFO could take for ever. */
static const char *what_else(mode_t mode) {
  if (S_ISREG(mode)) return NULL;
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

static enum status open_text(const char *path, int *fd) {
  struct stat info;
  if (!strcmp(path, "-")) {
    *fd = fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    CHECK(*fd >= 0, ERR_INPUT, "nothing to read (%s)", strerror(errno));
    return OK;
  }
  *fd = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  CHECK(*fd >= 0 || errno != ENXIO, ERR_INPUT, "a socket or a device");
  CHECK(*fd >= 0, ERR_INPUT, "nothing to read (%s)", strerror(errno));
  const char *other = fstat(*fd, &info) ? "nothing to read" : what_else(info.st_mode);
  CHECK(!other, ERR_INPUT, "%s", other);
  return OK;
}

static enum status read_all(int fd, size_t most, char **text, size_t *n) {
  size_t room = 0;
  for (;;) {
    if (*n + 1 >= room) {
      room = room ? 2 * room : 65536;
      if (room > most + 2) room = most + 2; /* one byte too many, and the NUL */
      char *more = realloc(*text, room);
      CHECK(more, ERR_MEMORY, "no memory for a text of %zu bytes", room);
      *text = more;
    }
    ssize_t got = read(fd, *text + *n, room - 1 - *n);
    if (got < 0 && errno == EINTR) continue;
    CHECK(got >= 0, ERR_INPUT, "an end before the end of the file (%s)", strerror(errno));
    *n += (size_t)got;
    (*text)[*n] = 0;
    if (!got) return OK;
    CHECK(*n <= most, ERR_INPUT, "more than %zu MB", most >> 20);
  }
}

static enum status check_text(char *text, size_t *n) {
  static const char mark[] = "\xef\xbb\xbf"; /* U+FEFF, as some editors put in front */
  CHECK(!memchr(text, 0, *n), ERR_INPUT, "a binary file");
  if (strncmp(text, mark, 3)) return OK;
  *n -= 3;
  memmove(text, text + 3, *n + 1);
  return OK;
}

enum status text_read(const char *path, size_t most, char **text, size_t *n) {
  int fd = -1;
  *text = NULL;
  *n = 0;
  enum status status = open_text(path, &fd);
  if (status == OK) status = read_all(fd, most, text, n);
  if (status == OK) status = check_text(*text, n);
  if (fd >= 0) close(fd);
  if (status != OK) {
    free(*text);
    *text = NULL;
  }
  return status;
}

char *text_line(char **rest) {
  if (!*rest || !**rest) return NULL;
  char *line = strsep(rest, "\n");
  size_t n = strlen(line);
  if (n && line[n - 1] == '\r') line[n - 1] = 0;
  return line;
}

/* Bytes of the character at `c`, and whether it is to be shown as bytes. */
static size_t character(const uint8_t *c, size_t n, bool *odd) {
  ucs4_t code;
  int length = u8_mbtoucr(&code, c, n);
  *odd = length <= 0 || uc_is_cntrl(code) || uc_is_property_bidi_control(code) ||
         uc_is_property_not_a_character(code) || code == 0x2028 || code == 0x2029; /* line ends */
  return length > 0 ? (size_t)length : 1;
}

void text_show(FILE *out, const char *text, const char *keep) {
  const uint8_t *c = (const uint8_t *)text;
  for (size_t n = strlen(text), length; n; n -= length, c += length) {
    bool odd;
    length = character(c, n, &odd);
    if (!odd || strchr(keep, *c))
      fwrite(c, 1, length, out);
    else
      for (size_t i = 0; i < length; i++) fprintf(out, "\\x%02x", c[i]);
  }
}

char *text_visible(const char *text, const char *keep) {
  char *copy = NULL;
  size_t n;
  FILE *out = open_memstream(&copy, &n);
  if (!out) return NULL;
  text_show(out, text, keep);
  if (fclose(out) == 0) return copy;
  free(copy);
  return NULL;
}

const char *text_bad_utf8(const char *text, size_t n) {
  return (const char *)u8_check((const uint8_t *)text, n);
}
