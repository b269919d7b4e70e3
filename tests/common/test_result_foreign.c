/* HDF5 files that are sound as such but not what a result must be: each is refused with the
 * sentence that says why, and nothing in it can make the reader allocate or wait for long. */
#include <hdf5.h>

#include "common/result/result_diff.h"
#include "tests/common/result_sample.h"
#include "tests/common/result_water.h"
#include "tests/test.h"

static char path[128];

static void write_result(void) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  for (size_t k = 0; w && k < 5; k++) EXPECT_OK(sample_output(w, k, 40));
  if (w) EXPECT_OK(result_finish(w));
  result_destroy(w);
  sample_case_destroy(c);
}

/* ---- ways to spoil a file ---- */

static void put_number(hid_t file, const char *name, hsize_t row, double value) {
  hid_t set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
  hsize_t start[2] = {row, 0}, count[2] = {1, 1}, one = 1;
  hid_t memory = H5Screate_simple(1, &one, NULL);
  H5Sselect_hyperslab(space, H5S_SELECT_SET, start, NULL, count, NULL);
  EXPECT(H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, &value) >= 0);
  H5Sclose(memory);
  H5Sclose(space);
  H5Dclose(set);
}

static void resize(hid_t file, const char *name, double rows) {
  hid_t set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
  hsize_t dims[2] = {0, 0};
  H5Sget_simple_extent_dims(space, dims, NULL);
  dims[0] = (hsize_t)rows;
  EXPECT(H5Dset_extent(set, dims) >= 0);
  H5Sclose(space);
  H5Dclose(set);
}

static void put_attribute(hid_t file, const char *name, double value) {
  hid_t attribute = H5Aopen(file, name, H5P_DEFAULT);
  EXPECT(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value) >= 0);
  H5Aclose(attribute);
}

static void delete_link(hid_t file, const char *name) {
  EXPECT(H5Ldelete(file, name, H5P_DEFAULT) >= 0);
}

/* In the place of a dataset: one of another type, 3 x 3. */
static void replace(hid_t file, const char *name, hid_t type) {
  hsize_t dims[2] = {3, 3};
  hid_t space = H5Screate_simple(2, dims, NULL);
  delete_link(file, name);
  hid_t set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  EXPECT(set >= 0);
  H5Dclose(set);
  H5Sclose(space);
}

enum way {
  NUMBER,
  ROWS,
  ATTRIBUTE,
  NO_ATTRIBUTE,
  DELETE,
  REPLACE_DOUBLE,
  REPLACE_TEXT,
  DANGLE,
  CYCLE
};

static void spoil(enum way way, const char *name, hsize_t row, double value) {
  hid_t file = H5Fopen(path, H5F_ACC_RDWR, H5P_DEFAULT);
  switch (way) {
  case NUMBER:
    put_number(file, name, row, value);
    break;
  case ROWS:
    resize(file, name, value);
    break;
  case ATTRIBUTE:
    put_attribute(file, name, value);
    break;
  case NO_ATTRIBUTE:
    EXPECT(H5Adelete(file, name) >= 0);
    break;
  case DELETE:
    delete_link(file, name);
    break;
  case REPLACE_DOUBLE:
    replace(file, name, H5T_NATIVE_DOUBLE);
    break;
  case REPLACE_TEXT:
    replace(file, name, H5T_C_S1);
    break;
  case DANGLE:
    delete_link(file, name);
    EXPECT(H5Lcreate_soft("/nowhere", file, name, H5P_DEFAULT, H5P_DEFAULT) >= 0);
    break;
  case CYCLE:
    EXPECT(H5Lcreate_hard(file, "/", file, name, H5P_DEFAULT, H5P_DEFAULT) >= 0);
    break;
  }
  H5Fclose(file);
}

