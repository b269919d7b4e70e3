/* Chunks that we inflate ourselves are what HDF5 reads, and whatever is stored in another way, or
 * wrongly, is left to it. */
#include <hdf5.h>

#include "common/result/result_chunks.h"
#include "common/result/result_hdf.h"
#include "tests/common/result_sample.h"
#include "tests/test.h"

enum { ROWS = 1000, CHUNK = 64, WIDTH = 3 };

static char path[128];
static double values[ROWS][WIDTH];

static void fill(void) {
  for (int i = 0; i < ROWS; i++)
    for (int k = 0; k < WIDTH; k++) values[i][k] = sin(12.9898 * i) / (k + 3);
  values[7][1] = NAN;
  values[8][0] = -0.0;
}

enum { DEFLATE = 1, SHUFFLE = 2, CHECKSUM = 4, NARROW = 8 };

static hid_t make(hid_t file, const char *name, size_t width, hid_t type, int how) {
  const hsize_t dims[2] = {ROWS, width}, chunk[2] = {CHUNK, how & NARROW ? 1 : width};
  hid_t space = H5Screate_simple(width ? 2 : 1, dims, NULL), plist = H5Pcreate(H5P_DATASET_CREATE);
  if (how) H5Pset_chunk(plist, width ? 2 : 1, chunk);
  if (how & SHUFFLE) H5Pset_shuffle(plist);
  if (how & DEFLATE) H5Pset_deflate(plist, 4);
  if (how & CHECKSUM) H5Pset_fletcher32(plist);
  hid_t set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, plist, H5P_DEFAULT);
  EXPECT(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
  H5Pclose(plist);
  H5Sclose(space);
  return set;
}

/* Any rows, also those that begin and end within a chunk, and the last one, which is not full. */
static void test_rows_are_those_of_hdf5(void) {
  static const hsize_t at[][2] = {{0, ROWS}, {0, 1},    {63, 2},      {64, 64},
                                  {70, 300}, {990, 10}, {ROWS - 1, 1}};
  hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  for (size_t width = 0; width <= WIDTH; width += WIDTH) {
    const size_t wide = width ? width : 1;
    hid_t set = make(file, width ? "rows" : "vector", width, H5T_NATIVE_DOUBLE, DEFLATE | SHUFFLE);
    EXPECT(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0);
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
      static double got[ROWS * WIDTH];
      memset(got, 0x5a, sizeof got);
      EXPECT(hdf_chunks_read(set, width, at[i][0], at[i][1], got));
      EXPECT(!memcmp(got, (double *)values + at[i][0] * wide, at[i][1] * wide * sizeof *got));
    }
    H5Dclose(set);
  }
  H5Fclose(file);
}

static void test_others_are_left_to_hdf5(void) {
  static const struct {
    const char *name;
    int how;
  } tries[] = {{"contiguous", 0},
               {"deflated alone", DEFLATE},
               {"shuffled alone", SHUFFLE},
               {"with a checksum", DEFLATE | SHUFFLE | CHECKSUM},
               {"in narrow chunks", DEFLATE | SHUFFLE | NARROW}};
  static double got[ROWS * WIDTH];
  hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  for (size_t i = 0; i < sizeof tries / sizeof *tries; i++) {
    double *read = NULL;
    hid_t set = make(file, tries[i].name, WIDTH, H5T_NATIVE_DOUBLE, tries[i].how);
    H5Fflush(file, H5F_SCOPE_GLOBAL);
    EXPECT(!hdf_chunks_read(set, WIDTH, 0, ROWS, got));
    H5Dclose(set);
    EXPECT_OK(hdf_get_rows(file, tries[i].name, H5T_NATIVE_DOUBLE, WIDTH, 0, ROWS, &read));
    EXPECT(read && !memcmp(read, values, sizeof values));
    free(read);
  }
  hid_t set = make(file, "floats", WIDTH, H5T_NATIVE_FLOAT, DEFLATE | SHUFFLE);
  EXPECT(!hdf_chunks_read(set, WIDTH, 0, ROWS, got));
  H5Dclose(set);
  H5Fclose(file);
}

/* Bytes that are no chunk, too long or too short a one, and none at all. */
static void test_wrong_chunks_are_refused(void) {
  static const unsigned char nonsense[100] = {1, 2, 3};
  static double got[ROWS * WIDTH];
  const hsize_t second[2] = {CHUNK, 0};
  hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  hid_t set = make(file, "rows", WIDTH, H5T_NATIVE_DOUBLE, DEFLATE | SHUFFLE);
  EXPECT(H5Dwrite_chunk(set, H5P_DEFAULT, 0, second, sizeof nonsense, nonsense) >= 0);
  EXPECT(hdf_chunks_read(set, WIDTH, 0, CHUNK, got));
  EXPECT(!hdf_chunks_read(set, WIDTH, 0, CHUNK + 1, got));
  EXPECT(H5Dwrite_chunk(set, H5P_DEFAULT, 1, second, sizeof nonsense, nonsense) >= 0);
  EXPECT(!hdf_chunks_read(set, WIDTH, CHUNK, 1, got)); /* a filter left out */
  H5Dclose(set);
  const hsize_t dims[2] = {ROWS, WIDTH}, chunk[2] = {CHUNK, WIDTH};
  hid_t space = H5Screate_simple(2, dims, NULL), plist = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(plist, 2, chunk);
  H5Pset_shuffle(plist);
  H5Pset_deflate(plist, 1);
  set = H5Dcreate2(file, "empty", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, plist, H5P_DEFAULT);
  EXPECT(!hdf_chunks_read(set, WIDTH, 0, 1, got));
  H5Dclose(set);
  H5Pclose(plist);
  H5Sclose(space);
  H5Fclose(file);
}

int main(void) {
  hdf_quiet();
  fill();
  snprintf(path, sizeof path, "%s/chunks.h5", sample_folder());
  RUN(test_rows_are_those_of_hdf5);
  RUN(test_others_are_left_to_hdf5);
  RUN(test_wrong_chunks_are_refused);
  sample_folder_remove();
  return TEST_RESULT;
}
