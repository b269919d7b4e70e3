/* What was flushed survives: a kill at any moment, a full disk, a limit on file sizes. And a file
 * that is not as it was written is refused in one sentence, whatever its bytes are. */
#include <errno.h>
#include <fcntl.h>
#include <hdf5.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "tests/common/result_sample.h"
#include "tests/common/result_water.h"
#include "tests/test.h"

static char path[160];

static void pause_for(double seconds) {
  struct timespec t = {(time_t)seconds, (long)(1e9 * (seconds - floor(seconds)))};
  nanosleep(&t, NULL);
}

/* Writes outputs for ever, and after each flush says so through the pipe. */
static void write_until_killed(int to) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  if (result_create(path, c, &c->runs[0], &w) != OK) _exit(1);
  for (unsigned k = 0;; k++) {
    if (sample_output(w, k, 600) != OK) _exit(1);
    if (write(to, &k, sizeof k) != sizeof k) _exit(1);
  }
}

/* Kills a writer some time after its output of that number was flushed; returns the last such
 * number. */
static int kill_a_writer(int outputs, double after) {
  int ends[2], last = -1;
  unsigned k;
  if (pipe(ends)) return -1;
  fflush(NULL);
  pid_t child = fork();
  if (child < 0) return -1;
  if (!child) write_until_killed(ends[1]);
  close(ends[1]);
  while (last < outputs && read(ends[0], &k, sizeof k) == sizeof k) last = (int)k;
  pause_for(after);
  kill(child, SIGKILL);
  waitpid(child, NULL, 0);
  while (read(ends[0], &k, sizeof k) == sizeof k) last = (int)k;
  close(ends[0]);
  return last;
}

/* The writer does nothing but append and flush, so most kills fall into a flush. */
static void test_every_flushed_output_survives_a_kill(void) {
  srand(2385);
  for (int i = 0; i < 30; i++) {
    int flushed = kill_a_writer(i % 6, 0.2 * rand() / RAND_MAX);
    struct result_file *f = NULL;
    EXPECT(flushed >= i % 6);
    EXPECT_OK(result_read(path, &f));
    if (!f) return;
    size_t n = f->n_outputs;
    EXPECT(!f->complete && n > (size_t)flushed && n <= (size_t)flushed + 2);
    EXPECT(f->n_surfaces == n && f->n_energy == 10 * n && f->n_events == n &&
           f->probes[0].n == 10 * n);
    for (size_t k = n < 3 ? 0 : n - 3; k < n; k++) {
      struct result_water water;
      EXPECT_OK(water_read(path, "pressure", false, k, &water));
      EXPECT(water.n == sample_n(k, 600) && water.p &&
             water.p[water.n - 1][0] == sample_x(k, water.n - 1));
      result_water_free(&water);
    }
    result_file_destroy(f);
  }
}

/* Writes outputs until one fails; the failure must be ERR_IO and name what is missing. */
static void fill_up(const char *needed) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  struct result_file *f = NULL;
  enum status status = result_create(path, c, &c->runs[0], &w);
  size_t k = 0;
  EXPECT_OK(status);
  while (status == OK && k < 1000 && (status = sample_output(w, k, 600)) == OK) k++;
  EXPECT(status == ERR_IO);
  if (!strstr(status_message(), needed)) TEST_FAIL("the message is: %s", status_message());
  EXPECT(k > 3);
  result_destroy(w);
  EXPECT_OK(result_read(path, &f));
  /* when it was the .xdmf that found no room, the last output is there as well */
  EXPECT(f && f->n_outputs >= k && f->n_outputs <= k + 1 && !f->complete);
  EXPECT(f && f->n_surfaces == f->n_outputs && f->n_energy == 10 * f->n_outputs);
  result_file_destroy(f);
  sample_case_destroy(c);
}

static void test_limit_on_file_size_keeps_earlier_outputs(void) {
  struct rlimit before, limit;
  getrlimit(RLIMIT_FSIZE, &before);
  limit = before;
  limit.rlim_cur = 600000;
  setrlimit(RLIMIT_FSIZE, &limit);
  fill_up("files may have 0.6 MB here");
  setrlimit(RLIMIT_FSIZE, &before);
}

/* Needs the right to mount a small file system; says so where it cannot run. */
static void test_full_disk_keeps_earlier_outputs(void) {
  char old[sizeof path], disk[128];
  strcpy(old, path);
  snprintf(disk, sizeof disk, "%s/disk", sample_folder());
  mkdir(disk, 0755);
  if (mount("none", disk, "tmpfs", 0, "size=1500k")) {
    printf("skip a full disk: cannot mount one (%s)\n", strerror(errno));
    return;
  }
  snprintf(path, sizeof path, "%s/sample.h5", disk);
  fill_up("no room on the disk for ");
  strcpy(path, old);
  if (umount(disk)) perror(disk);
}

