/* Figures of entries: how they are read, what is drawn and written, and what is said of those that
 * cannot be. */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compare/child.h"
#include "compare/output.h"
#include "gallery/figures/figures.h"
#include "gallery/reader.h"
#include "tests/test.h"

static char folder[] = "/tmp/plunge-figures-XXXXXX";

#define ENTRY                                                                                      \
  "cases:\n"                                                                                       \
  "  - {name: dam, file: dam-break.yaml}\n"                                                        \
  "entries:\n"                                                                                     \
  "  - id: P 1\n"                                                                                  \
  "    title: waves\n"                                                                             \
  "    where: here\n"                                                                              \
  "    kind: theory\n"                                                                             \
  "    setup: none\n"                                                                              \
  "    curves:\n"                                                                                  \
  "      - {name: a, from: theory, topic: dispersion, set: delta=1 points=5 to=4, y: a}\n"         \
  "      - {name: b, from: formula, on: a, y: 2*x}\n"                                              \
  "      - {name: c, from: formula, on: a, y: c}\n"                                                \
  "    checks: []\n"                                                                               \
  "    figures:\n"

/* What is complained of first; "" when nothing is. */
static char *complaint(const char *figure) {
  static char said[600];
  char *words;
  struct problems problems;
  struct gallery_book *book = NULL;
  if (asprintf(&words, ENTRY "      - %s\n", figure) < 0) abort();
  const struct gallery_file file = {"entries.yaml", words, strlen(words)};
  const enum status status = gallery_book_read(1, &file, &problems, &book);
  snprintf(said, sizeof said, "%s", problems.n ? problems.text[0] : "");
  EXPECT((status == OK) == !*said);
  problems_destroy(&problems);
  gallery_book_destroy(book);
  free(words);
  return said;
}

