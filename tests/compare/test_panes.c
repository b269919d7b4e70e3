/* What is beside panels that share a picture. */
#include "compare/panes.h"

#include <stdlib.h>

#include "tests/test.h"

/* What the colours are of stands between the picture's edges and above the box, of a tank as long
 * as any: beside numbers as long as 0.125 it was cut off. */
static void test_what_colours_are_of_is_in_the_picture(void) {
  for (double aspect = 1; aspect < 1000; aspect *= 3.1) {
    const struct geo_box view = {{0, 0}, {aspect, 1}};
    const struct cmp_layout l = cmp_panes_layout(&view, 2);
    char *script = NULL;
    size_t n;
    struct cmp_figure fig = {.width = CMP_PANELS_WIDTH, .height = l.total};
    fig.script = open_memstream(&script, &n);
    if (!fig.script) abort();
    cmp_pane_colours(&fig, &l, "|u| / √(g H)");
    fclose(fig.script);
    const char *at = strstr(script, "set label 2 '|u| / √(g H)' at screen ");
    const char *box = strstr(script, "origin screen ");
    double x, y, left, low, high,
        half_width = 12 * 3.5; /* px, of twelve letters; they and the numbers are 12 high */
    EXPECT(at && sscanf(strstr(at, "screen"), "screen %lf, screen %lf center", &x, &y) == 2);
    EXPECT(box && sscanf(box, "origin screen %lf, screen %lf size screen 0.016, screen %lf", &left,
                         &low, &high) == 3);
    EXPECT(x * fig.width + half_width < fig.width);
    EXPECT(x * fig.width - half_width > CMP_PANELS_WIDTH - CMP_PANES_RIGHT);
    EXPECT(y < 1 && (y - low - high) * fig.height > 6 + 8);
    free(script);
  }
}

int main(void) {
  RUN(test_what_colours_are_of_is_in_the_picture);
  return TEST_RESULT;
}