static void test_places_that_cannot_be_written_are_named(void) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  EXPECT(result_create("/nonexistent/place/a.h5", c, &c->runs[0], &w) == ERR_IO && !w);
  EXPECT_STR(status_message(),
             "cannot write beside /nonexistent/place/a.h5: No such file or directory "
             "(create the directory first)");
  EXPECT(result_create("/proc/a.h5", c, &c->runs[0], &w) == ERR_IO && !w);
  EXPECT(result_create(sample_folder(), c, &c->runs[0], &w) == ERR_IO && !w); /* a directory */
  sample_case_destroy(c);
}

/* ---- damaged files ---- */

static char *content;
static size_t size;

static void write_sample(void) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  for (size_t k = 0; k < 5; k++) EXPECT_OK(sample_output(w, k, 40));
  EXPECT_OK(result_finish(w));
  result_destroy(w);
  sample_case_destroy(c);
  FILE *f = fopen(path, "rb");
  fseek(f, 0, SEEK_END);
  size = (size_t)ftell(f);
  rewind(f);
  content = malloc(size);
  EXPECT(fread(content, 1, size, f) == size);
  fclose(f);
}

static void write_bytes(const char *to, const char *bytes, size_t n) {
  FILE *f = fopen(to, "wb");
  EXPECT(f && fwrite(bytes, 1, n, f) == n);
  if (f) fclose(f);
}

/* Refused with one line, or read as what was written (a change of the seal's own name does no
 * harm). */
static void expect_refused(const char *what, size_t at, bool may_be_read) {
  struct result_file *f = NULL;
  enum status status = result_read(path, &f);
  if (status == OK && !may_be_read) TEST_FAIL("%s at %zu: was read", what, at);
  if (status == OK && f->n_outputs != 5)
    TEST_FAIL("%s at %zu: %zu outputs", what, at, f->n_outputs);
  if (status != OK && status != ERR_INPUT) TEST_FAIL("%s at %zu: status %d", what, at, status);
  if (status != OK && (!*status_message() || strchr(status_message(), '\n')))
    TEST_FAIL("%s at %zu: message '%s'", what, at, status_message());
  result_file_destroy(f);
}

static void test_truncated_files_are_refused(void) {
  for (int i = 0; i < 200; i++) {
    size_t n = i < 40 ? (size_t)i * 3 : size - 1 - (size_t)(i - 40) * (size - 2) / 160;
    write_bytes(path, content, n);
    expect_refused("truncation", n, size - n < 33);
  }
}

static void put_byte(FILE *f, size_t at, int byte) {
  EXPECT(!fseek(f, (long)at, SEEK_SET) && fputc(byte, f) != EOF && !fflush(f));
}

static void test_flipped_bits_are_refused(void) {
  write_bytes(path, content, size);
  FILE *f = fopen(path, "r+b");
  srand(1);
  for (int i = 0; f && i < 800; i++) {
    size_t at = i < 64 ? size - 1 - (size_t)i : (size_t)rand() % size;
    put_byte(f, at, content[at] ^ 1 << rand() % 8);
    expect_refused("flip", at, at >= size - 32);
    put_byte(f, at, content[at]);
  }
  if (f) fclose(f);
}

/* Without its seal the file meets HDF5 itself, which may crash or read values that nobody can tell
 * from good ones; the program must still either read it or say one sentence. */
static void test_damage_without_a_seal_never_crashes(void) {
  size -= 32;
  write_bytes(path, content, size);
  FILE *f = fopen(path, "r+b");
  srand(2);
  for (int i = 0; f && i < 80; i++) {
    struct result_file *r = NULL;
    size_t at[8];
    for (int k = 0; k < 8; k++)
      put_byte(f, at[k] = (size_t)rand() % (i < 40 ? 4096 : size), rand() & 255);
    enum status status = result_read(path, &r);
    EXPECT(status == OK || (status == ERR_INPUT && *status_message()));
    result_file_destroy(r);
    for (int k = 0; k < 8; k++) put_byte(f, at[k], content[at[k]]);
  }
  if (f) fclose(f);
}

/* ---- files that are something else ---- */

static void expect_message(const char *file, const char *message) {
  struct result_file *f = NULL;
  EXPECT(result_read(file, &f) == ERR_INPUT && !f);
  EXPECT_STR(status_message(), message);
}

static void test_other_files_are_named_for_what_they_are(void) {
  char message[400], other[200];
  snprintf(other, sizeof other, "%s/other", sample_folder());
  expect_message("/nonexistent.h5", "cannot read /nonexistent.h5: No such file or directory");
  snprintf(message, sizeof message, "%s is a directory, not a result file", sample_folder());
  expect_message(sample_folder(), message);
  write_bytes(other, "", 0);
  snprintf(message, sizeof message, "%s is empty", other);
  expect_message(other, message);
  write_bytes(other, "title: not a result\n", 20);
  snprintf(message, sizeof message, "%s is not a result file: it is not HDF5", other);
  expect_message(other, message);
}

