#include "compare/picture.h"

#include <stdlib.h>

#include "compare/output.h"

enum status cmp_picture_write(struct markup *m, const struct cmp_figures *figures,
                              const struct cmp_figure *fig) {
  char file[128], path[PATH_MAX], *bytes;
  size_t n;
  snprintf(file, sizeof file, "%s%s", fig->name, fig->raster ? ".png" : ".svg");
  TRY(cmp_path_join(figures->dir, file, path));
  TRY(cmp_file_read(path, &bytes, &n));
  cmp_markup_image(m, fig->raster ? "image/png" : "image/svg+xml", bytes, n, fig->caption,
                   fig->width, fig->height);
  free(bytes);
  return OK;
}
