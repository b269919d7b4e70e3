/* Entries from text: curves of theory and formulas, checks, and the verdicts that follow. */
#include <stdlib.h>
#include <string.h>

#include "gallery/verdict.h"
#include "tests/test.h"

enum { MOST = 16 };

static const char text[] =
    "entries:\n"
    "  - id: P 1\n"
    "    title: sound\n"
    "    where: P\n"
    "    kind: theory\n"
    "    setup: none\n"
    "    curves:\n"
    "      - {name: a, from: theory, topic: dispersion, set: delta=1 points=401 to=4, y: a}\n"
    "      - {name: twice, from: formula, on: a, y: 2*a - x}\n"
    "      - {name: loop, from: formula, y: loop + x}\n"
    "    numbers:\n"
    "      - {name: one, is: 'at(\"a\", 1)'}\n"
    "    checks:\n"
    "      - {says: a, value: one, equals: 0.9981983771, within: 1e-9, of: document, source: P (20)}\n"
    "      - {says: b, value: 'at(\"twice\", 1)', equals: 2*one - 1, within: 1e-12, of: corrected,\n"
    "         source: itself}\n"
    "      - {says: c, value: one, below: 1, above: 0.99, of: corrected, source: P, quick: false}\n";

static struct gallery_book *book_of(const char *words) {
  const struct gallery_file file = {"entries.yaml", words, strlen(words)};
  struct problems problems;
  struct gallery_book *book = NULL;
  EXPECT_OK(gallery_book_read(1, &file, &problems, &book));
  for (size_t i = 0; i < problems.n; i++) fprintf(stderr, "%s\n", problems.text[i]);
  problems_destroy(&problems);
  return book;
}

static enum gallery_verdict verdict(const char *words, bool quick, struct gallery_answer *a,
                                    bool *expected) {
  struct gallery_book *book = book_of(words);
  struct gallery_desk *desk = NULL;
  enum gallery_verdict v = GALLERY_VERDICT_failed;
  if (!book) return v;
  EXPECT_OK(gallery_desk_create(book, "/nowhere", quick, &desk));
  EXPECT_OK(gallery_desk_begin(desk, book->entries));
  EXPECT_OK(gallery_answer_all(desk, book->entries, a));
  v = gallery_verdict_of(book->entries, a);
  *expected = gallery_is_expected(book->entries, a);
  gallery_desk_destroy(desk);
  gallery_book_destroy(book);
  return v;
}

/* The text with one part of it replaced. */
static const char *with(const char *part, const char *other) {
  static char changed[sizeof text + 400];
  const char *at = strstr(text, part);
  EXPECT(at != NULL);
  snprintf(changed, sizeof changed, "%.*s%s%s", (int)(at - text), text, other, at + strlen(part));
  return changed;
}

static void test_all_hold(void) {
  struct gallery_answer a[MOST];
  bool expected;
  EXPECT(verdict(text, false, a, &expected) == GALLERY_VERDICT_agrees);
  EXPECT(expected && a[0].holds && a[1].holds && a[2].holds);
  EXPECT_NEAR(a[0].low, 0.9981983761, 1e-15);
  EXPECT_NEAR(a[2].high, 1, 0);
  EXPECT(verdict(text, true, a, &expected) == GALLERY_VERDICT_agrees);
  EXPECT(a[2].left);
}

static void test_what_fails(void) {
  struct gallery_answer a[MOST];
  bool expected;
  EXPECT(verdict(with("0.9981983771", "0.99819838"), false, a, &expected) ==
         GALLERY_VERDICT_disagrees);
  EXPECT(!expected && !a[0].holds && a[1].holds);
  EXPECT(verdict(with("source: P (20)", "source: P (20), because: a reason"), false, a, &expected) ==
         GALLERY_VERDICT_agrees);
  EXPECT(!expected); /* it holds, and is said not to */
  EXPECT(verdict(with("0.9981983771, within: 1e-9,", "5, percent: 1, because: a misprint,"), false,
                 a, &expected) == GALLERY_VERDICT_disagrees);
  EXPECT(expected);
}