/* ---- readers while a run goes on ---- */

/* Reads a dataset of an open file; its sum. */
static double sum_of(hid_t file, const char *name) {
  hid_t set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
  size_t n = (size_t)H5Sget_simple_extent_npoints(space);
  double *value = malloc(n * sizeof *value), sum = 0;
  EXPECT(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, value) >= 0);
  for (size_t i = 0; i < n; i++) sum += value[i];
  free(value);
  H5Sclose(space);
  H5Dclose(set);
  return sum;
}

/* Whoever opened the file keeps the state that was there, however long and whatever is written. */
static void test_a_reader_keeps_what_it_opened(void) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  for (size_t k = 0; k < 4; k++) EXPECT_OK(sample_output(w, k, 3000));
  hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
  struct result_file *now = NULL;
  EXPECT(file >= 0);
  for (size_t k = 4; k < 12; k++) EXPECT_OK(sample_output(w, k, 3000));
  hid_t again = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
  EXPECT(sum_of(file, "VTKHDF/Steps/Values") < 0.7); /* 0 + 0.1 + 0.2 + 0.3 */
  EXPECT(isfinite(sum_of(file, "VTKHDF/Points")));
  EXPECT(sum_of(again, "VTKHDF/Steps/Values") > 6.5);
  H5Fclose(again);
  H5Fclose(file);
  EXPECT_OK(result_read(path, &now));
  EXPECT(now && now->n_outputs == 12);
  result_file_destroy(now);
  EXPECT_OK(result_finish(w));
  result_destroy(w);
  sample_case_destroy(c);
}

static void test_two_runs_cannot_write_one_file(void) {
  struct case_file *c = sample_case();
  struct result *w = NULL, *other = NULL;
  struct result_file *f = NULL;
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  for (size_t k = 0; k < 3; k++) {
    EXPECT_OK(sample_output(w, k, 30));
    EXPECT(result_create(path, c, &c->runs[0], &other) == ERR_IO && !other);
  }
  EXPECT(strstr(status_message(), "another run is writing "));
  int reader = open(path, O_RDONLY | O_CLOEXEC); /* the next output cannot lock what is read */
  EXPECT(reader >= 0 && !flock(reader, LOCK_SH));
  EXPECT_OK(sample_output(w, 3, 30));
  close(reader);
  EXPECT(result_create(path, c, &c->runs[0], &other) == ERR_IO && !other);
  EXPECT_OK(result_finish(w));
  result_destroy(w);
  EXPECT_OK(result_read(path, &f));
  EXPECT(f && f->complete && f->n_outputs == 4);
  result_file_destroy(f);
  sample_case_destroy(c);
}

/* A file is checked once while it stays as it is; bytes that change later are seen all the same. */
static void test_changes_after_a_check_are_seen(void) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  struct result_file *f = NULL;
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  if (w) EXPECT_OK(sample_output(w, 0, 600));
  if (w) EXPECT_OK(result_finish(w));
  result_destroy(w);
  sample_case_destroy(c);
  pause_for(3.1); /* until it is old enough to be remembered */
  for (int k = 0; k < 2; k++) {
    EXPECT_OK(result_read(path, &f));
    result_file_destroy(f);
  }
  int fd = open(path, O_RDWR);
  unsigned char byte = 0;
  EXPECT(pread(fd, &byte, 1, 5000) == 1);
  byte ^= 64;
  EXPECT(pwrite(fd, &byte, 1, 5000) == 1);
  close(fd);
  EXPECT(result_read(path, &f) == ERR_INPUT);
  EXPECT(strstr(status_message(), "its checksum does not match"));
}

int main(void) {
  snprintf(path, sizeof path, "%s/sample.h5", sample_folder());
  RUN(test_every_flushed_output_survives_a_kill);
  RUN(test_limit_on_file_size_keeps_earlier_outputs);
  RUN(test_full_disk_keeps_earlier_outputs);
  RUN(test_a_reader_keeps_what_it_opened);
  RUN(test_two_runs_cannot_write_one_file);
  RUN(test_places_that_cannot_be_written_are_named);
  write_sample();
  RUN(test_truncated_files_are_refused);
  RUN(test_flipped_bits_are_refused);
  RUN(test_damage_without_a_seal_never_crashes);
  RUN(test_other_files_are_named_for_what_they_are);
  RUN(test_changes_after_a_check_are_seen);
  free(content);
  sample_folder_remove();
  return TEST_RESULT;
}
