#include "common/result/result_store.h"

#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/uio.h>
#include <unistd.h>

#include "common/base/array.h"
#include "common/base/file.h"
#include "common/result/result_driver.h"
#include "common/result/result_hdf.h"
#include "common/result/result_seal.h"

#define PAGE RESULT_SEAL_PAGE /* bytes that are kept in memory together */
enum { TOGETHER = 256 };      /* pages that are written at once */

struct result_store {
  char *path, *twin; /* owned */
  hid_t driver;      /* of HDF5, -1 until registered */
  char *lock_path;   /* owned; an empty file, locked as long as the store lives */
  int lock;          /* -1 until we hold it */
  int fd[2];         /* the two files, -1 until opened */
  int front;         /* which of them is at `path` (before the first commit: neither) */
  bool locked;       /* no reader holds the back file */
  haddr_t eoa;       /* end of what HDF5 has allocated */
  haddr_t committed; /* the same at the last commit */

  /* One element for each page of the file, [n_pages], owned. */
  size_t n_pages;
  unsigned char **page; /* contents of a page that a file lacks, else NULL; owned */
  bool *fresh;          /* it changed since the last commit (else: only the back file lacks it) */
  uint64_t *sum;        /* checksum at the last commit */
};

/* ---- memory ---- */

static enum status reserve_pages(struct result_store *s, haddr_t end) {
  size_t n = (size_t)(end / PAGE + 1);
  if (n <= s->n_pages) return OK;
  n += n / 2 + 64;
  TRY(array_resize(&s->page, n, "pages of a result"));
  TRY(array_resize(&s->fresh, n, "pages of a result"));
  TRY(array_resize(&s->sum, n, "pages of a result"));
  memset(s->page + s->n_pages, 0, (n - s->n_pages) * sizeof *s->page);
  memset(s->fresh + s->n_pages, 0, (n - s->n_pages) * sizeof *s->fresh);
  memset(s->sum + s->n_pages, 0, (n - s->n_pages) * sizeof *s->sum);
  s->n_pages = n;
  return OK;
}

/* The committed bytes from `at`; zeros beyond their end. */
static enum status read_committed(const struct result_store *s, haddr_t at, size_t n,
                                  unsigned char *to) {
  size_t there = at >= s->committed ? 0 : s->committed - at < n ? (size_t)(s->committed - at) : n;
  memset(to + there, 0, n - there);
  for (size_t done = 0; done < there;) {
    ssize_t got = pread(s->fd[s->front], to + done, there - done, (off_t)(at + done));
    if (got < 0 && errno == EINTR) continue;
    CHECK(got > 0, ERR_IO, "cannot read back %s: %s", s->path,
          got ? strerror(errno) : "it has become shorter");
    done += (size_t)got;
  }
  return OK;
}

/* Brings page k into memory to be changed; the next two commits write it, one into each file. */
static enum status page_need(struct result_store *s, size_t k) {
  s->fresh[k] = true;
  if (s->page[k]) return OK;
  unsigned char *page = malloc(PAGE);
  CHECK(page, ERR_MEMORY, "no memory for a page of %s", s->path);
  enum status status = read_committed(s, (haddr_t)k * PAGE, PAGE, page);
  if (status == OK)
    s->page[k] = page;
  else
    free(page);
  return status;
}

static enum status store_write(void *store, haddr_t at, size_t n, const unsigned char *from) {
  struct result_store *s = store;
  TRY(reserve_pages(s, at + n));
  for (size_t done = 0; done < n;) {
    size_t k = (size_t)((at + done) / PAGE), offset = (size_t)((at + done) % PAGE);
    size_t part = PAGE - offset < n - done ? PAGE - offset : n - done;
    TRY(page_need(s, k));
    memcpy(s->page[k] + offset, from + done, part);
    done += part;
  }
  return OK;
}

static enum status store_read(void *store, haddr_t at, size_t n, unsigned char *to) {
  const struct result_store *s = store;
  for (size_t done = 0; done < n;) {
    size_t k = (size_t)((at + done) / PAGE), offset = (size_t)((at + done) % PAGE);
    size_t part = PAGE - offset < n - done ? PAGE - offset : n - done;
    if (k < s->n_pages && s->page[k])
      memcpy(to + done, s->page[k] + offset, part);
    else
      TRY(read_committed(s, at + done, part, to + done));
    done += part;
  }
  return OK;
}

