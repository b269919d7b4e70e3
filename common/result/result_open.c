#include "common/result/result_open.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "common/base/file.h"
#include "common/result/result_fd.h"
#include "common/result/result_guard.h"
#include "common/result/result_hdf.h"
#include "common/result/result_layout.h"
#include "common/result/result_seal.h"

struct open_files {
  const struct result_request *request;
  int fd[2]; /* [n], held with a shared lock until the request is done; -1: not open */
};

/* ---- what can be told without HDF5 ---- */

static enum status check_length(const char *path, int fd, off_t size, bool any) {
  static const unsigned char signature[8] = "\211HDF\r\n\032\n";
  unsigned char head[48] = {0}; /* a superblock of version 2, the one we write */
  ssize_t got = pread(fd, head, sizeof head, 0);
  CHECK(got >= 0, ERR_INPUT, "cannot read %s: %s", path, strerror(errno));
  CHECK(got >= (ssize_t)sizeof signature && !memcmp(head, signature, sizeof signature), ERR_INPUT,
        any ? "%s is not HDF5" : "%s is not a result file: it is not HDF5", path);
  uint64_t end = 0;
  if (head[8] == 2 && head[9] == 8) memcpy(&end, head + 28, sizeof end); /* of the whole file */
  CHECK(got == sizeof head && end <= (uint64_t)size, ERR_INPUT,
        "%s is cut short: only %lld bytes of it are there", path, (long long)size);
  return OK;
}

/* Files whose bytes this process has checked. One that was changed a moment ago is not taken in: it
 * could be changed again without another time. */
enum { CHECKED = 64, MOMENT = 2 /* s */ };
static _Thread_local struct stat checked[CHECKED];
static _Thread_local size_t n_checked;

static bool same_time(const struct timespec *a, const struct timespec *b) {
  return a->tv_sec == b->tv_sec && a->tv_nsec == b->tv_nsec;
}

static bool is_checked(const struct stat *f) {
  const size_t n = n_checked < CHECKED ? n_checked : CHECKED;
  for (size_t k = 0; k < n; k++)
    if (checked[k].st_ino == f->st_ino && checked[k].st_dev == f->st_dev &&
        checked[k].st_size == f->st_size && same_time(&checked[k].st_mtim, &f->st_mtim) &&
        same_time(&checked[k].st_ctim, &f->st_ctim))
      return true;
  return false;
}

static void checked_add(const struct stat *f) {
  struct timespec now;
  if (clock_gettime(CLOCK_REALTIME, &now) != 0 || now.tv_sec - f->st_ctim.tv_sec < MOMENT) return;
  checked[n_checked++ % CHECKED] = *f;
}

static enum status check_file(const char *path, int fd, bool any, size_t *size) {
  struct stat about;
  CHECK(!fstat(fd, &about), ERR_INPUT, "cannot read %s: %s", path, strerror(errno));
  CHECK(!S_ISDIR(about.st_mode), ERR_INPUT, "%s is a directory, not a%s file", path,
        any ? "n HDF5" : " result");
  CHECK(S_ISREG(about.st_mode), ERR_INPUT, "%s is not a file", path);
  CHECK(about.st_size > 0, ERR_INPUT, "%s is empty", path);
  *size += (size_t)about.st_size;
  if (is_checked(&about)) return OK;
  enum result_seal_state seal;
  TRY(result_seal_check(path, fd, (uint64_t)about.st_size, &seal));
  CHECK(seal != RESULT_SEAL_BROKEN, ERR_INPUT,
        "%s is damaged: its checksum does not match its content (copy it or run the case again)",
        path);
  if (seal != RESULT_SEAL_GOOD) TRY(check_length(path, fd, about.st_size, any));
  checked_add(&about);
  return OK;
}

/* Opens the file and keeps the run that writes it from changing it; if that has just changed names,
 * the next attempt finds the newer file. A FIFO does not make us wait for its writer. */
static int open_to_read(const char *path) {
  for (int attempt = 0;; attempt++) {
    int fd = file_open(path, O_RDONLY | O_NONBLOCK);
    if (fd < 0 || !flock(fd, LOCK_SH | LOCK_NB) || errno != EWOULDBLOCK || attempt == 3) return fd;
    close(fd);
  }
}

/* ---- in the child ---- */

/* A file of another program is a result if it has the scales. */
static enum status check_format(hid_t file) {
  char *format = NULL;
  int64_t version = 0;
  bool ours = hdf_get_string(file, "format", &format) == OK && !strcmp(format, RESULT_FORMAT);
  free(format);
  if (!ours) {
    CHECK(H5Aexists(file, "H") > 0, ERR_INPUT,
          "is an HDF5 file, but no result: it has no attribute H, one of the scales H, g, density "
          "and spacing, which docs/result-file.md describes");
    return OK;
  }
  enum status status = hdf_get_integer(file, "format_version", &version);
  if (status != OK) return status_context(status, "is not a usable result: ");
  CHECK(version == RESULT_FORMAT_VERSION, ERR_INPUT,
        "has version %lld of the result format; this program reads version %d", (long long)version,
        RESULT_FORMAT_VERSION);
  return OK;
}

static enum status open_file(int fd, bool any, hid_t *file) {
  *file = result_fd_open(fd);
  if (*file < 0) return hdf_raise(ERR_INPUT, "is damaged");
  if (!any) TRY(check_format(*file));
  enum status status = hdf_check_confined(*file);
  return status == OK ? OK : status_context(status, "is not a usable result: ");
}

static enum status read_files(void *data) {
  const struct open_files *open = data;
  const struct result_request *r = open->request;
  hid_t file[2] = {-1, -1};
  hdf_quiet();
  H5PLset_loading_state(0); /* no code from elsewhere, such as filters */
  for (size_t k = 0; k < r->n; k++) {
    guard_blame(k);
    enum status status = open_file(open->fd[k], r->any, &file[k]);
    if (status != OK) return status_context(status, "%s ", r->path[k]);
  }
  guard_blame(0);
  return r->read(file, r->data); /* the process ends: nothing needs to be closed */
}

static enum status carry_answer(struct carrier *c, void *data) {
  const struct open_files *open = data;
  return open->request->carry(c, open->request->data);
}

/* ---- both ---- */

void result_blame(size_t file) {
  guard_blame(file);
}

enum status result_read_safely(const struct result_request *r) {
  struct open_files open = {r, {-1, -1}};
  struct guard guard = {.read = read_files, .carry = carry_answer, .data = &open};
  enum status status = OK;
  for (size_t k = 0; k < r->n; k++) {
    open.fd[k] = open_to_read(r->path[k]);
    if (open.fd[k] < 0) {
      status = status_raise(ERR_INPUT, "cannot read %s: %s", r->path[k], strerror(errno));
      goto done;
    }
    ATTEMPT(check_file(r->path[k], open.fd[k], r->any, &guard.size));
    guard.name[k] = r->path[k];
  }
  status = guard_run(&guard);
done:
  for (size_t k = 0; k < r->n; k++)
    if (open.fd[k] >= 0) close(open.fd[k]);
  return status;
}
