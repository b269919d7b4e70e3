#include "gallery/source.h"

#include <string.h>

#include "gallery/sources/list.h"

#define X(name) extern const struct gallery_source gallery_source_##name;
GALLERY_SOURCES(X)
#undef X

#define X(name) &gallery_source_##name,
const struct gallery_source *const gallery_sources[] = {GALLERY_SOURCES(X) NULL};
#undef X

const struct gallery_source *gallery_source_find(const char *name) {
  for (size_t i = 0; gallery_sources[i]; i++)
    if (!strcmp(gallery_sources[i]->name, name)) return gallery_sources[i];
  return NULL;
}
