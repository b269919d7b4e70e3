#include "common/result/result_fd.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/result/result_driver.h"

struct opened {
  int fd;
  haddr_t eoa, eof;
};

/* Zeros beyond the end of the file, as HDF5's own driver has it. */
static enum status fd_read(void *data, haddr_t at, size_t n, unsigned char *to) {
  const struct opened *o = data;
  while (n) {
    ssize_t got = pread(o->fd, to, n, (off_t)at);
    if (got < 0 && errno == EINTR) continue;
    CHECK(got >= 0, ERR_INPUT, "cannot read on: %s", strerror(errno));
    if (got == 0) break;
    to += got;
    at += (haddr_t)got;
    n -= (size_t)got;
  }
  memset(to, 0, n);
  return OK;
}

static enum status fd_write(void *data, haddr_t at, size_t n, const unsigned char *from) {
  (void)data, (void)at, (void)n, (void)from;
  return status_raise(ERR_IO, "a file that is read only");
}

hid_t result_fd_open(int fd) {
  struct stat about;
  struct opened *o = fstat(fd, &about) ? NULL : calloc(1, sizeof *o);
  if (!o) return -1;
  *o = (struct opened){.fd = fd, .eof = (haddr_t)about.st_size};
  hid_t fapl = H5Pcreate(H5P_FILE_ACCESS);
  struct result_driver driver = {o, &o->eoa, &o->eof, fd_read, fd_write};
  hid_t id = result_driver_set(fapl, &driver);
  return id < 0 ? -1 : H5Fopen("result", H5F_ACC_RDONLY, fapl);
}
