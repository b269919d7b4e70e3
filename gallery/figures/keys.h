/* How the mappings of figures are read. */
#pragma once
#include "gallery/reader.h"

/* Reads the mapping of a figure with the rows of its drawer, beside which it has `kind` and
 * `caption`, which the entry reads. True when there was no problem. */
bool gallery_figure_read(struct gallery_reader *r, int node, const char *path,
                         const struct param *rows, size_t n, void *into);