static void test_wrong_figures(void) {
  static const struct {
    const char *figure, *says;
  } wrong[] = {
      {"{kind: graph}", "found nothing; allowed"},
      {"{kind: graphs, x: a}", "did you mean 'graph'?"},
      {"{kind: graph, x: a, panels: []}", "panels: found an empty list"},
      {"{kind: graph, x: a, panels: [{y: b, lines: []}]}", "lines: found an empty list"},
      {"{kind: graph, x: a, panels: [{y: b, lines: [{curve: a}]}]}", "name: found nothing"},
      {"{kind: graph, x: a, from: 2, to: 1, panels: [{y: b, lines: [{curve: a, name: a}]}]}",
       "an axis that ends where it begins"},
      {"{kind: graph, x: a, panels: [{y: b, bottom: 1, top: 1, lines: [{curve: a, name: a}]}]}",
       "an axis that ends where it begins"},
      {"{kind: graph, x: a, log: true, from: 0, panels: [{y: b, lines: [{curve: a, name: a}]}]}",
       "a logarithmic axis that reaches zero"},
      {"{kind: graph, x: a, from: wide, panels: [{y: b, lines: [{curve: a, name: a}]}]}",
       "from: found 'wide'"},
      {"{kind: graph, x: a, colour: red, panels: [{y: b, lines: [{curve: a, name: a}]}]}",
       "colour"},
      {"{kind: theory, topic: dispersal}", "found 'dispersal'"},
      {"{kind: graph, x: a, equal: true, panels: [{y: b, lines: [{curve: a, name: a}]}, {y: b, "
       "lines: [{curve: a, name: a}]}]}",
       "equal scales of several panels"},
      {"{kind: graph, x: a, equal: true, panels: [{y: b, log: true, lines: [{curve: a, name: a}]}]}",
       "or of logarithms"},
      {"{kind: theory}", "topic: found nothing"},
      {"{kind: theory, topic: damping, set: zeta}", ".set: found 'zeta'; allowed: KEY=VALUE"},
      {"{kind: table, head: [a], rows: [['=1 | %.4294967297f']]}", "a format as in"},
      {"{kind: snapshots, field: pressure, runs: [dam/none]}", "times: found nothing"},
      {"{kind: snapshots, field: presure, runs: [dam/none], times: [1]}",
       "did you mean 'pressure'?"},
      {"{kind: snapshots, field: u, runs: [], times: [1]}", "no run"},
      {"{kind: snapshots, field: u, runs: [dam/none], names: [a, b], times: [1]}",
       "another number of names"},
      {"{kind: snapshots, field: u, runs: [dam/none], times: [soon]}", "found 'soon'"},
      {"{kind: snapshots, field: u, runs: [dam/none], times: [1], range: [1, 1]}",
       "a range that ends"},
      {"{kind: snapshots, field: u, runs: [dam/none], times: [1], range: [1]}", "range"},
      {"{kind: snapshots, field: u, runs: [dam/none], times: [1], window: [[0, 0], [0, 1]]}",
       "a window of no size"},
      {"{kind: snapshots, field: u, runs: [dam/none], times: [1], marks: [{at: [0, 1]}]}",
       "name: found nothing"},
      {"{kind: snapshots, field: u, runs: [dam/none], times: [1], marks: [{name: P, at: [0]}]}",
       "marks.P.at: found a list of 1 item"},
      {"{kind: snapshots, field: u, runs: [dam/none], times: [1],\n"
       "         marks: [{name: H, at: [0, 1], to: [0, 1]}]}",
       "a length of zero"},
      {"{kind: snapshots, field: u, runs: [lake/none], times: [1]}", "found run 'lake/none'"},
      {"{kind: snapshots, field: u, runs: [dam/none], surface: bem, times: [1]}",
       "found run 'bem'"},
      {"{kind: table, head: [a, b], rows: [[c]]}", "a list of 1 item"},
      {"{kind: table, head: [], rows: [[c]]}", "no heading"},
      {"{kind: table, head: [a], rows: [['=1 | %d']]}", "a format as in"},
      {"{kind: table, head: [a], rows: [['=1 | %.4f %s']]}", "a format as in"},
      {"{kind: table, head: [a], rows: [['=1 | %.99f']]}", "a format as in"},
  };
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    const char *said = complaint(wrong[i].figure);
    if (!strstr(said, wrong[i].says))
      TEST_FAIL("%s: said '%s', expected '%s'", wrong[i].figure, said, wrong[i].says);
    if (!strstr(said, "found run") && !strstr(said, "entries.yaml:"))
      TEST_FAIL("%s: said without its line", wrong[i].figure);
  }
  EXPECT_STR(complaint("{kind: theory, topic: dispersion}"), "");
}

/* ---- what is made ---- */

static json_t *make(const char *figures) {
  char *words;
  struct problems problems;
  struct gallery_book *book = NULL;
  struct gallery_desk *desk = NULL;
  struct cmp_figures f;
  json_t *made = NULL;
  if (asprintf(&words, ENTRY "%s", figures) < 0) abort();
  const struct gallery_file file = {"entries.yaml", words, strlen(words)};
  EXPECT_OK(gallery_book_read(1, &file, &problems, &book));
  for (size_t i = 0; i < problems.n; i++) fprintf(stderr, "%s\n", problems.text[i]);
  problems_destroy(&problems);
  if (book) {
    EXPECT_OK(gallery_desk_create(book, folder, false, &desk));
    EXPECT_OK(gallery_desk_begin(desk, book->entries));
    EXPECT_OK(cmp_figures_open(folder, &f));
    EXPECT_OK(gallery_figures_make(desk, book->entries, &f, &made));
    cmp_figures_close(&f);
  }
  gallery_desk_destroy(desk);
  gallery_book_destroy(book);
  free(words);
  return made;
}

static char *contents(const char *name) {
  char path[PATH_MAX], file[128], *bytes = NULL;
  size_t n;
  snprintf(file, sizeof file, "figures/%s", name);
  EXPECT_OK(cmp_path_join(folder, file, path));
  EXPECT_OK(cmp_file_read(path, &bytes, &n));
  return bytes ? bytes : strdup("");
}

