/* Entries with mistakes: each is one line with file, line, what was found, what is allowed and what
 * to do; entries without are read as they stand. */
#include <stdlib.h>
#include <string.h>

#include "gallery/book.h"
#include "tests/test.h"

/* Lines are counted from 1. */
static const char *const lines[] = {
    "cases:",
    "  - {name: wave, file: standing-wave.yaml, set: [time.end=1], quick: [time.end=0.5]}",
    "  - {name: still, file: hydrostatic.yaml}",
    "entries:",
    "  - id: T 2-10",
    "    title: A wave",
    "    where: section 2.4",
    "    kind: run",
    "    setup: >",
    "      What is computed.",
    "    remarks:",
    "      - \"A misprint.\"",
    "    curves:",
    "      - {name: e, from: energy, run: wave/sph, what: kinetic}",
    "      - {name: a, from: formula, y: x^2, to: 2}",
    "    numbers:",
    "      - {name: one, is: 1}",
    "    checks:",
    "      - {says: it is one, value: one, equals: 1, within: 0, of: document, source: eq 1}",
    "      - {says: it is not two, value: one, below: 2, of: corrected, source: eq 2}",
    "  - {id: P 1, title: Words, where: here, kind: text, setup: nothing}",
    NULL};

static struct problems problems;

static enum status read_with(size_t line, const char *text, struct gallery_book **book) {
  static char all[8192];
  size_t n = 0;
  for (size_t i = 0; lines[i]; i++)
    n += (size_t)snprintf(all + n, sizeof all - n, "%s\n", line == i + 1 ? text : lines[i]);
  const struct gallery_file file = {.name = "t.yaml", .text = all, .size = n};
  return gallery_book_read(1, &file, &problems, book);
}

static void test_entries_are_read(void) {
  struct gallery_book *book = NULL;
  EXPECT_OK(read_with(0, "", &book));
  if (!book) return;
  EXPECT(book->n_cases == 2 && book->n_entries == 2);
  EXPECT_STR(book->entries[0].id, "P 1"); /* in the order of the documents */
  EXPECT_STR(book->entries[1].key, "T-2-10");
  const struct gallery_entry *e = gallery_book_find(book, "t-2-10");
  EXPECT(e == &book->entries[1]);
  EXPECT(e->kind == GALLERY_KIND_run && !e->corrected && e->quick);
  EXPECT(e->n_curves == 2 && e->n_numbers == 1 && e->n_checks == 2 && e->n_remarks == 1);
  EXPECT(e->checks[1].of == GALLERY_ORIGIN_corrected);
  const struct gallery_case *c = gallery_book_case(book, "wave");
  EXPECT(c && c->n_set == 1 && c->n_quick == 1);
  EXPECT(!gallery_book_find(book, "T 2") && !gallery_book_case(book, "T"));
  gallery_book_destroy(book);
}