enum status result_store_open(struct result_store *s, hid_t *file) {
  struct result_driver driver = {s, &s->eoa, &s->eoa, store_read, store_write};
  hid_t fapl = H5Pcreate(H5P_FILE_ACCESS);
  *file = -1;
  /* kept until the file is closed: HDF5 1.10 reads a driver once more after it has given it up */
  s->driver = result_driver_set(fapl, &driver);
  /* the format of 2008: checksummed headers, and every HDF5 program since can read it */
  if (s->driver >= 0 && H5Pset_libver_bounds(fapl, H5F_LIBVER_V18, H5F_LIBVER_V18) >= 0)
    *file = H5Fcreate(s->path, H5F_ACC_TRUNC, H5P_DEFAULT, fapl);
  H5Pclose(fapl);
  return *file >= 0 ? OK : hdf_raise(ERR_IO, "cannot create %s", s->path);
}

/* ---- committing ---- */

enum status result_store_room(const char *path, unsigned long long bytes, unsigned long long size) {
  struct rlimit limit;
  CHECK(getrlimit(RLIMIT_FSIZE, &limit) || limit.rlim_cur == RLIM_INFINITY ||
            size <= limit.rlim_cur,
        ERR_IO,
        "cannot write %s: it needs %.4g MB and files may have %.4g MB here; raise the limit "
        "(ulimit -f)",
        path, 1e-6 * (double)size, 1e-6 * (double)limit.rlim_cur);
  char *copy = strdup(path);
  struct statvfs disk;
  bool known = copy && !statvfs(dirname(copy), &disk);
  free(copy);
  if (!known) return OK; /* the write itself will tell */
  unsigned long long free_bytes = (unsigned long long)disk.f_bavail * disk.f_frsize;
  CHECK(bytes <= free_bytes, ERR_IO,
        "no room on the disk for %s: it needs %.4g MB more and %.4g MB "
        "are free; make room or write elsewhere (--out)",
        path, 1e-6 * (double)bytes, 1e-6 * (double)free_bytes);
  return OK;
}

static enum status write_at(const struct result_store *s, int fd, haddr_t at, size_t n,
                            const void *from) {
  for (size_t done = 0; done < n;) {
    ssize_t put = pwrite(fd, (const char *)from + done, n - done, (off_t)(at + done));
    if (put < 0 && errno == EINTR) continue;
    CHECK(put > 0, ERR_IO, "cannot write %s: %s", s->path, strerror(put ? errno : ENOSPC));
    done += (size_t)put;
  }
  return OK;
}

/* Bytes of a page: the last may be shorter. */
static size_t page_size(const struct result_store *s, size_t k) {
  return s->eoa - k * PAGE < PAGE ? (size_t)(s->eoa - k * PAGE) : PAGE;
}

static enum status open_twin(struct result_store *s, int i) {
  s->fd[i] = file_open(s->twin, O_RDWR | O_CREAT | O_NOFOLLOW);
  CHECK(s->fd[i] >= 0, ERR_IO, "cannot write beside %s: %s", s->path, strerror(errno));
  return OK;
}

/* Locks the back file. False when somebody has it open and locked, as HDF5 does for reading. */
static bool lock_back(struct result_store *s) {
  if (!s->locked) s->locked = !flock(s->fd[!s->front], LOCK_EX | LOCK_NB) || errno != EWOULDBLOCK;
  return s->locked;
}

/* Claims the disk space of a file, so that running out of it shows before anything changed. File
 * systems that cannot do this are trusted to tell at the write. */
static enum status claim(const struct result_store *s, int fd, haddr_t size) {
  struct stat now;
  if (fstat(fd, &now) || (haddr_t)now.st_size >= size) return OK;
  unsigned long long more = size - (haddr_t)now.st_size;
  TRY(result_store_room(s->path, more, size));
  int failed = fallocate(fd, FALLOC_FL_KEEP_SIZE, now.st_size, (off_t)more);
  CHECK(!failed || (errno != ENOSPC && errno != EDQUOT), ERR_IO,
        "no room on the disk for %s: it needs %.4g MB more; make room or write elsewhere (--out)",
        s->path, 1e-6 * (double)more);
  return OK;
}

static void drop_back(struct result_store *s) {
  int back = !s->front;
  if (s->fd[back] < 0) return;
  unlink(s->twin);
  close(s->fd[back]);
  s->fd[back] = -1;
  s->locked = false;
}