static bool says(const char *file, const char *words) {
  char *bytes = contents(file);
  const bool said = strstr(bytes, words);
  if (!said) fprintf(stderr, "%s:\n%.1500s\n", file, bytes);
  free(bytes);
  return said;
}

/* Pictures are made of all files, where there is a gnuplot. */
static void expect_drawn(const json_t *made) {
  size_t i, k;
  json_t *figure, *file;
  json_array_foreach(made, i, figure) {
    json_array_foreach(json_object_get(figure, "files"), k, file) {
      const char *missing = json_string_value(json_object_get(file, "missing"));
      if (missing && cmp_child_exists("gnuplot")) TEST_FAIL("figure %zu: %s", i, missing);
    }
  }
}

static const char *text_in(const json_t *list, size_t i, const char *key) {
  const char *text = json_string_value(json_object_get(json_array_get(list, i), key));
  return text ? text : "";
}

/* Lines of the same name share a row of the key and a number, whatever panel they are in. */
static void test_graph(void) {
  json_t *made = make("      - kind: graph\n"
                      "        x: k h\n"
                      "        from: -1\n"
                      "        panels:\n"
                      "          - y: \"a, 'as printed'\"\n"
                      "            top: 2\n"
                      "            level: 1/4\n"
                      "            lines: [{curve: a, name: first}, {curve: b, name: second}]\n"
                      "          - y: '{/Symbol Dm}_{c}'\n"
                      "            lines: [{curve: b, name: first}]\n"
                      "      - kind: graph\n"
                      "        x: k h\n"
                      "        panels: [{y: c, lines: [{curve: c, name: c}]}]\n"
                      "      - {kind: graph, x: k h, log: true,\n"
                      "         panels: [{y: b, lines: [{curve: b, name: b}]}]}\n");
  EXPECT(json_array_size(made) == 3);
  EXPECT(says("P-1c.gp", "set xrange [1:4]")); /* x = 0 is not on that axis */
  expect_drawn(made);
  EXPECT(says("P-1.csv", "curve,name,k h,a  'as printed',Δμ_{c}\n"
                         "0,\"first\",0,1,NaN\n"));
  EXPECT(says("P-1.csv", "0,\"first\",4,0,NaN\n" /* then the panel below */
                         "0,\"first\",NaN,NaN,NaN\n"
                         "0,\"first\",0,NaN,0\n"
                         "0,\"first\",1,NaN,2\n"));
  EXPECT(says("P-1.csv", "1,\"second\",4,8,NaN\n"));
  EXPECT(says("P-1.gp", "plot 0.25 with lines"));
  EXPECT(says("P-1.gp", "set label 'a, ''as printed''' at"));
  EXPECT(says("P-1.gp", "set label 'Δμ_{c}' at"));
  EXPECT(says("P-1.gp", "set xrange [-1:4]"));
  EXPECT(says("P-1.gp", ":2]\nset ytics"));
  EXPECT_STR(text_in(made, 0, "failure"), "");
  EXPECT(strstr(text_in(made, 1, "failure"), "needs itself"));
  json_decref(made);
}

/* 4 of x and 2 of y: the panel, 342 px wide in one column, is half as high. */
static void test_equal_scales(void) {
  json_t *made = make("      - {kind: graph, x: x, wide: false, equal: true, from: 0, to: 4, panels: "
                      "[{y: y, bottom: 0, top: 2, lines: [{curve: a, name: first}]}]}\n");
  double top, bottom, height;
  char *script = NULL, *at;
  size_t n;
  char path[PATH_MAX];
  expect_drawn(made);
  EXPECT_OK(cmp_path_join(folder, "figures/P-1.gp", path));
  EXPECT_OK(cmp_file_read(path, &script, &n));
  EXPECT((at = strstr(script, "set tmargin at screen narrow ? ")) &&
         sscanf(at, "set tmargin at screen narrow ? %lf", &top) == 1);
  EXPECT((at = strstr(script, "set bmargin at screen narrow ? ")) &&
         sscanf(at, "set bmargin at screen narrow ? %lf", &bottom) == 1);
  EXPECT((at = strstr(script, "high = column ? ")) &&
         sscanf(at, "high = column ? %*f : %lf", &height) == 1);
  EXPECT_NEAR((top - bottom) * height, 342 / 2.0, 0.02);
  free(script);
  json_decref(made);
}

