/* What is written into pictures of water: places, and lengths between two. */
#pragma once
#include <stdio.h>

#include "common/base/geometry.h"
#include "gallery/reader.h"

struct gallery_mark {
  char *name;
  int at, to;              /* nodes */
  double place[2], end[2]; /* H; `end` NaN: a place, else a length */
};
struct gallery_marks {
  size_t n;
  struct gallery_mark *mark; /* [n], owned */
};

/* The list `node`; an absent one is empty. ERR_MEMORY. */
enum status gallery_marks_read(struct gallery_reader *r, int node, const char *path,
                               struct gallery_marks *marks);
void gallery_marks_free(struct gallery_marks *marks);

/* Sets gnuplot's labels and arrows for the next plot, which shows `view`. */
void gallery_marks_write(const struct gallery_marks *marks, const struct geo_box *view,
                         FILE *script);
