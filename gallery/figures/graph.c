/* Curves of the entry in panels above each other, which share the axis. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/graph.h"
#include "gallery/desk.h"
#include "gallery/drawer.h"
#include "gallery/figures/keys.h"

struct graph_line {
  char *curve, *name;
  bool points;
};

struct graph_panel {
  char *y, *level;
  bool log;
  double ends[2]; /* bottom and top; NaN: by its curves */
  int lines;      /* the node of their list */
  size_t n;
  struct graph_line *line;
};

struct graph_spec {
  char *x;
  bool log, wide, equal;
  double ends[2]; /* from and to */
  int panels;     /* the node of their list */
  size_t n;
  struct graph_panel *panel;
};

/* ---- reading ---- */

enum { LABEL = 200 }; /* bytes of one, at most */

#define FLAG(struct_, member, standard, text)                                                      \
  {                                                                                                \
    .key = #member, .type = PARAM_BOOL, .offset = offsetof(struct_, member), .value = standard,    \
    .help = text                                                                                   \
  }
#define END(struct_, name, k, text)                                                                \
  {                                                                                                \
    .key = name, .type = PARAM_REAL, .offset = offsetof(struct_, ends) + (k) * sizeof(double),     \
    .value = "", .help = text                                                                      \
  }

static const struct param graph_rows[] = {
    TEXT(struct graph_spec, x, LABEL, NULL, "label of the axis that the panels share"),
    FLAG(struct graph_spec, log, "false", "whether that is logarithmic"),
    END(struct graph_spec, "from", 0, "where it begins"),
    END(struct graph_spec, "to", 1, "where it ends"),
    FLAG(struct graph_spec, wide, "true", "two columns of a journal, else one"),
    FLAG(struct graph_spec, equal, "false", "x and y to one scale, in one panel"),
    NODE(struct graph_spec, panels, NULL, "a list of panels"),
};
static const struct param panel_rows[] = {
    TEXT(struct graph_panel, y, LABEL, NULL, "label of its axis"),
    FLAG(struct graph_panel, log, "false", "whether that is logarithmic"),
    END(struct graph_panel, "bottom", 0, "where it begins"),
    END(struct graph_panel, "top", 1, "where it ends"),
    TEXT(struct graph_panel, level, 200, "", "a formula: a dashed line across it"),
    NODE(struct graph_panel, lines, NULL, "a list of lines"),
};
static const struct param line_rows[] = {
    TEXT(struct graph_line, curve, 64, NULL, "a curve of the entry"),
    TEXT(struct graph_line, name, 100, NULL, "its name in the key"),
    FLAG(struct graph_line, points, "false", "symbols in place of a line"),
};

static void ends_check(struct gallery_reader *r, int node, const char *path, const double ends[2],
                       bool log) {
  if (log && (ends[0] <= 0 || ends[1] <= 0))
    gallery_complain(r, node, path, "a logarithmic axis that reaches zero", "ends above 0", "");
  else if (ends[0] >= ends[1])
    gallery_complain(r, node, path, "an axis that ends where it begins, or before",
                     "an end above its beginning", "");
}

static enum status panel_read(struct gallery_reader *r, int node, const char *path,
                              struct graph_panel *p) {
  const struct case_block block = {panel_rows, ROWS(panel_rows), p, NULL};
  char key[CASE_PATH + 16];
  p->ends[0] = p->ends[1] = NAN;
  if (!case_doc_read(&r->doc, node, path, 0, 1, &block)) return OK;
  ends_check(r, node, path, p->ends, p->log);
  snprintf(key, sizeof key, "%s.level", path);
  gallery_check_formula(r, case_doc_member(&r->doc, node, "level"), key, p->level, false);
  const struct gallery_list list = gallery_list_of(r, p->lines, path, "lines", 1);
  TRY(array_create(&p->line, list.n, "lines"));
  p->n = list.n;
  for (size_t i = 0; i < list.n; i++) {
    char full[CASE_PATH];
    const int item = gallery_list_item(r, &list, i, full);
    const struct case_block line = {line_rows, ROWS(line_rows), &p->line[i], NULL};
    case_doc_read(&r->doc, item, full, 0, 1, &line);
    snprintf(key, sizeof key, "%s.curve", full);
    gallery_check_curve(r, case_doc_member(&r->doc, item, "curve"), key, p->line[i].curve);
  }
  return OK;
}