static void test_corrected(void) {
  struct gallery_answer a[MOST];
  bool expected;
  char words[sizeof text + 400];
  snprintf(words, sizeof words, "%s",
           with("0.9981983771, within: 1e-9,", "5, percent: 1, because: a misprint,"));
  char *at = strstr(words, "kind: theory"), rest[sizeof words];
  snprintf(rest, sizeof rest, "%s", at);
  snprintf(at, sizeof words - (size_t)(at - words), "corrected: true\n    %s", rest);
  EXPECT(verdict(words, false, a, &expected) == GALLERY_VERDICT_corrected);
  EXPECT(expected);
}

static void test_what_cannot_be_computed(void) {
  struct gallery_answer a[MOST];
  bool expected;
  EXPECT(verdict(with("value: one, equals", "value: 'first(\"loop\")', equals"), false, a,
                 &expected) == GALLERY_VERDICT_failed);
  EXPECT(strstr(a[0].failure, "needs itself") != NULL);
}

/* What scatters across a limit is no change, whichever side it is on; what lies beyond it is. */
static void test_scatter(void) {
  static const struct {
    const char *part, *other;
    bool holds, expected;
  } cases[] = {
      {"below: 1, above: 0.99", "below: 0.99", false, false},
      {"below: 1, above: 0.99", "below: 0.99, scatter: 0.01", false, true},
      {"below: 1, above: 0.99", "below: 0.98, scatter: 0.01", false, false},
      {"below: 1, above: 0.99", "below: 1.005, because: chaos, scatter: 0.01", true, true},
      {"below: 1, above: 0.99", "below: 1.02, because: chaos, scatter: 0.01", true, false},
      {"below: 1, above: 0.99", "above: 1.001, scatter: 0.01", false, true},
      {"below: 1, above: 0.99", "equals: 1, percent: 0.1, scatter: 0.002", false, true},
      {"below: 1, above: 0.99", "equals: 1, percent: 0.1, scatter: 0.0005", false, false},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct gallery_answer a[MOST];
    bool expected;
    (void)verdict(with(cases[i].part, cases[i].other), false, a, &expected);
    if (a[2].holds != cases[i].holds || expected != cases[i].expected)
      TEST_FAIL("%s: holds %d, expected %d", cases[i].other, a[2].holds, expected);
  }
}

/* A bound that does not exist holds nothing, though another one does. */
static void test_bounds_that_do_not_exist(void) {
  static const struct {
    const char *part, *other, *says;
    int check;
  } wrong[] = {
      {"below: 1, above: 0.99", "below: 'at(\"a\", 99)', above: 0.99", "no such bound", 2},
      {"below: 1, above: 0.99", "below: 1, above: 'at(\"a\", 99)'", "no such bound", 2},
      {"below: 1, above: 0.99", "below: 'sqrt(-1)'", "no such bound", 2},
      {"equals: 0.9981983771", "equals: 'at(\"a\", 99)'", "no such number", 0},
      {"within: 1e-9", "within: 'at(\"a\", 99)'", "tolerance", 0},
      {"within: 1e-9", "within: 1/0", "tolerance", 0},
      {"within: 1e-9", "within: -1", "tolerance", 0},
      {"within: 1e-9", "percent: -1", "tolerance", 0},
      {"equals: 0.9981983771", "equals: 1/0", "no such number", 0},
      {"below: 1, above: 0.99", "above: -1/0", "no such bound", 2},
      {"value: one, below: 1, above: 0.99", "value: 1/0, above: 0.99", "no such number", 2},
      {"quick: false", "scatter: 1/0", "no such scatter", 2},
      {"quick: false", "scatter: -1", "no such scatter", 2},
      {"value: one, equals", "value: 'max(one, at(\"a\", 99))', equals", "no such number", 0},
  };
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    struct gallery_answer a[MOST];
    bool expected;
    EXPECT(verdict(with(wrong[i].part, wrong[i].other), false, a, &expected) ==
           GALLERY_VERDICT_failed);
    const struct gallery_answer *failed = &a[wrong[i].check];
    if (expected || failed->holds || !strstr(failed->failure, wrong[i].says))
      TEST_FAIL("%s: '%s'", wrong[i].other, failed->failure);
  }
}

int main(void) {
  RUN(test_all_hold);
  RUN(test_what_fails);
  RUN(test_corrected);
  RUN(test_what_cannot_be_computed);
  RUN(test_scatter);
  RUN(test_bounds_that_do_not_exist);
  return TEST_RESULT;
}