/* A line in place of that of its number, and all that is said of it. */
static const struct {
  size_t line;
  const char *text, *says;
} wrong[] = {
    {1, "wrong:", "t.yaml:1: wrong: found an unknown key; allowed: cases, entries"},
    {2, "  - {name: wave}",
     "t.yaml:2: cases.wave.file: found nothing; allowed: one line of text of at most 200 bytes; "
     "add this key"},
    {2, "  - {name: .wave, file: standing-wave.yaml}",
     "t.yaml:2: cases[0]: found '.wave'; allowed: letters, digits, '.', '_' and '-', with no '.' "
     "first, at most 64"},
    {2, "  - {name: wave, file: standing-wave.yaml, set: time.end=1}",
     "t.yaml:2: cases.wave.set: found 'time.end=1'; allowed: a list of 0 to 1000 overrides"},
    {2, "  - {name: wave, file: standing-wave.yaml, sets: [time.end=1]}",
     "t.yaml:2: cases.wave.sets: found an unknown key; allowed: name, file, set, quick; did you "
     "mean 'set'?"},
    {2, "  - {name: wave, file: standing-wave.yaml, quick: [[1]]}",
     "t.yaml:2: cases.wave.quick[0]: found a list; allowed: one line of text of at most 4000 "
     "bytes"},
    {2, "  - {name: wave, file: none.yaml}",
     "t.yaml:2: cases.wave.file: found 'none.yaml'; allowed: a case file of gallery/cases or "
     "cases"},
    {2, "  - {name: wave, file: standing-wave.yaml, set: [time.end]}",
     "t.yaml:2: cases.wave.set[0]: found 'time.end'; allowed: PATH=VALUE, as in runs.NAME.alpha=0"},
    {2, "  - {name: wave, file: cases/standing-wave.yaml}",
     "t.yaml:2: cases.wave.file: found 'cases/standing-wave.yaml'; allowed: a case file of "
     "gallery/cases or cases"},
    {3, "  - {name: wave, file: hydrostatic.yaml}",
     "t.yaml:3: cases.wave: found a name that another case has; allowed: each name once; rename "
     "one"},
    {4, "entry:",
     "t.yaml:1: entries: found nothing; allowed: a list of entries; add this key | t.yaml:4: "
     "entry: found an unknown key; allowed: cases, entries"},
    {5, "  - id: \"T 2:10\"",
     "t.yaml:5: T 2:10.id: found 'T 2:10'; allowed: an id as in P 1, T 2-13, T Tab 2.1"},
    {5, "  - id: ..",
     "t.yaml:5: ...id: found '..'; allowed: an id as in P 1, T 2-13, T Tab 2.1"},
    {5, "  - id: T-2-10",
     "t.yaml:5: T-2-10.id: found 'T-2-10'; allowed: an id as in P 1, T 2-13, T Tab 2.1"},
    {5, "  - id: T 2-010",
     "t.yaml:5: T 2-010.id: found 'T 2-010'; allowed: an id as in P 1, T 2-13, T Tab 2.1"},
    {5, "  - id: T Tab 2-1",
     "t.yaml:5: T Tab 2-1.id: found 'T Tab 2-1'; allowed: an id as in P 1, T 2-13, T Tab 2.1"},
    {5, "  - id: X 99",
     "t.yaml:5: X 99.id: found 'X 99'; allowed: an id as in P 1, T 2-13, T Tab 2.1"},
    {5, "  - id: P 9/9",
     "t.yaml:5: P 9/9.id: found 'P 9/9'; allowed: an id as in P 1, T 2-13, T Tab 2.1"},
    {5, "  - id: P -1",
     "t.yaml:5: P -1.id: found 'P -1'; allowed: an id as in P 1, T 2-13, T Tab 2.1"},
    {5, "  - ids: T 2-10",
     "t.yaml:5: entries[0].id: found nothing; allowed: one line of text of at most 32 bytes; add "
     "this key | t.yaml:5: entries[0].ids: found an unknown key; allowed: id, title, where, kind, "
     "setup, corrected, quick, remarks, curves, numbers, checks, figures; did you mean 'id'?"},
    {6, "    title: ''",
     "t.yaml:6: T 2-10.title: found ''; allowed: one line of text of at most 200 bytes"},
    {6, "    titel: A wave",
     "t.yaml:5: T 2-10.title: found nothing; allowed: one line of text of at most 200 bytes; add "
     "this key | t.yaml:6: T 2-10.titel: found an unknown key; allowed: id, title, where, kind, "
     "setup, corrected, quick, remarks, curves, numbers, checks, figures; did you mean 'title'?"},
    {6, "    title: [A wave]",
     "t.yaml:6: T 2-10.title: found a list; allowed: one line of text of at most 200 bytes"},
    {8, "    kind: runs",
     "t.yaml:8: T 2-10.kind: found 'runs'; allowed: one of theory, lattice, run, experiment, "
     "sketch, text; did you mean 'run'?"},
    {8, "    kind: Run",
     "t.yaml:8: T 2-10.kind: found 'Run'; allowed: one of theory, lattice, run, experiment, "
     "sketch, text; did you mean 'run'?"},
    {8, "    {}",
     "t.yaml:9: found broken YAML (while scanning a simple key: could not find expected ':'); "
     "correct line 9 or the one before"},
    {11, "    remark:",
     "t.yaml:11: T 2-10.remark: found an unknown key; allowed: id, title, where, kind, setup, "
     "corrected, quick, remarks, curves, numbers, checks, figures; did you mean 'remarks'?"},
    {11, "    corrected: perhaps",
     "t.yaml:11: T 2-10.corrected: found 'perhaps - \"A misprint.\"'; allowed: true or false"},
    {11, "    quick: 2",
     "t.yaml:11: T 2-10.quick: found '2 - \"A misprint.\"'; allowed: true or false"},
    {12, "      - {a: b}",
     "t.yaml:12: T 2-10.remarks[0]: found a mapping; allowed: one line of text of at most 4000 "
     "bytes"},
    {14, "      - {name: e, from: energie, run: wave/sph, what: kinetic}",
     "t.yaml:14: T 2-10.curves.e.from: found 'energie'; allowed: one of theory, formula..."},
    {14, "      - {name: e, from: energy, what: kinetic}",
     "t.yaml:14: T 2-10.curves.e.run: found nothing; allowed: one line of text of at most 1000 "
     "bytes; add this key"},
    {14, "      - {name: e, run: wave/sph, what: kinetic}",
     "t.yaml:14: T 2-10.curves.e.from: found nothing; allowed: one of theory, formula..."},
    {14, "      - {name: e, from: energy, run: wave/sph, what: kinetik}",
     "t.yaml:14: T 2-10.curves.e.what: found 'kinetik'; allowed: one of mechanical, kinetic..."},
    {14, "      - {name: e, from: energy, run: waves/sph, what: kinetic}",
     "t.yaml:14: T 2-10.curves.e.run: found run 'waves/sph'; allowed: CASE/RUN with a case of `cases`"},
    {14, "      - {name: e, from: energy, run: sph, what: kinetic}",
     "t.yaml:14: T 2-10.curves.e.run: found run 'sph'; allowed: CASE/RUN with a case of `cases`"},
    {14, "      - {name: e, from: energy, run: wave/sph/2, what: kinetic}",
     "t.yaml:14: T 2-10.curves.e.run: found run 'wave/sph/2'; allowed: CASE/RUN with a case of `cases`"},
    {14, "      - {name: 2e, from: energy, run: wave/sph, what: kinetic}",
     "t.yaml:14: T 2-10.curves.2e: found the name '2e'; allowed: a letter, then letters, digits "
     "and '_'"},
    {14, "      - {name: a, from: energy, run: wave/sph, what: kinetic}",
     "t.yaml:15: T 2-10.curves.a: found a name that another curve has; allowed: each name once; "
     "rename one"},
    {14, "      - {name: one, from: energy, run: wave/sph, what: kinetic}",
     "t.yaml:17: T 2-10.numbers.one: found a name that another curve has; allowed: each name once; "
     "rename one"},
    {14, "      - {name: x, from: energy, run: wave/sph, what: kinetic}",
     "t.yaml:14: T 2-10.curves.x: found the name 'x'; allowed: a name that is no function or "
     "constant of formulas, nor x; rename it"},
    {14, "      - {name: where_least, from: energy, run: wave/sph, what: kinetic}",
     "t.yaml:14: T 2-10.curves.where_least: found the name 'where_least'; allowed: a name..."},
    {14, "      - e",
     "t.yaml:14: T 2-10.curves[0]: found 'e'; allowed: a mapping with name, from and the keys of its "
     "source"},
    {14, "      - {name: e, from: theory, topic: dispersoin, y: a}",
     "t.yaml:14: T 2-10.curves.e.topic: found 'dispersoin'; allowed: one of ..."},
    {14, "      - {name: e, from: theory, topic: dispersion, set: dleta=1, y: a}",
     "t.yaml:14: T 2-10.curves.e.set: found the parameter 'dleta'; allowed: one of ..."},
    {14, "      - {name: e, from: theory, topic: dispersion, set: delta=1 to=2 delta=1, y: a}",
     "t.yaml:14: T 2-10.curves.e.set: found the parameter 'delta' a second time; allowed: each "
     "parameter once; remove one"},
    {14, "      - {name: e, from: theory, topic: dispersion, set: delta, y: a}",
     "t.yaml:14: T 2-10.curves.e.set: found 'delta'; allowed: KEY=VALUE"},
    {14, "      - {name: e, from: theory, topic: dispersion, set: points=one, y: a}",
     "t.yaml:14: T 2-10.curves.e.set: points: found 'one'; allowed: a whole number from 2 to "
     "100000"},
    {14, "      - {name: e, from: theory, topic: dispersion, set: 'delta=0,1', y: a}",
     "t.yaml:14: T 2-10.curves.e.set: found settings for 2 curves; allowed: one value of each "
     "parameter"},
    {14, "      - {name: e, from: theory, topic: dispersion, y: aa}",
     "t.yaml:14: T 2-10.curves.e.y: found 'aa'; allowed: one of ..."},
    {14, "      - {name: e, from: theory, topic: dispersion, x: aa, y: a}",
     "t.yaml:14: T 2-10.curves.e.x: found 'aa'; allowed: one of ..."},
    {14, "      - {name: e, from: event, run: wave/sph, event: landing}",
     "t.yaml:14: T 2-10.curves.e.event: found 'landing'; allowed: one of wall_impact, overturning, "
     "touchdown, self_contact, overflow, run_up"},
    {14, "      - {name: e, from: average, curve: b, over: 1}",
     "t.yaml:14: T 2-10.curves.e.curve: found the curve 'b'; allowed: a curve of the entry"},
    {15, "      - {name: a, from: formula, on: elan, y: e}",
     "t.yaml:15: T 2-10.curves.a.on: found the curve 'elan'; allowed: a curve of the entry"},
    {15, "      - {name: a, from: formula, y: 'x + f(2)'}",
     "t.yaml:15: T 2-10.curves.a.y: found the name 'f'; allowed: x, a number or a curve of the "
     "entry"},
    {15, "      - {name: a, from: formula, y: e + once}",
     "t.yaml:15: T 2-10.curves.a.y: found the name 'once'; allowed: x, a number or a curve of the "
     "entry; did you mean 'one'?"},
    {15, "      - {name: a, from: formula, y: one, at: x +}",
     "t.yaml:15: T 2-10.curves.a.at: found a formula that cannot be read: ..."},
    {17, "      - {name: pi, is: 1}",
     "t.yaml:17: T 2-10.numbers.pi: found the name 'pi'; allowed: a name..."},
    {17, "      - {name: one, is: 'x > 1 ? 1 : last(\"g\")'}",
     "t.yaml:17: T 2-10.numbers.one.is: found the curve 'g'; allowed: a curve of the entry"},
    {17, "      - {name: one, is: x}",
     "t.yaml:17: T 2-10.numbers.one.is: found the name 'x'; allowed: a number of the entry, or a "
     "function of a curve"},
    {19, "      - {says: it is one, value: one, equals: onee, within: 0, of: document, source: eq 1}",
     "t.yaml:19: T 2-10.checks[0].equals: found the name 'onee'; allowed: a number of the entry, or "
     "a function of a curve; did you mean 'one'?"},
    {19, "      - {says: it is one, value: one, equals: 1, within: last(), of: document, source: eq 1}",
     "t.yaml:19: T 2-10.checks[0].within: found a formula that cannot be read: ..."},
    {20, "      - {says: it, value: one, below: 2, scatter: 1 +, of: corrected, source: eq 2}",
     "t.yaml:20: T 2-10.checks[1].scatter: found a formula that cannot be read: ..."},
    {19, "      - {says: it is one, value: one, below: 1 2, of: document, source: eq 1}",
     "t.yaml:19: T 2-10.checks[0].below: found a formula that cannot be read: ..."},
    {15, "      - {name: a, from: formula, y: x^2, to: two}",
     "t.yaml:15: T 2-10.curves.a.to: found 'two'; allowed: a number from -1000000000 to "
     "1000000000"},
    {15, "      - {name: a, from: formula, y: x^2, points: 0}",
     "t.yaml:15: T 2-10.curves.a.points: found '0'; allowed: a whole number from 1 to 100000"},
    {15, "      - {name: a, from: formula, y: x^2, topic: sound}",
     "t.yaml:15: T 2-10.curves.a.topic: found an unknown key; allowed: name, from, y, on..."},
    {17, "      - {name: one}",
     "t.yaml:17: T 2-10.numbers.one.is: found nothing; allowed: one line of text of at most 4000 "
     "bytes; add this key"},
    {17, "      - {name: o-ne, is: 1}",
     "t.yaml:17: T 2-10.numbers.o-ne: found the name 'o-ne'; allowed: a letter, then letters, "
     "digits and '_' | ..."},
    {17, "      - {name: one, is: 1, as: 2}",
     "t.yaml:17: T 2-10.numbers.one.as: found an unknown key; allowed: name, is; did you mean "
     "'is'?"},
    {19, "      - {says: it is one, value: one, equals: 1, of: document, source: eq 1}",
     "t.yaml:19: T 2-10.checks[0]: found equals without a tolerance; allowed: equals with one of "
     "within and percent"},
    {19,
     "      - {says: it is one, value: one, equals: 1, within: 0, percent: 1, of: document, "
     "source: eq 1}",
     "t.yaml:19: T 2-10.checks[0]: found both within and percent; allowed: equals with one of "
     "within and percent"},
    {19, "      - {says: it is one, value: one, within: 0, of: document, source: eq 1}",
     "t.yaml:19: T 2-10.checks[0]: found no expected value; allowed: equals, or below, above or "
     "both"},
    {19, "      - {says: it is one, value: one, of: document, source: eq 1}",
     "t.yaml:19: T 2-10.checks[0]: found no expected value; allowed: equals, or below, above or "
     "both"},
    {19, "      - {says: it is one, value: one, equals: 1, below: 2, of: document, source: eq 1}",
     "t.yaml:19: T 2-10.checks[0]: found both equals and a bound; allowed: equals, or below, above "
     "or both"},
    {19, "      - {says: it is one, value: one, below: 2, within: 1, of: document, source: eq 1}",
     "t.yaml:19: T 2-10.checks[0]: found a tolerance of a bound; allowed: equals with one of "
     "within and percent"},
    {19, "      - {says: it is one, value: one, equals: 1, within: 0, of: me, source: eq 1}",
     "t.yaml:19: T 2-10.checks[0].of: found 'me'; allowed: one of document, corrected, measured"},
    {19, "      - {says: it is one, value: one, equals: 1, within: 0, of: document}",
     "t.yaml:19: T 2-10.checks[0].source: found nothing; allowed: one line of text of at most 400 "
     "bytes; add this key"},
    {19, "      - {value: one, equals: 1, within: 0, of: document, source: eq 1}",
     "t.yaml:19: T 2-10.checks[0].says: found nothing; allowed: one line of text of at most 300 "
     "bytes; add this key"},
    {19,
     "      - {says: it is one, value: one, equals: 1, within: 0, of: document, source: eq 1, "
     "because: }",
     "t.yaml:19: T 2-10.checks[0].because: found nothing; allowed: one line of text of at most "
     "4000 bytes"},
    {21, "  - {id: T 2-10, title: Words, where: here, kind: text, setup: nothing}",
     "t.yaml:21: T 2-10: found an id that another entry has; allowed: each id once; rename one"},
    {21, "  - {id: t 2-10, title: Words, where: here, kind: text, setup: nothing}",
     "t.yaml:21: t 2-10.id: found 't 2-10'; allowed: an id as in P 1, T 2-13, T Tab 2.1..."},
    {21, "  - {id: P 1, title: Words, where: here, kind: text}",
     "t.yaml:21: P 1.setup: found nothing; allowed: one line of text of at most 4000 bytes; add "
     "this key"},
    {21,
     "  - {id: P 1, title: Words, where: here, kind: text, setup: nothing, figures: [{kind: "
     "grph}]}",
     "t.yaml:21: P 1.figures[0].kind: found 'grph'; allowed: one of ..."},
    {21, "  - {id: P 1, title: Words, where: here, kind: text, setup: nothing, figures: [5]}",
     "t.yaml:21: P 1.figures[0]: found '5'; allowed: a mapping with kind, caption and the keys of "
     "its kind"},
    {21,
     "  - {id: P 1, title: W, where: here, kind: text, setup: nothing, figures: [{kind: theory, "
     "topic: dispersoin}]}",
     "t.yaml:21: P 1.figures[0].topic: found 'dispersoin'; allowed: one of ..."},
    {21,
     "  - {id: P 1, title: W, where: here, kind: text, setup: nothing, figures: [{kind: theory, "
     "topic: dispersion, set: dleta=1}]}",
     "t.yaml:21: P 1.figures[0].set: found the parameter 'dleta'; allowed: one of ..."},
    {21,
     "  - {id: P 1, title: W, where: here, kind: text, setup: nothing, figures: [{kind: graph, x: x, "
     "panels: [{y: y, level: zero, lines: [{curve: a, name: a}]}]}]}",
     "t.yaml:21: P 1.figures[0].panels[0].level: found the name 'zero'; allowed: a number of the "
     "entry, or a function of a curve | t.yaml:21: P 1.figures[0].panels[0].lines.a.curve: found the "
     "curve 'a'; allowed: a curve of the entry"},
    {21,
     "  - {id: P 1, title: W, where: here, kind: text, setup: nothing, figures: [{kind: table, head: "
     "[a], rows: [['=one']]}]}",
     "t.yaml:21: P 1.figures[0].rows[0][0]: found the name 'one'; allowed: a number of the entry, or "
     "a function of a curve"},
    {21,
     "  - {id: P 1, title: W, where: here, kind: text, setup: nothing, figures: [{kind: table, head: "
     "[a], rows: [['=1 | %.4294967297f']]}]}",
     "t.yaml:21: P 1.figures[0].rows[0][0]: found ..."},
    {21,
     "  - {id: P 1, title: W, where: here, kind: text, setup: nothing, figures: [{kind: snapshots, "
     "field: speed, runs: [wave/a, waves/a], times: [0]}]}",
     "t.yaml:21: P 1.figures[0]: found run 'waves/a'; allowed: CASE/RUN with a case of `cases`"},
    {21,
     "  - {id: P 1, title: Words, where: here, kind: text, setup: nothing, figures: {kind: graph}}",
     "t.yaml:21: P 1.figures: found a mapping; allowed: a list of 0 to 1000 figures"},
    {21, "  - {id: P 1, title: Words, where: here, kind: text, setup: nothing",
     "t.yaml:22: found broken YAML (while parsing a flow mapping: did not find expected ',' or "
     "'}'); correct line 22 or the one before"},
    {21, "  - {id: P 1, id: P 2, title: Words, where: here, kind: text, setup: nothing}",
     "t.yaml:21: P 1.id: found the key a second time (first in line 21); allowed: each key once; "
     "remove one"},
};

