#include "gallery/choice.h"

#include <ctype.h>
#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

#define LETTERS "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
enum { LONGEST = 80, MOST_WORDS = 5 }; /* a range has: "T", "Tab", "2.1..T", "Tab", "2.4" */

/* "P 1", "p_1" and "P1" as "p-1". */
static void plain(const char *text, char out[LONGEST]) {
  size_t n = 0;
  for (const char *c = text; *c && n + 2 < LONGEST; c++) {
    const bool gap = *c == ' ' || *c == '_' || *c == '-';
    if (gap && (n == 0 || out[n - 1] == '-')) continue;
    if (n == 1 && isalpha((unsigned char)out[0]) && isdigit((unsigned char)*c)) out[n++] = '-';
    out[n++] = gap ? '-' : (char)tolower((unsigned char)*c);
  }
  while (n && out[n - 1] == '-') n--;
  out[n] = 0;
}

/* Of the entry that has this id, n_entries when none has. */
static size_t place_of(const struct gallery_book *book, const char *id) {
  char key[LONGEST], wanted[LONGEST];
  plain(id, wanted);
  for (size_t i = 0; i < book->n_entries; i++) {
    plain(book->entries[i].id, key);
    if (!strcmp(key, wanted)) return i;
  }
  return book->n_entries;
}

/* "t-2" begins "t-2-1", "t-tab-2" "t-tab-2.1". */
static bool begins(const char *key, const char *wanted) {
  const size_t n = strlen(wanted);
  return n && !strncmp(key, wanted, n) && (key[n] == '-' || key[n] == '.');
}

/* Tables are of a chapter as figures are: "t-2" has "t-tab-2.1", too. */
static bool is_table_of(const char *key, const char *wanted) {
  char without[LONGEST];
  if (strncmp(key, "t-tab-", 6) != 0) return false;
  snprintf(without, sizeof without, "t-%s", key + 6);
  return begins(without, wanted);
}

/* All whose ids begin with the word, or fit it as a pattern. How many. */
static size_t mark_fitting(const struct gallery_book *book, const char *word, bool *chosen) {
  char key[LONGEST], wanted[LONGEST];
  size_t found = 0;
  plain(word, wanted);
  for (size_t i = 0; i < book->n_entries; i++) {
    plain(book->entries[i].id, key);
    if (!begins(key, wanted) && !is_table_of(key, wanted) && fnmatch(wanted, key, 0) != 0) continue;
    if (chosen) chosen[i] = true;
    found++;
  }
  return found;
}

/* The end of a range may leave out what it shares with the beginning: "T 4-20..44", "T 2-1..3-2".
 */
static size_t end_of(const struct gallery_book *book, const char *from, const char *to) {
  char first[LONGEST], id[2 * LONGEST];
  size_t place = place_of(book, to);
  plain(from, first);
  for (size_t n = strlen(first); place == book->n_entries && n; n--) {
    if (first[n - 1] != '-') continue;
    snprintf(id, sizeof id, "%.*s%.70s", (int)n, first, to);
    place = place_of(book, id);
  }
  return place;
}

static enum status complain(const struct gallery_book *book, const char *word) {
  const char *names[book->n_entries + 1], *near = NULL;
  char(*keys)[LONGEST] = NULL, wanted[LONGEST];
  TRY(array_create(&keys, book->n_entries, "names of entries"));
  plain(word, wanted);
  for (size_t i = 0; i < book->n_entries; i++) {
    plain(book->entries[i].id, keys[i]);
    names[i] = keys[i];
  }
  near = param_nearest(wanted, book->n_entries, names);
  const size_t place = near ? place_of(book, near) : 0;
  const enum status status = status_raise(
      ERR_USAGE,
      "found '%s'; allowed: an id that `plunge gallery --list` shows, as in 'P 1' or "
      "'T 4-*'%s%s%s",
      word, near ? "; did you mean '" : "", near ? book->entries[place].id : "", near ? "'?" : "");
  free(keys);
  return status;
}

/* The places of both ends of FROM..TO, n_entries for one that is none. */
static void find_ends(const struct gallery_book *book, const char *word, const char *dots,
                      size_t *first, size_t *last) {
  char from[LONGEST];
  snprintf(from, sizeof from, "%.*s", (int)(dots - word), word);
  *first = place_of(book, from);
  *last = end_of(book, from, dots + 2);
}

static enum status mark_range(const struct gallery_book *book, const char *word, const char *dots,
                              bool *chosen) {
  char from[LONGEST];
  size_t first, last;
  find_ends(book, word, dots, &first, &last);
  snprintf(from, sizeof from, "%.*s", (int)(dots - word), word);
  if (first == book->n_entries) return complain(book, *from ? from : word);
  if (last == book->n_entries) return complain(book, dots[2] ? dots + 2 : word);
  CHECK(first <= last, ERR_USAGE,
        "found '%s'; allowed: a range in the order of the documents, in which %s comes before %s",
        word, book->entries[last].id, book->entries[first].id);
  for (size_t i = first; i <= last; i++) chosen[i] = true;
  return OK;
}

/* n words as one, with spaces; false: too long. */
static bool join(size_t n, const char *const *word, char out[LONGEST]) {
  size_t used = 0;
  out[0] = 0;
  for (size_t i = 0; i < n; i++) {
    const int more = snprintf(out + used, LONGEST - used, "%s%s", i ? " " : "", word[i]);
    if (more < 0 || used + (size_t)more >= LONGEST) return false;
    used += (size_t)more;
  }
  return true;
}

static bool is_meant(const struct gallery_book *book, const char *text) {
  const char *dots = strstr(text, "..");
  size_t first, last;
  if (!dots) return mark_fitting(book, text, NULL) > 0;
  find_ends(book, text, dots, &first, &last);
  return first < book->n_entries && last < book->n_entries;
}

/* How many of the n words are the parts of one: "T" "Tab" "2.1". */
static size_t parts(const struct gallery_book *book, size_t n, const char *const *word,
                    char out[LONGEST]) {
  for (size_t k = n < MOST_WORDS ? n : MOST_WORDS; k > 1; k--)
    if (join(k, word, out) && is_meant(book, out)) return k;
  return join(1, word, out) ? 1 : 0;
}

/* What to blame for word i, which means nothing: with a "T" before it when that is but a part. */
static void blame(size_t i, const char *const *word, char out[LONGEST]) {
  if (i && strspn(word[i - 1], LETTERS) == strlen(word[i - 1]) && join(2, word + i - 1, out))
    return;
  join(1, word + i, out);
}

enum status gallery_choose(const struct gallery_book *book, size_t n, const char *const *word,
                           bool *chosen) {
  for (size_t i = 0; i < book->n_entries; i++) chosen[i] = n == 0;
  for (size_t i = 0, used; i < n; i += used) {
    char text[LONGEST];
    used = parts(book, n - i, word + i, text);
    if (!used) return complain(book, word[i]);
    if (used == 1 && !is_meant(book, text)) blame(i, word, text);
    const char *dots = strstr(text, "..");
    const size_t place = place_of(book, text);
    if (dots)
      TRY(mark_range(book, text, dots, chosen));
    else if (place < book->n_entries)
      chosen[place] = true;
    else if (!mark_fitting(book, text, chosen))
      return complain(book, text);
  }
  return OK;
}
