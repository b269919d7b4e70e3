#include "common/base/file.h"

#include <errno.h>
#include <fcntl.h>
#include <unistd.h>

int file_lift(int fd) {
  if (fd < 0 || fd > STDERR_FILENO) return fd;
  int higher = fcntl(fd, F_DUPFD_CLOEXEC, STDERR_FILENO + 1), reason = errno;
  close(fd);
  errno = reason;
  return higher;
}

int file_open(const char *path, int flags) {
  return file_lift(open(path, flags | O_CLOEXEC | O_NOCTTY, 0666));
}

FILE *file_create(const char *path) {
  if (unlink(path) && errno != ENOENT) return NULL;
  int fd = file_open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
  FILE *f = fd < 0 ? NULL : fdopen(fd, "w");
  if (fd >= 0 && !f) close(fd);
  return f;
}