/* All problems in one line. */
static const char *told(void) {
  static char all[2048];
  size_t n = 0;
  all[0] = 0;
  for (size_t i = 0; i < problems.n; i++)
    n += (size_t)snprintf(all + n, sizeof all - n, "%s%s", i ? " | " : "", problems.text[i]);
  return all;
}

/* Up to "...", behind which lists that grow may stand. */
static bool says(const char *text, const char *expected) {
  const size_t n = strlen(expected);
  const bool open = n > 3 && !strcmp(expected + n - 3, "...");
  return open ? !strncmp(text, expected, n - 3) : !strcmp(text, expected);
}

static void test_mistakes_are_told(void) {
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    struct gallery_book *book = NULL;
    const enum status status = read_with(wrong[i].line, wrong[i].text, &book);
    if (status != ERR_INPUT || book) TEST_FAIL("'%s': status %d", wrong[i].text, status);
    if (!says(told(), wrong[i].says)) EXPECT_STR(told(), wrong[i].says);
    problems_destroy(&problems);
    gallery_book_destroy(book);
  }
}

/* What is wrong with a file as a whole. */
static void test_files_that_are_no_book(void) {
  static const struct {
    const char *text, *says;
  } none[] = {
      {"", "t.yaml: found no keys; allowed: a mapping with entries, and cases"},
      {"entries: []\n---\nentries: []\n",
       "t.yaml:2: found a second YAML document; allowed: one a file; remove the line '---' and what "
       "follows"},
  };
  for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
    const struct gallery_file file = {"t.yaml", none[i].text, strlen(none[i].text)};
    struct gallery_book *book = NULL;
    EXPECT(gallery_book_read(1, &file, &problems, &book) == ERR_INPUT && !book);
    EXPECT_STR(told(), none[i].says);
    problems_destroy(&problems);
  }
}

