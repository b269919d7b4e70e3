/* What entries of the gallery run is there: their cases are read with their overrides, with --quick
 * and without, and have the runs that are named. */
#include <stdlib.h>
#include <unistd.h>

#include "cli/gallery_runs.h"
#include "tests/test.h"

static void gather(bool quick) {
  char folder[] = "/tmp/plunge-gallery-XXXXXX";
  int exit_code = 0;
  struct gallery_book *book = gallery_runs_book(&exit_code);
  struct gallery_runs runs = {0};
  EXPECT(book && exit_code == 0 && mkdtemp(folder));
  if (!book) return;
  bool chosen[book->n_entries + 1];
  for (size_t i = 0; i < book->n_entries; i++) chosen[i] = !quick || book->entries[i].quick;
  EXPECT_OK(gallery_runs_gather(book, chosen, folder, quick, &runs));
  for (size_t k = 0; k < runs.n; k++) {
    const struct gallery_run *run = &runs.run[k];
    if (!run->r) TEST_FAIL("%s", run->why);
    EXPECT(run->state == GALLERY_RUN_MISSING && !run->wanted);
    EXPECT(gallery_runs_find(&runs, run->name) == run);
    if (run->r) EXPECT(gallery_runs_estimate(&runs, k).bytes > 0);
  }
  for (size_t i = 0; i < book->n_cases; i++) { /* nothing lies about */
    bool used = quick;
    for (size_t k = 0; k < runs.n_cases; k++) used |= runs.cases[k].of == &book->cases[i];
    if (!used) TEST_FAIL("no entry needs case %s", book->cases[i].name);
  }
  char command[64];
  snprintf(command, sizeof command, "rm -r %s", folder);
  EXPECT(system(command) == 0);
  gallery_runs_free(&runs);
  gallery_book_destroy(book);
}

static void test_runs_of_the_gallery_exist(void) {
  gather(false);
}

static void test_runs_of_the_quick_gallery_exist(void) {
  gather(true);
}

int main(void) {
  RUN(test_runs_of_the_gallery_exist);
  RUN(test_runs_of_the_quick_gallery_exist);
  return TEST_RESULT;
}
