/* Files and folders that were made to harm: a right seal on wrong bytes, results that lead into
 * other files, links where a run writes. */
#include <fcntl.h>
#include <hdf5.h>
#include <omp.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/result/result_carry.h"
#include "common/result/result_diff.h"
#include "tests/common/result_bytes.h"
#include "tests/common/result_sample.h"
#include "tests/test.h"

static char path[160], other[160];
static unsigned char *content;
static size_t size;

static void write_result(void) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  for (size_t k = 0; w && k < 5; k++) EXPECT_OK(sample_output(w, k, 40));
  if (w) EXPECT_OK(result_finish(w));
  result_destroy(w);
  sample_case_destroy(c);
}

static void load(void) {
  write_result();
  FILE *f = fopen(path, "rb");
  fseek(f, 0, SEEK_END);
  size = (size_t)ftell(f);
  rewind(f);
  content = malloc(size);
  EXPECT(fread(content, 1, size, f) == size);
  fclose(f);
}

static void store(const unsigned char *bytes) {
  FILE *f = fopen(path, "wb");
  EXPECT(f && fwrite(bytes, 1, size, f) == size);
  if (f) fclose(f);
}

static void expect_refused(const char *says) {
  struct result_file *f = NULL;
  FILE *nowhere = fopen("/dev/null", "w");
  struct result_tolerances t;
  EXPECT(result_read(path, &f) == ERR_INPUT && !f);
  if (!strstr(status_message(), says)) TEST_FAIL("the message is: %s", status_message());
  EXPECT(result_info(path, nowhere) == ERR_INPUT);
  EXPECT(!result_is_current(path, "x"));
  EXPECT_OK(result_tolerances_default(&t, 0, 0));
  for (int k = 0; k < 2; k++) { /* whichever of the two it is, it is blamed */
    struct result_diff *d;
    EXPECT(result_diff_create(k ? other : path, k ? path : other, &t, 4, &d) == ERR_INPUT && !d);
    if (!strstr(status_message(), says) || strncmp(status_message(), path, strlen(path)))
      TEST_FAIL("the message is: %s", status_message());
  }
  result_tolerances_destroy(&t);
  fclose(nowhere);
}

/* ---- bytes that HDF5 trusts ---- */

static unsigned char *find(unsigned char *from, size_t n, const void *what, size_t length) {
  return memmem(from, n, what, length);
}

/* Texts lie in a heap, and a dataset says how long they are and where. One byte of that asks for
 * 4 GB; the seal is put right again. */
static void test_a_texts_length_takes_no_memory(void) {
  load();
  static const char text[] = "title: sample\nfluid: {density: 1000}\n";
  unsigned char *at = find(content, size, text, sizeof text - 1), *heap = at;
  while (heap && heap > content && memcmp(heap, "GCOL", 4)) heap--;
  EXPECT(heap && heap > content);
  unsigned char reference[16] = {0}; /* length, where the heap is, which of its objects */
  uint32_t length = sizeof text;
  uint64_t address = (uint64_t)(heap - content);
  memcpy(reference + 4, &address, sizeof address);
  if (at) memcpy(reference + 12, at - 16, 2); /* each object begins with its number */
  unsigned char *place = NULL;                /* HDF5 counts the zero behind the text or not */
  for (; !place && length >= sizeof text - 1; length--) {
    memcpy(reference, &length, sizeof length);
    place = find(content, size, reference, sizeof reference);
  }
  EXPECT(place);
  if (place) place[3] = 0xff;
  bytes_seal(content, size);
  store(content);
#ifdef __SANITIZE_ADDRESS__
  expect_refused("is damaged"); /* the sanitizer ends what asks for too much */
#else
  expect_refused("is damaged: reading it takes more than 2");
#endif
  struct rusage children;
  getrusage(RUSAGE_CHILDREN, &children);
  EXPECT(children.ru_maxrss < 600 * 1024); /* KB; it was 7.4 GB */
  free(content);
}