/* Functions and constants of muParser's and ours, and x, are no names of curves and numbers: what
 * is told of them is told of all. */
static void test_names_of_formulas_are_taken(void) {
  static const char *const taken[] = {"x",   "pi",  "_pi", "_e",   "sin",  "atan2", "sqrt",
                                      "abs", "max", "avg", "last", "most", "beyond"};
  static const char *const others[] = {"y", "xx", "Pi", "a1", "_", "lasting"};
  for (size_t i = 0; i < sizeof taken / sizeof *taken; i++) {
    struct gallery_book *book = NULL;
    char line[80], says_so[80];
    snprintf(line, sizeof line, "      - {name: one, is: 1}\n      - {name: %s, is: 1}", taken[i]);
    snprintf(says_so, sizeof says_so, "t.yaml:18: T 2-10.numbers.%s: found the name '%s'; ...",
             taken[i], taken[i]);
    EXPECT(read_with(17, line, &book) == ERR_INPUT);
    if (!says(told(), says_so)) EXPECT_STR(told(), says_so);
    problems_destroy(&problems);
  }
  for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
    struct gallery_book *book = NULL;
    char line[80];
    snprintf(line, sizeof line, "      - {name: one, is: 1}\n      - {name: %s, is: 1}", others[i]);
    EXPECT_OK(read_with(17, line, &book));
    problems_destroy(&problems);
    gallery_book_destroy(book);
  }
}

/* Every mistake of a file is told, and those of several files with their names. */
static void test_all_mistakes_are_told(void) {
  static const char first[] = "entries:\n  - {id: P 1, titel: A}\n";
  static const char second[] = "entries: 1\n";
  const struct gallery_file files[] = {{"a.yaml", first, sizeof first - 1},
                                       {"b.yaml", second, sizeof second - 1}};
  struct gallery_book *book = NULL;
  EXPECT(gallery_book_read(2, files, &problems, &book) == ERR_INPUT && !book);
  EXPECT(problems.n == 6);
  EXPECT_STR(status_message(), "the gallery's entries have 6 problems");
  EXPECT_STR(problems.n == 6 ? problems.text[5] : "",
             "b.yaml:1: entries: found '1'; allowed: a list of 1 to 1000 entries");
  problems_destroy(&problems);
}

int main(void) {
  RUN(test_entries_are_read);
  RUN(test_mistakes_are_told);
  RUN(test_files_that_are_no_book);
  RUN(test_names_of_formulas_are_taken);
  RUN(test_all_mistakes_are_told);
  return TEST_RESULT;
}