static enum status copy_front(struct result_store *s, haddr_t size) {
  int back = !s->front;
  CHECK(!ftruncate(s->fd[back], 0), ERR_IO, "cannot write %s: %s", s->path, strerror(errno));
  TRY(claim(s, s->fd[back], size));
  for (haddr_t at = 0; at < s->committed; at += PAGE) {
    unsigned char page[PAGE];
    TRY(read_committed(s, at, PAGE, page));
    TRY(write_at(s, s->fd[back], at, PAGE, page));
  }
  (void)lock_back(s);
  return OK;
}

/* Puts a copy of the front in the place of the back file: whoever still reads that keeps it. */
static enum status replace_back(struct result_store *s, haddr_t size) {
  drop_back(s);
  TRY(open_twin(s, !s->front));
  enum status status = copy_front(s, size);
  if (status != OK) drop_back(s);
  return status;
}

/* Writes n pages in memory that follow each other in the file, at once where that goes. */
static enum status write_pages(const struct result_store *s, int fd, size_t first, size_t n) {
  struct iovec part[TOGETHER];
  for (size_t i = 0; i < n; i++)
    part[i] = (struct iovec){s->page[first + i], page_size(s, first + i)};
  ssize_t put = pwritev(fd, part, (int)n, (off_t)first * PAGE);
  for (size_t i = put < 0 ? 0 : (size_t)put / PAGE; i < n; i++) /* what is left, or why */
    TRY(write_at(s, fd, (haddr_t)(first + i) * PAGE, part[i].iov_len, s->page[first + i]));
  return OK;
}

/* Makes the back file equal to the present state. */
static enum status write_back(const struct result_store *s, const struct result_seal *seal) {
  int fd = s->fd[!s->front];
  size_t pages = (size_t)((s->eoa + PAGE - 1) / PAGE);
  for (size_t k = 0, n; k < pages; k += n + !n) {
    for (n = 0; k + n < pages && n < TOGETHER && s->page[k + n];) n++;
    if (n) TRY(write_pages(s, fd, k, n));
  }
  TRY(write_at(s, fd, s->eoa, sizeof *seal, seal));
  CHECK(!ftruncate(fd, (off_t)(s->eoa + sizeof *seal)), ERR_IO, "cannot write %s: %s", s->path,
        strerror(errno));
  return OK;
}

/* Gives the back file the name `path`, and the front file the twin's. */
static enum status change_names(const struct result_store *s) {
  int failed;
  if (s->fd[s->front] < 0) {
    failed = rename(s->twin, s->path);
  } else {
    failed = renameat2(AT_FDCWD, s->twin, AT_FDCWD, s->path, RENAME_EXCHANGE);
    if (failed && (errno == EINVAL || errno == ENOSYS)) { /* not on this file system */
      char spare[strlen(s->twin) + 2];
      sprintf(spare, "%s~", s->twin);
      unlink(spare);
      failed = link(s->path, spare) || rename(s->twin, s->path);
      if (!failed) rename(spare, s->twin); /* if not, the next commit says so */
    }
  }
  CHECK(!failed, ERR_IO, "cannot write %s: %s", s->path, strerror(errno));
  return OK;
}

static enum status update_sums(struct result_store *s, uint64_t *sum) {
  TRY(reserve_pages(s, s->eoa));
  if (s->committed) TRY(page_need(s, (size_t)(s->committed / PAGE))); /* holds the old seal */
  TRY(page_need(s, (size_t)(s->eoa / PAGE)));                         /* perhaps cut shorter */
  size_t pages = (size_t)((s->eoa + PAGE - 1) / PAGE);
  uint64_t total = 0;
  for (size_t k = 0; k < pages; k++)
    if (!s->page[k] && k * PAGE >= s->committed) TRY(page_need(s, k)); /* a gap: zeros */
#pragma omp parallel for schedule(static) reduction(+ : total)
  for (size_t k = 0; k < pages; k++) {
    if (s->page[k] && s->fresh[k]) s->sum[k] = result_seal_page(s->page[k], page_size(s, k), k);
    total += s->sum[k];
  }
  *sum = total;
  return OK;
}

/* What the old back file lacked is now in both; what it got first, the new one lacks. */
static void age_pages(struct result_store *s) {
  for (size_t k = 0; k < s->n_pages; k++) {
    if (!s->fresh[k]) {
      free(s->page[k]);
      s->page[k] = NULL;
    }
    s->fresh[k] = false;
  }
}

