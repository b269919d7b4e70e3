#include "compare/panels.h"

#include <math.h>
#include <string.h>

#include "compare/text.h"

enum { LEFT = 104, RIGHT = 20, TOP = 40, GAP = 18 };
enum { KEY_LONGEST = 36 };
#define LABEL_X 22.0 /* px: the middle of the label of the y axis */

int cmp_key_columns(size_t longest, int width) {
  int columns = width / (84 + 9 * (int)longest); /* a sample and text of 14 px */
  return columns > 1 ? columns : 1;
}

int cmp_key_height(size_t n, int columns) {
  return 70 + 19 * (int)((n + (size_t)columns - 1) / (size_t)columns);
}

int cmp_panels_height(size_t n, int panel_height, int bottom) {
  int panels = (int)n;
  return TOP + panels * panel_height + GAP * (panels - 1) + bottom;
}

double cmp_panel_height(const struct cmp_panels *p) {
  double n = (double)p->n;
  return (p->fig->height - TOP - p->bottom - GAP * (n - 1)) / n;
}

double cmp_tick_step(const struct cmp_frame *frame) {
  double rough = (frame->high - frame->low) / 5, power = pow(10, floor(log10(rough)));
  double digit = rough / power;
  return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

void cmp_panel_place(const struct cmp_panels *p, size_t k, const char *x_label) {
  const struct cmp_figure *fig = p->fig;
  double height = cmp_panel_height(p), top = TOP + (double)k * (height + GAP);
  fprintf(fig->script,
          "set lmargin at screen %.5f\nset rmargin at screen %.5f\nset tmargin at screen %.5f\n"
          "set bmargin at screen %.5f\n",
          (double)LEFT / fig->width, 1 - (double)RIGHT / fig->width, 1 - top / fig->height,
          1 - (top + height) / fig->height);
  if (k + 1 == p->n)
    fprintf(fig->script,
            "set format x\nset xlabel '%s' offset 0, character 0.4\n"
            "set key at screen 0.5, screen %.5f bottom center horizontal maxcols %d samplen 2.2 "
            "reverse Left noenhanced\n",
            x_label, 8.0 / fig->height, p->columns);
  else
    fputs("set format x ''\nunset xlabel\nunset key\n", fig->script);
}

/* The label of the y axis has its place on the page: beside wide tick labels, gnuplot's own would
 * leave it. */
void cmp_panel_labels(const struct cmp_panels *p, const char *label, const char *title) {
  FILE *s = p->fig->script;
  fprintf(s, "set label '%s' at screen %.5f, graph 0.5 center rotate\n", label,
          LABEL_X / p->fig->width);
  if (!title) return;
  fputs("set label ", s);
  cmp_key_string(s, title, NULL);
  fputs(" at graph 0, graph 1 offset character 0.7, character -0.9 left front boxed noenhanced "
        "font small\n",
        s);
}

/* Bytes of the first `most` characters of UTF-8 text, and how many there are. */
static size_t characters(const char *text, size_t most, size_t *n) {
  size_t bytes = 0;
  for (*n = 0; text[bytes]; bytes++) {
    bool begins = (text[bytes] & 0xc0) != 0x80;
    if (begins && *n == most) break;
    *n += begins;
  }
  return bytes;
}

size_t cmp_key_length(const char *label) {
  size_t n;
  characters(label, KEY_LONGEST, &n);
  return n;
}

void cmp_key_string(FILE *script, const char *label, const char *note) {
  char text[4 * KEY_LONGEST + 96];
  size_t n, bytes = characters(label, KEY_LONGEST, &n);
  snprintf(text, sizeof text, "%.*s%s%s", (int)bytes, label, label[bytes] ? "…" : "",
           note ? note : "");
  cmp_gnuplot_string(script, text);
}