/* Random bytes in HDF5's own structures (the first pages hold most of them) under a right seal. */
static void test_sealed_nonsense_does_no_harm(void) {
  load();
  unsigned char *wrong = malloc(size);
  srand(3);
  int refused = 0;
  for (int i = 0; i < 120; i++) {
    memcpy(wrong, content, size);
    for (int k = 0; k < 8; k++)
      wrong[(size_t)rand() % (i < 60 ? 4096 : size - 32)] = (unsigned char)rand();
    bytes_seal(wrong, size);
    store(wrong);
    struct result_file *f = NULL;
    enum status status = result_read(path, &f);
    EXPECT(status == OK || (status == ERR_INPUT && *status_message()));
    refused += status != OK;
    result_file_destroy(f);
  }
  EXPECT(refused > 10); /* the seal did let them through to HDF5 */
  free(wrong);
  free(content);
}

/* ---- results that lead elsewhere ---- */

static void link_away(hid_t file) {
  H5Ldelete(file, "case", H5P_DEFAULT);
  EXPECT(H5Lcreate_external(other, "case", file, "case", H5P_DEFAULT, H5P_DEFAULT) >= 0);
}

/* A text that is the content of any other file. */
static void store_away(hid_t file) {
  hid_t plist = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate(H5S_SCALAR);
  hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, 64);
  H5Pset_external(plist, "/etc/passwd", 0, 64);
  H5Ldelete(file, "case", H5P_DEFAULT);
  hid_t set = H5Dcreate2(file, "case", type, space, H5P_DEFAULT, plist, H5P_DEFAULT);
  EXPECT(set >= 0);
  H5Dclose(set);
  H5Tclose(type);
  H5Sclose(space);
  H5Pclose(plist);
}

static void make_virtual(hid_t file) {
  hsize_t n = 5;
  hid_t plist = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(1, &n, NULL);
  H5Pset_virtual(plist, space, other, "/surface/time", space);
  H5Ldelete(file, "surface/time", H5P_DEFAULT);
  hid_t set =
      H5Dcreate2(file, "surface/time", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, plist, H5P_DEFAULT);
  EXPECT(set >= 0);
  H5Dclose(set);
  H5Sclose(space);
  H5Pclose(plist);
}

/* Through a link within the file that ends in one out of it. */
static void link_softly(hid_t file) {
  H5Ldelete(file, "case", H5P_DEFAULT);
  EXPECT(H5Lcreate_external(other, "/", file, "elsewhere", H5P_DEFAULT, H5P_DEFAULT) >= 0);
  EXPECT(H5Lcreate_soft("/elsewhere/case", file, "case", H5P_DEFAULT, H5P_DEFAULT) >= 0);
}

static void test_nothing_outside_the_file_is_read(void) {
  static const struct {
    void (*spoil)(hid_t file);
    const char *says;
  } ways[] = {
      {link_away, "its /case is a link into another file, which is not followed"},
      {store_away, "its /case is kept in another file, which is not followed"},
      {make_virtual, "its /surface/time is made of other datasets, which are not followed"},
      {link_softly, "its /elsewhere is a link into another file, which is not followed"},
  };
  for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
    write_result();
    hid_t file = H5Fopen(path, H5F_ACC_RDWR, H5P_DEFAULT);
    ways[i].spoil(file);
    H5Fclose(file);
    expect_refused(ways[i].says);
  }
}

static void test_a_fifo_is_not_waited_for(void) {
  unlink(path);
  EXPECT(!mkfifo(path, 0666));
  alarm(30); /* ends the test where it waits */
  expect_refused(" is not a file");
  alarm(0);
  unlink(path);
}

/* The run that wrote it has given it up meanwhile: what was opened is read to the end. */
static void test_a_file_without_a_name_is_read(void) {
  char opened[64];
  write_result();
  int fd = open(path, O_RDONLY | O_CLOEXEC);
  struct result_file *f = NULL;
  unlink(path);
  snprintf(opened, sizeof opened, "/proc/self/fd/%d", fd);
  EXPECT_OK(result_read(opened, &f));
  EXPECT(f && f->n_outputs == 5);
  result_file_destroy(f);
  close(fd);
}