static void test_theory(void) {
  json_t *made = make("      - {kind: theory, topic: damping, set: 'zeta=1,1.005 points=11'}\n");
  EXPECT(says("P-1.csv", "curve,name,"));
  EXPECT(says("P-1.gp", "zeta = 1.005"));
  expect_drawn(made);
  json_decref(made);
}

static void test_table(void) {
  static const char *const cells[] = {"a \"b\"", "1.00", "+2.500e-01 H", "–", "1e+20", ""};
  json_t *made = make("      - kind: table\n"
                      "        head: [one, two, three]\n"
                      "        rows:\n"
                      "          - ['a \"b\"', '=at(\"a\", 0) | %.2f', '=1/4 | %+.3e H']\n"
                      "          - ['=at(\"a\", 99)', '=1e20 || 0 ? 1e20 : 0 | %.3f', '']\n");
  const json_t *table = json_object_get(json_array_get(made, 0), "table");
  EXPECT(json_array_size(json_object_get(table, "head")) == 3);
  for (size_t k = 0; k < 6; k++)
    EXPECT_STR(json_string_value(
                   json_array_get(json_array_get(json_object_get(table, "rows"), k / 3), k % 3)),
               cells[k]);
  EXPECT(says("P-1.csv", "\"one\",\"two\",\"three\"\n\"a \"\"b\"\"\",1.00,\"'+2.500e-01 H\"\n"));
  json_decref(made);
}

/* ---- snapshots of a result that is written here ---- */

enum { SIDE = 4, OUTPUTS = 3 };
static const double H = 0.5, g = 9.81, density = 1000;

static void result_write(const char *run) {
  char path[PATH_MAX], file[64];
  struct result *w;
  struct geo_lines walls = {0};
  double x[SIDE * SIDE], y[SIDE * SIDE], p[SIDE * SIDE], u[SIDE * SIDE], v[SIDE * SIDE];
  const double tank[][2] = {{0, 2}, {0, 0}, {4, 0}, {4, 2}};
  EXPECT_OK(geo_lines_begin(&walls, false));
  for (size_t i = 0; i < 4; i++) EXPECT_OK(geo_lines_add(&walls, tank[i][0] * H, tank[i][1] * H));
  const struct result_about about = {.solver = "made up",
                                     .run = run,
                                     .version = "",
                                     .revision = "",
                                     .title = "none",
                                     .case_text = "",
                                     .fingerprint = "",
                                     .water_fingerprint = "",
                                     .H = H,
                                     .g = g,
                                     .density = density,
                                     .resolution = SIDE,
                                     .walls = &walls};
  snprintf(file, sizeof file, "dam/%s.h5", run);
  EXPECT_OK(cmp_path_join(folder, file, path));
  EXPECT_OK(result_begin(path, &about, &w));
  for (int k = 0; k < OUTPUTS; k++) {
    for (int i = 0; i < SIDE * SIDE; i++) {
      x[i] = (i % SIDE + 0.5) / SIDE * H;
      y[i] = (i / SIDE + 0.5) / SIDE * H;
      p[i] = density * g * (H - y[i]);
      u[i] = (k - 1) * sqrt(g * H);
      v[i] = 0;
    }
    const struct result_field fields[] = {{"pressure", "Pa", "", p, NULL},
                                          {"velocity", "m/s", "", u, v}};
    EXPECT_OK(result_points(w, k * sqrt(H / g), SIDE * SIDE, x, y, RESULT_VERTICES, 2, fields));
    EXPECT_OK(result_flush(w));
  }
  EXPECT_OK(result_finish(w));
  result_destroy(w);
  geo_lines_destroy(&walls);
}

