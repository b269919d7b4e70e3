/* What entries of the gallery run is there: their cases are read with their overrides, with --quick
 * and without, and have the runs that are named. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
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
    EXPECT(run->state == GALLERY_RUN_MISSING && !run->wanted);
    EXPECT(gallery_runs_find(&runs, run->name) == run);
    EXPECT(gallery_runs_estimate(&runs, k).bytes > 0);
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

/* stderr goes into a file, until it is heard. */
static void listen(FILE *to, int *back) {
  fflush(stderr);
  *back = dup(2);
  EXPECT(dup2(fileno(to), 2) == 2);
}

static void hear(FILE *from, int back, char *heard, size_t room) {
  fflush(stderr);
  EXPECT(dup2(back, 2) == 2);
  close(back);
  rewind(from);
  heard[fread(heard, 1, room - 1, from)] = 0;
}

/* A run that its case lacks, and overrides that it does not take, are told before anything is run,
 * with the places in the file of entries. */
static void test_wrong_runs_are_told(void) {
  static const char text[] =
      "cases:\n"
      "  - {name: wave, file: standing-wave.yaml}\n"
      "  - {name: odd, file: standing-wave.yaml, set: [runs.nosuch.alpha=0]}\n"
      "entries:\n"
      "  - id: P 1\n"
      "    title: t\n"
      "    where: w\n"
      "    kind: run\n"
      "    setup: s\n"
      "    curves:\n"
      "      - {name: a, from: energy, run: wave/zz, what: kinetic}\n"
      "      - {name: b, from: energy, run: odd/bem, what: kinetic}\n"
      "      - {name: c, from: energy, run: odd/sph, what: kinetic}\n"
      "    figures:\n"
      "      - {kind: snapshots, field: u, runs: [wave/zy], times: [0]}\n";
  const struct gallery_file file = {"t.yaml", text, sizeof text - 1};
  char folder[] = "/tmp/plunge-gallery-XXXXXX", heard[4000], command[64];
  struct problems problems = {0};
  struct gallery_book *book = NULL;
  struct gallery_runs runs = {0};
  FILE *stream = tmpfile();
  int back = -1;
  EXPECT_OK(gallery_book_read(1, &file, &problems, &book));
  EXPECT(stream && mkdtemp(folder));
  if (!book || !stream) return;
  listen(stream, &back);
  const enum status status = gallery_runs_gather(book, &(bool){true}, folder, false, &runs);
  hear(stream, back, heard, sizeof heard);
  fclose(stream);
  EXPECT(status == ERR_INPUT);
  EXPECT_STR(status_message(), "the gallery's entries have 3 problems");
  if (!strstr(heard, "t.yaml:11: P 1.curves.a.run: found run 'wave/zz'; allowed: a run of ") ||
      !strstr(heard, "t.yaml:15: P 1.figures[0]: found run 'wave/zy'; allowed: a run of ") ||
      !strstr(heard, "--set runs.nosuch.alpha=0: ") ||
      !strstr(heard, "t.yaml:3: cases.odd: found standing-wave.yaml with overrides that it does"))
    TEST_FAIL("heard '%s'", heard);
  snprintf(command, sizeof command, "rm -r %s", folder);
  EXPECT(system(command) == 0);
  gallery_runs_free(&runs);
  gallery_book_destroy(book);
  problems_destroy(&problems);
}

int main(void) {
  RUN(test_runs_of_the_gallery_exist);
  RUN(test_runs_of_the_quick_gallery_exist);
  RUN(test_wrong_runs_are_told);
  return TEST_RESULT;
}
