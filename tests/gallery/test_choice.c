/* Words of a command line and the entries that they mean. */
#include <stdlib.h>

#include "gallery/choice.h"
#include "tests/test.h"

static struct gallery_entry entries[] = {
    {.id = "P 1"},   {.id = "P 2"},       {.id = "P 10"},      {.id = "T 2-1"},  {.id = "T 2-10"},
    {.id = "T 3-1"}, {.id = "T Tab 2.1"}, {.id = "T Tab 2.4"}, {.id = "T 4-20"}, {.id = "T 4-44"},
};
enum { N = sizeof entries / sizeof *entries };
static const struct gallery_book book = {.n_entries = N, .entries = entries};

/* The entries chosen, a letter each: 'a' the first. */
static const char *chosen_by(size_t n, const char *const *word) {
  static char letters[N + 1];
  bool chosen[N];
  size_t found = 0;
  if (gallery_choose(&book, n, word, chosen) != OK) return status_message();
  for (size_t i = 0; i < N; i++)
    if (chosen[i]) letters[found++] = (char)('a' + i);
  letters[found] = 0;
  return letters;
}
#define CHOSEN(...)                                                                                \
  chosen_by(sizeof((const char *[]){__VA_ARGS__}) / sizeof(char *), (const char *[]){__VA_ARGS__})

static void test_no_words_mean_all(void) {
  EXPECT_STR(chosen_by(0, NULL), "abcdefghij");
}

static void test_ids_in_any_writing(void) {
  EXPECT_STR(CHOSEN("P 1"), "a");
  EXPECT_STR(CHOSEN("P-1"), "a");
  EXPECT_STR(CHOSEN("p1"), "a");
  EXPECT_STR(CHOSEN("p_10"), "c");
  EXPECT_STR(CHOSEN("T 2-1"), "d");
  EXPECT_STR(CHOSEN("t2-10"), "e");
  EXPECT_STR(CHOSEN("T-Tab-2.1"), "g");
  EXPECT_STR(CHOSEN(" T  Tab 2.4 "), "h");
}

static void test_ids_as_several_words(void) {
  EXPECT_STR(CHOSEN("P", "1"), "a");
  EXPECT_STR(CHOSEN("T", "Tab", "2.1"), "g");
  EXPECT_STR(CHOSEN("P", "1", "T", "3-1"), "af");
  EXPECT_STR(CHOSEN("P 2", "P 1", "P 2"), "ab");
}

static void test_beginnings_and_patterns(void) {
  EXPECT_STR(CHOSEN("P"), "abc");
  EXPECT_STR(CHOSEN("t"), "defghij");
  EXPECT_STR(CHOSEN("P", "T"), "abcdefghij");
  EXPECT_STR(CHOSEN("T 4"), "ij");
  EXPECT_STR(CHOSEN("T 4-"), "ij");
  EXPECT_STR(CHOSEN("T Tab"), "gh");
  EXPECT_STR(CHOSEN("T Tab 2"), "gh");
  EXPECT_STR(CHOSEN("T", "Tab", "2"), "gh");
  EXPECT_STR(CHOSEN("T 2"), "degh"); /* with the tables of the chapter */
  EXPECT_STR(CHOSEN("T 3"), "f");
  EXPECT_STR(CHOSEN("T 4-2*"), "i");
  EXPECT_STR(CHOSEN("*-1"), "adf");
  EXPECT_STR(CHOSEN("T ?-1"), "df");
  EXPECT_STR(CHOSEN("*"), "abcdefghij");
}

static void test_ranges(void) {
  EXPECT_STR(CHOSEN("P 1..P 10"), "abc");
  EXPECT_STR(CHOSEN("P 1..2"), "ab");
  EXPECT_STR(CHOSEN("P-2..T-2-1"), "bcd");
  EXPECT_STR(CHOSEN("T 2-10..4-20"), "efghi");
  EXPECT_STR(CHOSEN("T 4-20..44"), "ij");
  EXPECT_STR(CHOSEN("P", "1..10"), "abc");
  EXPECT_STR(CHOSEN("P 1..1"), "a");
  EXPECT_STR(CHOSEN("T Tab 2.1..2.4"), "gh");
  EXPECT_STR(CHOSEN("T", "Tab", "2.1..T", "Tab", "2.4"), "gh");
}

/* A range ends where its last id does. */
static void test_ranges_beside_others(void) {
  EXPECT_STR(CHOSEN("P 1..P 2", "T 4-20..T 4-44"), "abij");
  EXPECT_STR(CHOSEN("P 1..P 2", "T 2-1"), "abd");
  EXPECT_STR(CHOSEN("T 2-1", "P 1..P 2"), "abd");
  EXPECT_STR(CHOSEN("T", "2-1..2-10", "P", "1"), "ade");
  EXPECT_STR(CHOSEN("P", "1..2", "T", "4-20..44"), "abij");
  EXPECT_STR(CHOSEN("P", "1..P", "2", "T", "Tab", "2.1"), "abg");
  EXPECT_STR(CHOSEN("P 1..2", "T 4", "T Tab 2.1..T Tab 2.4"), "abghij");
  EXPECT(strstr(CHOSEN("T", "2-1..2-11"), "found '2-11'; ") != NULL);
  EXPECT(strstr(CHOSEN("T", "2-2..2-10"), "found 'T 2-2'; ") != NULL);
  EXPECT(strstr(CHOSEN("P 1..P 2", "T 2-1..T 2-11"), "found 'T 2-11'; ") != NULL);
  EXPECT(strstr(CHOSEN("P 1..P 2", "2-11"), "found '2-11'; ") != NULL);
}

static void test_words_that_mean_nothing(void) {
  const char *said = "; allowed: an id that `plunge gallery --list` shows, as in 'P 1' or 'T 4-*'";
  static const struct {
    const char *word, *found, *near;
  } wrong[] = {
      {"P 3", "P 3", "P 1"},        {"Q 1", "Q 1", "P 1"},        {"", "", NULL},
      {"T 4-4", "T 4-4", "T 4-44"}, {"nothing", "nothing", NULL}, {"X*", "X*", NULL},
      {"P 1..P 4", "P 4", "P 1"},   {"..P 4", "..P 4", NULL},     {"P 1..", "P 1..", "P 1"},
  };
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    char text[300];
    snprintf(text, sizeof text, "found '%s'%s%s%s%s", wrong[i].found, said,
             wrong[i].near ? "; did you mean '" : "", wrong[i].near ? wrong[i].near : "",
             wrong[i].near ? "'?" : "");
    EXPECT_STR(CHOSEN(wrong[i].word), text);
  }
  EXPECT_STR(CHOSEN("P 10..1"), "found 'P 10..1'; allowed: a range in the order of the documents, "
                                "in which P 1 comes before P 10");
  EXPECT(strstr(CHOSEN("T", "2-11"), "found 'T 2-11'; ") != NULL);
  EXPECT(strstr(CHOSEN("P 1", "2-11"), "found '2-11'; ") != NULL);
  char longer[400];
  memset(longer, 'x', sizeof longer);
  longer[sizeof longer - 1] = 0;
  EXPECT(strstr(CHOSEN(longer), "allowed: an id") != NULL);
}

int main(void) {
  RUN(test_no_words_mean_all);
  RUN(test_ids_in_any_writing);
  RUN(test_ids_as_several_words);
  RUN(test_beginnings_and_patterns);
  RUN(test_ranges);
  RUN(test_ranges_beside_others);
  RUN(test_words_that_mean_nothing);
  return TEST_RESULT;
}