static void test_snapshots(void) {
  char path[PATH_MAX];
  EXPECT_OK(cmp_path_join(folder, "dam", path));
  EXPECT_OK(cmp_directory_make(path));
  result_write("none");
  result_write("more");
  json_t *made =
      make("      - {kind: snapshots, field: u, runs: [dam/none, dam/more], names: [N, M],\n"
           "         times: [0, 1.3, 9], surface: dam/none}\n"
           "      - {kind: snapshots, field: pressure, runs: [dam/none], times: [0, 2],\n"
           "         across: times, range: [0, 2], window: [[0, 0], [2, 1.5]],\n"
           "         marks: [{name: P1, at: [1.5, 0.3]}, {name: 2 H, at: [0, 1.2], to: [2, 1.2]}]}\n"
           "      - {kind: snapshots, field: a_x, runs: [dam/none], times: [0]}\n"
           "      - {kind: snapshots, field: u, runs: [dam/lost], times: [0]}\n"
           "      - {kind: snapshots, field: excess, runs: [dam/none], times: [2], level: 2}\n");
  EXPECT(says("P-1-points-1.csv", "x [H],y [H],u [sqrt(g H)]\n0.125,0.125,-1\n"));
  EXPECT(says("P-1-points-4.csv", "0.125,0.125,0\n")); /* t = 1.3 of the second run: at 1 */
  EXPECT(says("P-1.gp", "set cbrange [-1:1]"));        /* as far on both sides */
  EXPECT(says("P-1.gp", "#3b4cc0"));                   /* the map for that */
  EXPECT(says("P-1.gp", "'(at 1)'"));
  EXPECT(says("P-1.gp", "'no output then'"));
  EXPECT(says("P-1.gp", "t = 1.3 √(H/g)"));
  EXPECT(says("P-1.gp", "1:2:(0.125):(0.125):3 with boxxyerror")); /* half of dx = H/4 */
  EXPECT(says("P-1-surfaces.csv", "0,\"tank\",0,4,2\n"));
  EXPECT(says("P-1b-points-2.csv", "x [H],y [H],pressure [rho g H]\n0.125,0.125,0.875\n"));
  EXPECT(says("P-1b.gp", "set xrange [0:2]\nset yrange [0:1.5]"));
  EXPECT(says("P-1b.gp", "#440154"));
  EXPECT(says("P-1b.gp", "set label 'P1' at 1.5,0.3 right")); /* more room on that side */
  EXPECT(says("P-1b.gp", "set arrow from 0,1.2 to 2,1.2 heads"));
  EXPECT(says("P-1b.gp", "set label '2 H' at 1,1.2 center"));
  EXPECT(says("P-1.gp", "pngcairo size 2160,")); /* 180 mm by 300 an inch are 2126 */
  EXPECT(says("P-1e-points-1.csv", "x [H],y [H],excess [rho g H]\n0.125,0.125,-1\n"));
  EXPECT(strstr(text_in(made, 2, "failure"), "no points with acceleration"));
  EXPECT(strstr(text_in(made, 3, "failure"), "lost"));
  EXPECT_OK(cmp_path_join(folder, "figures/P-1c.gp", path));
  EXPECT(access(path, F_OK) != 0); /* nothing half-made is left */
  if (cmp_child_exists("gnuplot")) {
    char *png = contents("P-1.thumb.png");
    EXPECT(!strncmp(png + 1, "PNG", 3));
    free(png);
  }
  expect_drawn(made);
  json_decref(made);
}

int main(void) {
  if (!mkdtemp(folder)) return 1;
  RUN(test_wrong_figures);
  RUN(test_graph);
  RUN(test_equal_scales);
  RUN(test_theory);
  RUN(test_table);
  RUN(test_snapshots);
  char command[sizeof folder + 16];
  snprintf(command, sizeof command, "rm -rf %s", folder);
  if (system(command) != 0) return 1;
  return TEST_RESULT;
}
