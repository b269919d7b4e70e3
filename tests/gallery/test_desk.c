/* What a desk keeps: the same topic with the same settings is one result, until another entry
 * begins. */
#include <string.h>

#include "gallery/desk.h"
#include "tests/test.h"

static const char text[] =
    "entries:\n"
    "  - id: P 1\n"
    "    title: sound\n"
    "    where: P\n"
    "    kind: theory\n"
    "    setup: none\n"
    "    curves:\n"
    "      - {name: a, from: theory, topic: dispersion, set: delta=1 points=3, y: a}\n"
    "      - {name: b, from: theory, topic: dispersion, set: delta=1 points=3, x: a, y: b}\n";

static void test_theory_is_kept(void) {
  const struct gallery_file file = {"entries.yaml", text, sizeof text - 1};
  const struct theory_result *first, *same, *other;
  struct problems problems;
  struct gallery_book *book = NULL;
  struct gallery_desk *desk = NULL;
  double value = 0, end = 1;
  EXPECT_OK(gallery_book_read(1, &file, &problems, &book));
  EXPECT_OK(gallery_desk_create(book, "/nowhere", false, &desk));
  EXPECT_OK(gallery_desk_begin(desk, book->entries));
  EXPECT_OK(gallery_desk_theory(desk, "dispersion", "delta=1 points=3", &first));
  const struct theory_curve *c = first->curve;
  EXPECT_OK(gallery_desk_theory(desk, "dispersion", NULL, &other));
  EXPECT_OK(gallery_desk_theory(desk, "dispersion", "delta=1 points=3", &same));
  EXPECT(same->curve == c && other->curve != c && c->n == 3);
  EXPECT_OK(gallery_desk_formula(desk, "last(\"a\")", &value));
  EXPECT_OK(gallery_desk_formula(desk, "end(\"b\")", &end));
  EXPECT(value == c->row[2 * same->topic->n_columns + 1] && end == value);
  for (int again = 0; again < 2; again++) {
    EXPECT(gallery_desk_theory(desk, "dispersion", "delta=x", &other) == ERR_INPUT);
    EXPECT(strstr(status_message(), "delta: found 'x'"));
  }
  EXPECT_OK(gallery_desk_begin(desk, book->entries)); /* nothing is left of before */
  EXPECT_OK(gallery_desk_formula(desk, "last(\"a\")", &end));
  EXPECT(end == value);
  gallery_desk_destroy(desk);
  gallery_book_destroy(book);
  problems_destroy(&problems);
}

int main(void) {
  RUN(test_theory_is_kept);
  return TEST_RESULT;
}
