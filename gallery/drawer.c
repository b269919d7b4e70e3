#include "gallery/drawer.h"

#include <string.h>

#include "gallery/figures/list.h"

#define X(name) extern const struct gallery_drawer gallery_drawer_##name;
GALLERY_DRAWERS(X)
#undef X

#define X(name) &gallery_drawer_##name,
const struct gallery_drawer *const gallery_drawers[] = {GALLERY_DRAWERS(X) NULL};
#undef X

const struct gallery_drawer *gallery_drawer_find(const char *name) {
  for (size_t i = 0; gallery_drawers[i]; i++)
    if (!strcmp(gallery_drawers[i]->name, name)) return gallery_drawers[i];
  return NULL;
}
