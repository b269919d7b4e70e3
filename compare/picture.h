/* Figures that have been drawn, inside a page. */
#pragma once
#include "common/base/status.h"
#include "compare/figure.h"
#include "compare/markup.h"

/* The PNG of a heavy one, the SVG of others; its caption is what stands for it. ERR_IO. */
enum status cmp_picture_write(struct markup *m, const struct cmp_figures *figures,
                              const struct cmp_figure *fig);