static const struct {
  enum way way;
  const char *name;
  hsize_t row;
  double value;
  const char *says;
} cases[] = {
    {ATTRIBUTE, "format_version", 0, 2,
     "has version 2 of the result format; this program reads version 1"},
    {NO_ATTRIBUTE, "format_version", 0, 0, "no numeric attribute \"format_version\""},
    {NO_ATTRIBUTE, "g", 0, 0, "no numeric attribute \"g\""},
    {NO_ATTRIBUTE, "rest_potential", 0, 0,
     "it has /series/energy, but no attribute rest_potential, from which energies are counted"},
    {ATTRIBUTE, "H", 0, 0, "its attribute H is 0; it must be positive"},
    {ATTRIBUTE, "g", 0, NAN, "its attribute g is nan; it must be positive"},
    {DANGLE, "case", 0, 0, "it has no text /case"},
    {DANGLE, "walls", 0, 0, "it has no group /walls"},
    {NUMBER, "walls/points", 1, INFINITY, "its dataset /walls/points is not finite at row 1"},
    {NUMBER, "walls/first_point", 1, 99, "its dataset /walls/first_point is inconsistent"},
    {DANGLE, "surface", 0, 0, "it has no group /surface"},
    {DELETE, "surface/points", 0, 0, "it has no dataset /surface/points"},
    {REPLACE_DOUBLE, "surface/points", 0, 0, "its dataset /surface/points has the wrong shape"},
    {REPLACE_TEXT, "surface/closed", 0, 0, "its dataset /surface/closed has the wrong shape"},
    {NUMBER, "surface/time", 2, NAN, "its times of /surface do not increase at row 2 (nan s)"},
    {NUMBER, "surface/time", 0, 5, "its times of /surface do not increase at row 1 (0.1 s)"},
    {NUMBER, "surface/first_piece", 2, 100, "its dataset /surface/first_piece is inconsistent"},
    {NUMBER, "surface/first_point", 0, 1, "its dataset /surface/first_point is inconsistent"},
    {NUMBER, "surface/points", 3, NAN, "its dataset /surface/points is not finite at row 3"},
    {ROWS, "surface/time", 0, 4, "its datasets in /surface have lengths that do not fit together"},
    {ROWS, "surface/points", 0, 1e15, "its dataset /surface/points is damaged"},
    {ROWS, "series/energy/time", 0, 1e18, "its dataset /series/energy/time is damaged"},
    {ROWS, "series/energy/kinetic", 0, 49,
     "its series /series/energy has columns of different lengths"},
    {NUMBER, "series/run/time", 9, -1, "its times of /series/run do not increase at row 9 (-1 s)"},
    {DELETE, "series/run/volume", 0, 0, "it has no dataset /series/run/volume"},
    {DELETE, "series/energy/potential", 0, 0, "it has no dataset /series/energy/potential"},
    {DANGLE, "series/energy/total", 0, 0, "it has no dataset /series/energy/total"},
    {ROWS, "series/probes/P_1/pressure", 0, 7, "its series P_1 has columns of different lengths"},
    {CYCLE, "series/probes/all", 0, 0, "no numeric attribute \"x\""},
    {DELETE, "events/touchdown/x", 0, 0, "it has no number /events/touchdown/x"},
    {REPLACE_TEXT, "statistics/steps", 0, 0, "it has no number /statistics/steps"},
    {ROWS, "VTKHDF/NumberOfPoints", 0, 4, "its dataset /VTKHDF/NumberOfPoints is inconsistent"},
    {NUMBER, "VTKHDF/Steps/Values", 1, 1e9, "its times of /VTKHDF do not increase at row 2"},
};

static void test_each_wrong_content_is_named(void) {
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct result_file *f = NULL;
    write_result();
    spoil(cases[i].way, cases[i].name, cases[i].row, cases[i].value);
    EXPECT(result_read(path, &f) == ERR_INPUT && !f);
    if (!strstr(status_message(), cases[i].says) || strchr(status_message(), '\n') ||
        !strstr(status_message(), path))
      TEST_FAIL("%s: the message is: %s", cases[i].name, status_message());
    result_file_destroy(f);
  }
}

static void test_wrong_points_are_refused(void) {
  static const struct {
    enum way way;
    const char *name;
    hsize_t row;
    double value;
  } wrong[] = {{NUMBER, "VTKHDF/NumberOfPoints", 1, -1},
               {NUMBER, "VTKHDF/NumberOfPoints", 1, 1e15},
               {NUMBER, "VTKHDF/Steps/PointOffsets", 1, -5},
               {NUMBER, "VTKHDF/Steps/PointOffsets", 1, 9e18},
               {ROWS, "VTKHDF/Points", 0, 50},
               {ROWS, "VTKHDF/PointData/pressure", 0, 50},
               {REPLACE_DOUBLE, "VTKHDF/Points", 0, 0},
               {DELETE, "VTKHDF/PointData", 0, 0}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    struct result_water water;
    write_result();
    spoil(wrong[i].way, wrong[i].name, wrong[i].row, wrong[i].value);
    EXPECT(water_read(path, "pressure", false, 1, &water) == ERR_INPUT);
    EXPECT(water.n == 0 && !water.p && !water.value[0] && strstr(status_message(), ", output 1: "));
  }
}

/* A file of another program, with nothing of ours in it. */
static void test_hdf5_of_another_program_is_named(void) {
  char message[320];
  struct result_file *f = NULL;
  hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(file);
  EXPECT(result_read(path, &f) == ERR_INPUT);
  snprintf(message, sizeof message,
           "%s is an HDF5 file, but no result: it has no attribute H, one of the scales H, g, "
           "density and spacing, which docs/result-file.md describes",
           path);
  EXPECT_STR(status_message(), message);
}

/* What a user adds with h5py does no harm. */
static void test_additions_are_ignored(void) {
  struct result_file *f = NULL;
  write_result();
  hid_t file = H5Fopen(path, H5F_ACC_RDWR, H5P_DEFAULT);
  hid_t group = H5Gcreate2(file, "my notes", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Gclose(group);
  H5Fclose(file);
  EXPECT_OK(result_read(path, &f));
  EXPECT(f && f->n_outputs == 5);
  result_file_destroy(f);
}

int main(void) {
  snprintf(path, sizeof path, "%s/sample.h5", sample_folder());
  RUN(test_each_wrong_content_is_named);
  RUN(test_wrong_points_are_refused);
  RUN(test_hdf5_of_another_program_is_named);
  RUN(test_additions_are_ignored);
  sample_folder_remove();
  return TEST_RESULT;
}