static void destroy(void *spec) {
  struct graph_spec *s = spec;
  for (size_t k = 0; s && k < s->n; k++) {
    struct graph_panel *p = &s->panel[k];
    for (size_t i = 0; i < p->n; i++) params_release(line_rows, ROWS(line_rows), &p->line[i]);
    params_release(panel_rows, ROWS(panel_rows), p);
    free(p->line);
  }
  if (!s) return;
  params_release(graph_rows, ROWS(graph_rows), s);
  free(s->panel);
  free(s);
}

static enum status panels_read(struct gallery_reader *r, const char *path, struct graph_spec *s) {
  const struct gallery_list list = gallery_list_of(r, s->panels, path, "panels", 1);
  TRY(array_create(&s->panel, list.n, "panels"));
  s->n = list.n;
  for (size_t k = 0; k < list.n; k++) {
    char full[CASE_PATH];
    const int item = gallery_list_item(r, &list, k, full);
    TRY(panel_read(r, item, full, &s->panel[k]));
  }
  if (s->equal && (list.n > 1 || s->log || (list.n && s->panel[0].log)))
    gallery_complain(r, s->panels, path, "equal scales of several panels, or of logarithms",
                     "equal of one panel that has none", "");
  return OK;
}

static enum status read(struct gallery_reader *r, int node, const char *path, void **spec) {
  struct graph_spec *s = calloc(1, sizeof *s);
  const size_t faults = r->doc.faults;
  enum status status = OK;
  *spec = NULL;
  CHECK(s, ERR_MEMORY, "no memory for a figure");
  s->ends[0] = s->ends[1] = NAN;
  if (gallery_figure_read(r, node, path, graph_rows, ROWS(graph_rows), s)) {
    ends_check(r, node, path, s->ends, s->log);
    status = panels_read(r, path, s);
  }
  if (status == OK && r->doc.faults == faults)
    *spec = s;
  else
    destroy(s);
  return status;
}

/* ---- drawing ---- */

/* Lines of the same name and look are one curve of the figure, whose rows have a column for each
 * panel. */
struct graph_curves {
  const struct graph_spec *spec;
  size_t columns, n;
  struct cmp_graph_curve *curve; /* [n] */
  double **row;                  /* [n], theirs, owned */
  size_t *room;                  /* [n] doubles of it */
};

static size_t curve_of(struct graph_curves *c, const struct graph_line *line) {
  size_t k = 0;
  while (k < c->n &&
         (strcmp(c->curve[k].name, line->name) || c->curve[k].points != line->points))
    k++;
  if (k == c->n)
    c->curve[c->n++] = (struct cmp_graph_curve){.name = line->name, .points = line->points};
  return k;
}

/* The row breaks a line, until it is filled. */
static enum status row_add(struct graph_curves *c, size_t k, double **row) {
  const size_t at = c->curve[k].n * c->columns;
  TRY(array_grow(&c->row[k], &c->room[k], at + c->columns, "a figure"));
  *row = c->row[k] + at;
  for (size_t i = 0; i < c->columns; i++) (*row)[i] = NAN;
  c->curve[k].n++;
  return OK;
}

static enum status line_add(struct gallery_desk *desk, struct graph_curves *c, size_t panel,
                            const struct graph_line *line) {
  const struct gallery_curve *curve;
  const size_t k = curve_of(c, line);
  double *row;
  TRY(gallery_desk_curve(desk, line->curve, &curve));
  if (c->curve[k].n) TRY(row_add(c, k, &row));
  for (size_t i = 0; i < curve->n; i++) {
    TRY(row_add(c, k, &row));
    row[0] = curve->x[i];
    row[1 + panel] = curve->y[i];
  }
  return OK;
}

static enum status curves_take(struct gallery_desk *desk, struct graph_curves *c) {
  size_t lines = 0;
  for (size_t p = 0; p < c->spec->n; p++) lines += c->spec->panel[p].n;
  TRY(array_create(&c->curve, lines, "a figure"));
  TRY(array_create(&c->row, lines, "a figure"));
  TRY(array_create(&c->room, lines, "a figure"));
  for (size_t p = 0; p < c->spec->n; p++)
    for (size_t i = 0; i < c->spec->panel[p].n; i++)
      TRY(line_add(desk, c, p, &c->spec->panel[p].line[i]));
  for (size_t k = 0; k < c->n; k++) c->curve[k].row = c->row[k];
  return OK;
}

