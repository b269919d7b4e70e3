#include "common/result_open.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/result_hdf.h"
#include "common/result_layout.h"
#include "common/result_store.h"

enum { PATIENCE = 60 }; /* s, before a file that keeps HDF5 busy counts as damaged */

/* ---- what can be told without HDF5 ---- */

static enum status check_length(const char *path, off_t size) {
  static const unsigned char signature[8] = "\211HDF\r\n\032\n";
  unsigned char head[48] = {0}; /* a superblock of version 2, the one we write */
  FILE *f = fopen(path, "rb");
  CHECK(f, ERR_INPUT, "cannot read %s: %s", path, strerror(errno));
  size_t got = fread(head, 1, sizeof head, f);
  fclose(f);
  CHECK(got >= sizeof signature && !memcmp(head, signature, sizeof signature), ERR_INPUT,
        "%s is not a result file: it is not HDF5", path);
  uint64_t end = 0;
  if (head[8] == 2 && head[9] == 8) memcpy(&end, head + 28, sizeof end); /* of the whole file */
  CHECK(got == sizeof head && end <= (uint64_t)size, ERR_INPUT,
        "%s is cut short: only %lld bytes of it are there", path, (long long)size);
  return OK;
}

static enum status check_file(const char *path, enum result_seal *seal) {
  struct stat about;
  CHECK(!stat(path, &about), ERR_INPUT, "cannot read %s: %s", path, strerror(errno));
  CHECK(!S_ISDIR(about.st_mode), ERR_INPUT, "%s is a directory, not a result file", path);
  CHECK(S_ISREG(about.st_mode), ERR_INPUT, "%s is not a file", path);
  CHECK(about.st_size > 0, ERR_INPUT, "%s is empty", path);
  TRY(result_store_check(path, seal));
  CHECK(*seal != RESULT_SEAL_BROKEN, ERR_INPUT,
        "%s is damaged: its checksum does not match its content (copy it or run the case again)",
        path);
  return *seal == RESULT_SEAL_GOOD ? OK : check_length(path, about.st_size);
}

/* ---- the rehearsal ---- */

static void child_read(enum status (*read)(void *request), void *request, int to) {
  int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO); /* last words of a crash */
  dup2(nowhere, STDERR_FILENO);
  setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
  alarm(PATIENCE);
  enum status status = read(request);
  const char *message = status_message();
  if (status != OK && write(to, message, strlen(message)) < 0) _exit(ERR_INPUT);
  _exit((int)status);
}

static enum status rehearse(const char *path, enum status (*read_)(void *request), void *request) {
  int ends[2];
  CHECK(!pipe(ends), ERR_INPUT, "cannot read %s: %s", path, strerror(errno));
  fflush(NULL);
  pid_t child = fork();
  if (!child) child_read(read_, request, ends[1]);
  close(ends[1]);
  char message[1024] = "";
  for (size_t n = 0; child > 0 && n < sizeof message - 1;) {
    ssize_t got = read(ends[0], message + n, sizeof message - 1 - n);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    n += (size_t)got;
  }
  close(ends[0]);
  int outcome = 0;
  while (child > 0 && waitpid(child, &outcome, 0) < 0 && errno == EINTR) continue;
  CHECK(child > 0, ERR_INPUT, "cannot read %s: %s", path, strerror(errno));
  CHECK(WIFEXITED(outcome), ERR_INPUT, "%s is damaged beyond reading", path);
  if (WEXITSTATUS(outcome) == OK) return OK;
  CHECK(*message, ERR_INPUT, "%s is damaged beyond reading", path);
  return status_raise(WEXITSTATUS(outcome) == ERR_MEMORY ? ERR_MEMORY : ERR_INPUT, "%s", message);
}

enum status result_read_safely(const char *path, enum status (*read)(void *request),
                               void *request) {
  enum result_seal seal;
  TRY(check_file(path, &seal));
  if (seal != RESULT_SEAL_GOOD) TRY(rehearse(path, read, request));
  return read(request);
}

/* ---- inside `read` ---- */

static enum status check_format(const char *path, hid_t file) {
  char *format = NULL;
  int64_t version = 0;
  bool ours = hdf_get_string(file, "format", &format) == OK && !strcmp(format, RESULT_FORMAT);
  free(format);
  CHECK(ours, ERR_INPUT, "%s is an HDF5 file, but not a result of plunge", path);
  enum status status = hdf_get_integer(file, "format_version", &version);
  if (status != OK) return status_context(status, "%s is not a usable result: ", path);
  CHECK(version == RESULT_FORMAT_VERSION, ERR_INPUT,
        "%s has version %lld of the result format; this program reads version %d", path,
        (long long)version, RESULT_FORMAT_VERSION);
  return OK;
}

enum status result_open(const char *path, hid_t *file) {
  hdf_quiet();
  hid_t fapl = H5Pcreate(H5P_FILE_ACCESS);
  *file = -1;
  for (int attempt = 0; *file < 0 && attempt < 3; attempt++) {
    /* The lock keeps a run from changing this file under us. It fails when the run has just changed
     * names (then the next attempt finds the newer file) and where locks do not work. */
    H5Pset_file_locking(fapl, attempt < 2, true);
    *file = H5Fopen(path, H5F_ACC_RDONLY, fapl);
  }
  H5Pclose(fapl);
  if (*file < 0) return hdf_raise(ERR_INPUT, "%s is damaged", path);
  enum status status = check_format(path, *file);
  if (status != OK) H5Fclose(*file);
  return status;
}