enum status result_store_commit(struct result_store *s, bool last) {
  uint64_t sum;
  TRY(update_sums(s, &sum));
  struct result_seal seal = result_seal_make(s->eoa, sum);
  haddr_t size = s->eoa + sizeof seal;
  int back = !s->front;
  if (s->fd[back] < 0 || !lock_back(s)) TRY(replace_back(s, size));
  TRY(claim(s, s->fd[back], size));
  TRY(write_back(s, &seal));
  if (last) fdatasync(s->fd[back]); /* a finished result outlives a power failure as well */
  flock(s->fd[back], LOCK_UN);      /* before anybody can find it */
  s->locked = false;
  TRY(change_names(s));
  s->front = back;
  s->committed = s->eoa;
  age_pages(s);
  if (s->fd[!back] >= 0) (void)lock_back(s); /* if it is being read, the next commit sees to it */
  return OK;
}

/* ---- life ---- */

/* ".NAME.SUFFIX" in the same folder; NULL without memory. */
static char *hidden_path(const char *path, const char *suffix) {
  const char *slash = strrchr(path, '/');
  int folder = slash ? (int)(slash - path) + 1 : 0;
  char *hidden;
  int n = asprintf(&hidden, "%.*s.%s.%s", folder, path, path + folder, suffix);
  return n < 0 ? NULL : hidden;
}

bool result_store_is_written(const char *path) {
  char *lock = hidden_path(path, "lock");
  int fd = lock ? file_open(lock, O_RDONLY | O_NOFOLLOW | O_NONBLOCK) : -1;
  bool written = fd >= 0 && flock(fd, LOCK_SH | LOCK_NB) && errno == EWOULDBLOCK;
  if (fd >= 0) close(fd);
  free(lock);
  return written;
}

static bool is_at(int fd, const char *path) {
  struct stat mine, there;
  return !fstat(fd, &mine) && !lstat(path, &there) && mine.st_dev == there.st_dev &&
         mine.st_ino == there.st_ino;
}

/* Keeps other runs out. The two data files cannot do it: they change their names, and a reader may
 * hold either. */
static enum status lock_take(struct result_store *s) {
  for (;;) {
    s->lock = file_open(s->lock_path, O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK);
    CHECK(s->lock >= 0, ERR_IO, "cannot write beside %s: %s%s", s->path, strerror(errno),
          errno == ENOENT ? " (create the directory first)" : "");
    if (flock(s->lock, LOCK_EX | LOCK_NB) && errno == EWOULDBLOCK) {
      close(s->lock);
      s->lock = -1; /* not ours to remove */
      return status_raise(ERR_IO, "another run is writing %s", s->path);
    }
    if (is_at(s->lock, s->lock_path)) return OK;
    close(s->lock); /* the run before us removed it just now */
  }
}

/* The first back file; one that a killed run left is used again, unless somebody reads it. */
static enum status open_first(struct result_store *s) {
  TRY(open_twin(s, 0));
  if (!lock_back(s)) {
    drop_back(s);
    TRY(open_twin(s, 0));
    (void)lock_back(s);
  }
  CHECK(!ftruncate(s->fd[0], 0), ERR_IO, "cannot write %s: %s", s->path, strerror(errno));
  return OK;
}

enum status result_store_create(const char *path, struct result_store **out) {
  struct result_store *s = calloc(1, sizeof *s);
  *out = NULL;
  CHECK(s, ERR_MEMORY, "no memory to write %s", path);
  s->driver = -1;
  s->fd[0] = s->fd[1] = s->lock = -1;
  s->front = 1; /* so that the first commit goes into file 0 */
  s->path = strdup(path);
  s->twin = hidden_path(path, "next");
  s->lock_path = hidden_path(path, "lock");
  enum status status = s->path && s->twin && s->lock_path
                           ? OK
                           : status_raise(ERR_MEMORY, "no memory to write %s", path);
  if (status == OK) status = lock_take(s);
  if (status == OK) status = open_first(s);
  if (status != OK) {
    result_store_destroy(s);
    return status;
  }
  *out = s;
  return OK;
}

void result_store_destroy(struct result_store *s) {
  if (!s) return;
  if (s->driver >= 0) H5FDunregister(s->driver);
  if (s->twin && (s->fd[0] >= 0 || s->fd[1] >= 0)) unlink(s->twin);
  for (int i = 0; i < 2; i++)
    if (s->fd[i] >= 0) close(s->fd[i]);
  if (s->lock >= 0) {
    unlink(s->lock_path);
    close(s->lock);
  }
  for (size_t k = 0; k < s->n_pages; k++) free(s->page[k]);
  free(s->page);
  free(s->fresh);
  free(s->sum);
  free(s->path);
  free(s->twin);
  free(s->lock_path);
  free(s);
}
