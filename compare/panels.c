#include "compare/panels.h"

#include <math.h>
#include <string.h>

#include "compare/text.h"

enum { LEFT = 104, LEFT_OF_COLUMN = 88, RIGHT = 20, TOP = 40, GAP = 18 };
enum { KEY_LONGEST = 36 };
#define LABEL_X 18.0 /* px: the middle of the label of the y axis */

double cmp_panels_width(bool narrow) {
  return narrow ? CMP_PANELS_NARROW - LEFT_OF_COLUMN - RIGHT : CMP_PANELS_WIDTH - LEFT - RIGHT;
}

struct cmp_key cmp_key_of(size_t n, size_t longest) {
  /* gnuplot lets a key be as wide as the plot that draws it */
  struct cmp_key key;
  for (int k = 0; k < 2; k++) {
    const int columns = (int)cmp_panels_width(k) / (84 + 9 * (int)longest); /* a sample and text of 14 px */
    key.columns[k] = columns > 1 ? columns : 1;
    key.height[k] = 70 + 19 * (((int)n + key.columns[k] - 1) / key.columns[k]);
  }
  return key;
}

void cmp_key_place(const struct cmp_figure *fig, const struct cmp_key *key) {
  fprintf(fig->script,
          "set key at screen 0.5, screen %.1f/high bottom center horizontal maxcols (narrow ? %d : "
          "%d) samplen 2.2 reverse Left noenhanced\n",
          8.0, key->columns[1], key->columns[0]);
}

void cmp_panels_heights(size_t n, int panel_height, const struct cmp_key *key, int height[2]) {
  const int panels = (int)n;
  for (int k = 0; k < 2; k++)
    height[k] = TOP + panels * panel_height + GAP * (panels - 1) + key->height[k];
}

double cmp_panel_height(const struct cmp_panels *p) {
  double n = (double)p->n;
  const int key = p->key.height[p->fig->width <= CMP_PANELS_NARROW];
  return (p->fig->height - TOP - key - GAP * (n - 1)) / n;
}

double cmp_tick_step(const struct cmp_frame *frame) {
  double rough = (frame->high - frame->low) / 5, power = pow(10, floor(log10(rough)));
  double digit = rough / power;
  return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

void cmp_panel_place(const struct cmp_panels *p, size_t k, const char *x_label) {
  const struct cmp_figure *fig = p->fig;
  const double height = cmp_panel_height(p), top = TOP + (double)k * (height + GAP);
  cmp_figure_margins(fig, &(struct cmp_margins){LEFT, RIGHT, top, height},
                     &(struct cmp_margins){LEFT_OF_COLUMN, RIGHT, top, height});
  if (k + 1 < p->n) {
    fputs("set format x ''\nunset xlabel\nunset key\n", fig->script);
    return;
  }
  fprintf(fig->script, "set format x\nset xlabel '%s' offset 0, character 0.4\n", x_label);
  cmp_key_place(fig, &p->key);
}

/* The label of the y axis has its place on the page: beside wide tick labels, gnuplot's own would
 * leave it. */
void cmp_panel_labels(const struct cmp_panels *p, const char *label, const char *title) {
  FILE *s = p->fig->script;
  fprintf(s, "set label '%s' at screen %.1f/wide, graph 0.5 center rotate\n", label, LABEL_X);
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
