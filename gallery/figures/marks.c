#include "gallery/figures/marks.h"

#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "compare/text.h"
#include "gallery/drawer.h"
#include "gallery/figures/keys.h"

/* ---- reading ---- */

static const struct param rows[] = {
    TEXT(struct gallery_mark, name, 40, NULL, "what is written there"),
    NODE(struct gallery_mark, at, NULL, "where, [x, y], H"),
    NODE(struct gallery_mark, to, "", "the other end of a length, [x, y], H"),
};
static const struct param number = {.key = "number", .type = PARAM_REAL, .help = "a number"};

static void mark_read(struct gallery_reader *r, int node, const char *path,
                      struct gallery_mark *m) {
  char full[CASE_PATH + 8];
  const struct case_block block = {rows, ROWS(rows), m, NULL};
  m->end[0] = m->end[1] = NAN;
  if (!case_doc_read(&r->doc, node, path, 0, 1, &block)) return;
  snprintf(full, sizeof full, "%s.at", path);
  case_read_pair(&r->doc, m->at, full, &number, "numbers", m->place);
  snprintf(full, sizeof full, "%s.to", path);
  if (m->to && case_read_pair(&r->doc, m->to, full, &number, "numbers", m->end) &&
      m->end[0] == m->place[0] && m->end[1] == m->place[1])
    gallery_complain(r, m->to, full, "a length of zero", "another place", "");
}

enum status gallery_marks_read(struct gallery_reader *r, int node, const char *path,
                               struct gallery_marks *marks) {
  char full[CASE_PATH];
  const struct gallery_list list = gallery_list_of(r, node, path, "marks", 0);
  TRY(array_create(&marks->mark, list.n, "marks"));
  marks->n = list.n;
  for (size_t k = 0; k < list.n; k++) {
    const int item = gallery_list_item(r, &list, k, full);
    mark_read(r, item, full, &marks->mark[k]);
  }
  return OK;
}

void gallery_marks_free(struct gallery_marks *marks) {
  for (size_t k = 0; k < marks->n; k++) params_release(rows, ROWS(rows), &marks->mark[k]);
  free(marks->mark);
}

/* ---- writing ---- */

/* Beside it, on the side where there is more room. */
static void place_write(const struct gallery_mark *m, const struct geo_box *view, FILE *script) {
  const bool left = m->place[0] > (view->min[0] + view->max[0]) / 2;
  fputs("set label ", script);
  cmp_gnuplot_string(script, m->name);
  fprintf(
      script,
      " at %.6g,%.6g %s offset character %g,0 front noenhanced point pointtype 7 pointsize 0.7\n",
      m->place[0], m->place[1], left ? "right" : "left", left ? -0.8 : 0.8);
}

/* An arrow with two heads, and its name beside its middle. */
static void length_write(const struct gallery_mark *m, FILE *script) {
  const bool upright = fabs(m->end[1] - m->place[1]) > fabs(m->end[0] - m->place[0]);
  fprintf(script,
          "set arrow from %.6g,%.6g to %.6g,%.6g heads filled front linewidth 1 "
          "linecolor '#000000'\nset label ",
          m->place[0], m->place[1], m->end[0], m->end[1]);
  cmp_gnuplot_string(script, m->name);
  fprintf(script, " at %.6g,%.6g %s front noenhanced\n", (m->place[0] + m->end[0]) / 2,
          (m->place[1] + m->end[1]) / 2,
          upright ? "left offset character 0.8,0" : "center offset character 0,0.7");
}

void gallery_marks_write(const struct gallery_marks *marks, const struct geo_box *view,
                         FILE *script) {
  for (size_t k = 0; k < marks->n; k++)
    if (isnan(marks->mark[k].end[0]))
      place_write(&marks->mark[k], view, script);
    else
      length_write(&marks->mark[k], script);
}
