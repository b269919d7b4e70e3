/* Result files open in h5py by the lines in the manual, keep the rules of VTKHDF, and their .xdmf
 * opens in the XDMF readers that are installed (result_open.py). */
#include <sys/wait.h>

#include "tests/common/result_sample.h"
#include "tests/test.h"

static int skipped;

static void open_in_python(const char *path) {
  char command[400];
  snprintf(command, sizeof command, "/usr/bin/python3 '%s/tests/common/result_open.py' '%s' '%s'",
           SOURCE_DIR, path, SOURCE_DIR);
  fflush(stdout);
  int code = system(command);
  if (WIFEXITED(code) && WEXITSTATUS(code) == 77)
    skipped = 1;
  else
    EXPECT(code == 0);
}

static void test_particles_open_in_python(void) {
  char path[128];
  snprintf(path, sizeof path, "%s/particles.h5", sample_folder());
  struct case_file *c = sample_case();
  struct result *w = NULL;
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  for (size_t k = 0; w && k < 7; k++) EXPECT_OK(sample_output(w, k, 2000));
  result_destroy(w); /* not finished: so it is after Ctrl-C too */
  sample_case_destroy(c);
  open_in_python(path);
}

/* The nodes of a boundary: one line, of another number of points each time. */
static void test_lines_open_in_python(void) {
  char path[128];
  snprintf(path, sizeof path, "%s/line & nodes.h5", sample_folder());
  struct case_file *c = sample_case();
  struct result *w = NULL;
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  double x[40], y[40];
  for (size_t k = 0; w && k < 5; k++) {
    size_t n = 40 - 7 * (k % 3);
    for (size_t i = 0; i < n; i++) {
      x[i] = (double)i / 7;
      y[i] = sin(x[i] + (double)k);
    }
    struct result_field field = {"pressure", "Pa", "pressure", y, NULL};
    EXPECT_OK(result_points(w, 0.1 * (double)k, n, x, y, RESULT_LINE, 1, &field));
    EXPECT_OK(result_energy(w, &(struct result_energy){.time = 0.1 * (double)k}));
    EXPECT_OK(result_flush(w));
  }
  if (w) EXPECT_OK(result_finish(w));
  result_destroy(w);
  sample_case_destroy(c);
  open_in_python(path);
}

int main(void) {
  RUN(test_particles_open_in_python);
  RUN(test_lines_open_in_python);
  sample_folder_remove();
  return test_failures ? 1 : skipped ? 77 : 0;
}
