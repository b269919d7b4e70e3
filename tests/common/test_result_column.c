/* Whatever pieces rows come in, HDF5 reads the same rows, and any number of threads stores the same
 * bytes. */
#include "common/result/result_column.h"

#include <omp.h>
#include <stdlib.h>

#include "common/result/result_hdf.h"
#include "tests/test.h"

enum { ROWS = 911, CHUNK = 64 };

/* A file in memory only. */
static hid_t file_create(const char *name) {
  hid_t fapl = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_core(fapl, 1 << 16, 0);
  hid_t file = H5Fcreate(name, H5F_ACC_TRUNC, H5P_DEFAULT, fapl);
  H5Pclose(fapl);
  return file;
}

static const char *const names[] = {"scalars", "vectors", "flags", "empty"};
enum { SETS = 4 };

struct rows {
  double scalars[ROWS], vectors[ROWS][3];
  unsigned char flags[ROWS];
};

static void rows_fill(struct rows *r) {
  for (size_t i = 0; i < ROWS; i++) {
    r->scalars[i] = sin(0.1 * (double)i) / 3;
    for (size_t k = 0; k < 3; k++) r->vectors[i][k] = (double)i / (double)(7 + k);
    r->flags[i] = (unsigned char)(i * i / 5);
  }
}

/* The rows in pieces, some empty, some of several chunks, with a flush after every third. */
static hid_t write_rows(const char *name, int threads, const struct rows *r) {
  static const size_t piece[] = {1, 0, CHUNK - 1, CHUNK, 3 * CHUNK + 5, 2, 7 * CHUNK};
  const struct hdf_rows kind[SETS] = {{H5T_NATIVE_DOUBLE, 0, CHUNK},
                                      {H5T_NATIVE_DOUBLE, 3, CHUNK},
                                      {H5T_NATIVE_UCHAR, 0, CHUNK},
                                      {H5T_NATIVE_INT64, 0, CHUNK}};
  struct hdf_columns *c = NULL;
  struct hdf_column *column[SETS];
  hid_t file = file_create(name);
  omp_set_num_threads(threads);
  EXPECT_OK(hdf_columns_create(&c));
  for (int k = 0; k < SETS; k++)
    EXPECT_OK(hdf_column_create(c, file, names[k], &kind[k], "m", "a test", &column[k]));
  for (size_t at = 0, k = 0; at < ROWS; k++) {
    size_t n = piece[k % (sizeof piece / sizeof *piece)];
    if (n > ROWS - at) n = ROWS - at;
    EXPECT_OK(hdf_column_append(column[0], n, r->scalars + at));
    EXPECT_OK(hdf_column_append(column[1], n, r->vectors + at));
    EXPECT_OK(hdf_column_append(column[2], n, r->flags + at));
    at += n;
    EXPECT(hdf_column_length(column[1]) == at);
    if (k % 3 == 0) EXPECT_OK(hdf_columns_flush(c));
  }
  EXPECT_OK(hdf_columns_flush(c));
  EXPECT_OK(hdf_columns_flush(c)); /* nothing is left to do */
  hdf_columns_destroy(c);
  return file;
}

static void test_hdf5_reads_what_was_appended(void) {
  static struct rows r;
  rows_fill(&r);
  hid_t file = write_rows("rows", 2, &r);
  const void *right[SETS] = {r.scalars, r.vectors, r.flags, NULL};
  const hid_t type[SETS] = {H5T_NATIVE_DOUBLE, H5T_NATIVE_DOUBLE, H5T_NATIVE_UCHAR,
                            H5T_NATIVE_INT64};
  for (int k = 0; k < SETS; k++) {
    size_t n = 0, width = k == 1 ? 3 : 0;
    void *read = NULL;
    EXPECT_OK(hdf_get_all(file, names[k], type[k], width, &n, &read));
    EXPECT(n == (k == 3 ? 0 : ROWS));
    EXPECT(!n || !memcmp(read, right[k], n * (width ? width : 1) * H5Tget_size(type[k])));
    free(read);
  }
  H5Fclose(file);
}

/* The stored bytes of chunk `number`; *size is 0 when there is no such chunk. */
static void *chunk_of(hid_t set, size_t number, hsize_t *size) {
  hsize_t at[2] = {number * CHUNK, 0};
  uint32_t skipped = 0;
  *size = 0;
  if (H5Dget_chunk_storage_size(set, at, size) < 0 || !*size) return NULL;
  void *bytes = malloc(*size);
  EXPECT(bytes && H5Dread_chunk(set, H5P_DEFAULT, at, &skipped, bytes) >= 0 && !skipped);
  return bytes;
}

static void test_any_number_of_threads_stores_the_same_bytes(void) {
  static struct rows r;
  rows_fill(&r);
  hid_t one = write_rows("one", 1, &r), five = write_rows("five", 5, &r);
  for (int k = 0; k < SETS - 1; k++) {
    hid_t a = H5Dopen2(one, names[k], H5P_DEFAULT), b = H5Dopen2(five, names[k], H5P_DEFAULT);
    for (size_t number = 0; number * CHUNK < ROWS; number++) {
      hsize_t n = 0, m = 0;
      void *p = chunk_of(a, number, &n), *q = chunk_of(b, number, &m);
      EXPECT(p && q && n == m && !memcmp(p, q, n));
      free(p);
      free(q);
    }
    H5Dclose(a);
    H5Dclose(b);
  }
  H5Fclose(one);
  H5Fclose(five);
}

int main(void) {
  hdf_quiet();
  RUN(test_hdf5_reads_what_was_appended);
  RUN(test_any_number_of_threads_stores_the_same_bytes);
  return TEST_RESULT;
}