static void curves_free(struct graph_curves *c) {
  for (size_t k = 0; c->row && k < c->n; k++) free(c->row[k]);
  free(c->row);
  free(c->room);
  free(c->curve);
}

/* Words of a column: as a label, within single quotes of gnuplot's, and at the head of a table. */
struct words {
  char label[4 * LABEL + 1], head[2 * LABEL + 1], level[32];
};

/* The letter that stands for `c` in gnuplot's Symbol font, which browsers do not have. */
static const char *greek(char c) {
  static const char *const small[] = {"α", "β", "χ", "δ", "ε", "φ", "γ", "η", "ι",
                                      "ϕ", "κ", "λ", "μ", "ν", "ο", "π", "θ", "ρ",
                                      "σ", "τ", "υ", "ϖ", "ω", "ξ", "ψ", "ζ"};
  static const char *const large[] = {"Α", "Β", "Χ", "Δ", "Ε", "Φ", "Γ", "Η", "Ι",
                                      "ϑ", "Κ", "Λ", "Μ", "Ν", "Ο", "Π", "Θ", "Ρ",
                                      "Σ", "Τ", "Υ", "ς", "Ω", "Ξ", "Ψ", "Ζ"};
  return c >= 'a' && c <= 'z' ? small[c - 'a'] : c >= 'A' && c <= 'Z' ? large[c - 'A'] : NULL;
}

/* "{/Symbol m}_c" as "μ_c". */
static void letters_replace(const char *text, char *out) {
  static const char opening[] = "{/Symbol ";
  while (*text) {
    if (strncmp(text, opening, sizeof opening - 1) != 0 || !strchr(text, '}')) {
      *out++ = *text++;
      continue;
    }
    for (text += sizeof opening - 1; *text != '}'; text++) {
      const char *letter = greek(*text);
      if (letter)
        out = stpcpy(out, letter);
      else
        *out++ = *text;
    }
    text++;
  }
  *out = 0;
}

static void words_set(struct words *w, const char *text) {
  char plain[2 * LABEL + 1];
  size_t n = 0, m = 0;
  letters_replace(text, plain);
  for (const char *c = plain; *c; c++) {
    if (*c == '\'') w->label[n++] = '\'';
    w->label[n++] = *c;
    w->head[m++] = *c == ',' || *c == '"' ? ' ' : *c;
  }
  w->label[n] = w->head[m] = 0;
}

static enum status column_set(struct gallery_desk *desk, const struct graph_panel *p, int panel,
                              struct words *w, struct cmp_graph_column *column) {
  words_set(w, p->y);
  *column = (struct cmp_graph_column){
      .head = w->head, .label = w->label, .panel = panel, .log = p->log, .ends = p->ends};
  if (!p->level) return OK;
  double level;
  TRY(gallery_desk_formula(desk, p->level, &level));
  snprintf(w->level, sizeof w->level, "%.10g", level);
  if (isfinite(level)) column->level = w->level;
  return OK;
}

static enum status draw(struct gallery_desk *desk, const struct gallery_entry *e, const void *spec,
                        const char *name, struct cmp_figures *f) {
  const struct graph_spec *s = spec;
  struct graph_curves c = {.spec = s, .columns = 1 + s->n};
  struct cmp_graph_column *column = NULL;
  struct words *words = NULL;
  enum status status;
  (void)e;
  ATTEMPT(curves_take(desk, &c));
  ATTEMPT(array_create(&column, c.columns, "a figure"));
  ATTEMPT(array_create(&words, c.columns, "a figure"));
  words_set(&words[0], s->x);
  column[0] = (struct cmp_graph_column){
      .head = words[0].head, .label = words[0].label, .log = s->log, .ends = s->ends};
  for (size_t k = 0; k < s->n; k++)
    ATTEMPT(column_set(desk, &s->panel[k], (int)k, &words[1 + k], &column[1 + k]));
  ATTEMPT(cmp_graph_write(&(struct cmp_graph){.name = name,
                                              .narrow = !s->wide,
                                              .equal = s->equal,
                                              .n_columns = c.columns,
                                              .n_curves = c.n,
                                              .column = column,
                                              .curve = c.curve},
                          f));
done:
  free(column);
  free(words);
  curves_free(&c);
  return status;
}

const struct gallery_drawer gallery_drawer_graph = {
    .name = "graph",
    .help = "curves of the entry in panels that share an axis",
    .read = read,
    .destroy = destroy,
    .draw = draw,
};
