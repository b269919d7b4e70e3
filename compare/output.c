#include "compare/output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum status cmp_path_join(const char *dir, const char *name, char *out) {
  int n = snprintf(out, PATH_MAX, "%s/%s", dir, name);
  CHECK(n > 0 && n < PATH_MAX, ERR_IO, "the path %.100s.../%s is too long", dir, name);
  return OK;
}

enum status cmp_output_open(const char *path, struct cmp_output *o) {
  *o = (struct cmp_output){0};
  int n = snprintf(o->path, sizeof o->path, "%s", path);
  int m = snprintf(o->temporary, sizeof o->temporary, "%.*s.XXXXXX", PATH_MAX - 8, path);
  CHECK(n > 0 && n < PATH_MAX && m < PATH_MAX, ERR_IO, "the path %.100s... is too long", path);
  int file = mkstemp(o->temporary);
  CHECK(file >= 0, ERR_IO, "cannot write %s: %s", path, strerror(errno));
  mode_t mask = umask(0);
  umask(mask);
  o->stream = fchmod(file, 0666 & ~mask) == 0 ? fdopen(file, "w") : NULL;
  if (!o->stream) {
    int error = errno;
    close(file);
    unlink(o->temporary);
    return status_raise(ERR_IO, "cannot write %s: %s", path, strerror(error));
  }
  return OK;
}

enum status cmp_stream_close(FILE *stream, const char *path) {
  int bad = ferror(stream), error = errno;
  if (fclose(stream) != 0) {
    bad = 1;
    error = errno;
  }
  CHECK(!bad, ERR_IO, "cannot write %s: %s; free some space or choose another --out", path,
        strerror(error));
  return OK;
}

enum status cmp_output_commit(struct cmp_output *o) {
  FILE *stream = o->stream;
  o->stream = NULL;
  enum status status = cmp_stream_close(stream, o->path);
  if (status == OK && rename(o->temporary, o->path) != 0)
    status = status_raise(ERR_IO, "cannot write %s: %s", o->path, strerror(errno));
  if (status != OK) unlink(o->temporary);
  return status;
}

void cmp_output_abandon(struct cmp_output *o) {
  if (!o->stream) return;
  fclose(o->stream);
  o->stream = NULL;
  unlink(o->temporary);
}

enum status cmp_directory_make(const char *path) {
  char part[PATH_MAX];
  struct stat info;
  CHECK(*path, ERR_USAGE, "the folder's name is empty");
  int n = snprintf(part, sizeof part, "%s", path);
  CHECK(n > 0 && n < PATH_MAX, ERR_IO, "the path %.100s... is too long", path);
  for (char *slash = strchr(part + 1, '/');; slash = strchr(slash + 1, '/')) {
    if (slash) *slash = 0;
    CHECK(mkdir(part, 0777) == 0 || errno == EEXIST, ERR_IO, "cannot make the folder %s: %s", part,
          strerror(errno));
    if (!slash) break;
    *slash = '/';
  }
  CHECK(!stat(path, &info) && S_ISDIR(info.st_mode), ERR_USAGE,
        "%s is not a folder; choose another --out", path);
  return OK;
}

enum status cmp_file_read(const char *path, char **bytes, size_t *n) {
  *bytes = NULL;
  FILE *f = fopen(path, "rb");
  CHECK(f, ERR_IO, "cannot read %s: %s", path, strerror(errno));
  struct stat info;
  enum status status = OK;
  if (fstat(fileno(f), &info) != 0 || !(*bytes = malloc((size_t)info.st_size + 1))) {
    status = status_raise(ERR_IO, "cannot read %s: %s", path, strerror(errno));
  } else {
    *n = fread(*bytes, 1, (size_t)info.st_size, f);
    (*bytes)[*n] = 0;
  }
  fclose(f);
  return status;
}