/* What a child says is not believed either: a text that everybody prints cannot be left out. */
static void test_an_answer_without_a_text_is_refused(void) {
  static struct carrier c;
  struct result_file *f = NULL;
  write_result();
  EXPECT_OK(result_read(path, &f));
  c = (struct carrier){.pipe = open("/dev/null", O_WRONLY | O_CLOEXEC), .sending = true};
  EXPECT_OK(result_carry(&c, f));
  free(f->gauges[0].units);
  f->gauges[0].units = NULL;
  EXPECT(result_carry(&c, f) == ERR_INPUT);
  close(c.pipe);
  result_file_destroy(f);
}

/* ---- links where a run writes ---- */

static void write_text(const char *to, const char *text) {
  FILE *f = fopen(to, "w");
  EXPECT(f && fputs(text, f) >= 0);
  if (f) fclose(f);
}

static void expect_text(const char *in, const char *text) {
  char found[64] = "";
  FILE *f = fopen(in, "r");
  if (f) found[fread(found, 1, sizeof found - 1, f)] = 0;
  if (f) fclose(f);
  EXPECT_STR(found, text);
}

static void test_links_are_not_followed(void) {
  static const char *const names[] = {".sample.h5.next", ".sample.h5.lock", ".sample.xdmf.next",
                                      "sample.xdmf", "sample.h5"};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    char victim[200], link[200];
    snprintf(victim, sizeof victim, "%s/victim", sample_folder());
    snprintf(link, sizeof link, "%s/%s", sample_folder(), names[i]);
    write_text(victim, "precious");
    unlink(link);
    EXPECT(!symlink(victim, link));
    struct case_file *c = sample_case();
    struct result *w = NULL;
    enum status status = result_create(path, c, &c->runs[0], &w);
    if (status == OK) EXPECT_OK(sample_output(w, 0, 30));
    if (status == OK) EXPECT_OK(result_finish(w));
    result_destroy(w);
    sample_case_destroy(c);
    EXPECT(status == OK || (status == ERR_IO && strstr(status_message(), path)));
    EXPECT((status == OK) == (i > 1));
    expect_text(victim, "precious");
    unlink(link);
  }
}

/* A program that was started without its standard streams prints into nothing of ours. */
static void test_closed_streams_do_not_spoil_a_result(void) {
  pid_t child = fork();
  if (!child) {
    omp_set_num_threads(1); /* OpenMP's other threads have stayed in the parent */
    for (int fd = 0; fd < 3; fd++) close(fd);
    struct case_file *c = sample_case();
    struct result *w = NULL;
    enum status status = result_create(path, c, &c->runs[0], &w);
    for (size_t k = 0; k < 3 && status == OK; k++) {
      status = sample_output(w, k, 40);
      for (int fd = 0; fd < 3; fd++)
        if (write(fd, "talk", 4) > 0) _exit(2); /* into whatever has that number */
    }
    if (status == OK) status = result_finish(w);
    result_destroy(w);
    struct result_file *f = NULL; /* and reading works as well */
    if (status == OK) status = result_read(path, &f);
    _exit(status != OK || f->n_outputs != 3);
  }
  int outcome = 1;
  EXPECT(child > 0 && waitpid(child, &outcome, 0) == child && outcome == 0);
  struct result_file *f = NULL;
  EXPECT_OK(result_read(path, &f));
  EXPECT(f && f->n_outputs == 3 && f->complete);
  result_file_destroy(f);
}

int main(void) {
  snprintf(path, sizeof path, "%s/other.h5", sample_folder());
  write_result();
  strcpy(other, path);
  snprintf(path, sizeof path, "%s/sample.h5", sample_folder());
  RUN(test_a_texts_length_takes_no_memory);
  RUN(test_sealed_nonsense_does_no_harm);
  RUN(test_nothing_outside_the_file_is_read);
  RUN(test_a_fifo_is_not_waited_for);
  RUN(test_a_file_without_a_name_is_read);
  RUN(test_an_answer_without_a_text_is_refused);
  RUN(test_links_are_not_followed);
  RUN(test_closed_streams_do_not_spoil_a_result);
  sample_folder_remove();
  return TEST_RESULT;
}
