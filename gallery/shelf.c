#include "gallery/shelf.h"

#include <stdio.h>
#include <string.h>

#include "common/base/array.h"

static const char entries[] = "gallery/entries/";

const struct gallery_shelf_file *gallery_shelf_find(const char *path) {
  for (size_t i = 0; i < gallery_shelf_count; i++)
    if (!strcmp(gallery_shelf[i].path, path)) return &gallery_shelf[i];
  return NULL;
}

const struct gallery_shelf_file *gallery_shelf_find_case(const char *name) {
  static const char *const folders[] = {"gallery/cases", "cases"};
  const struct gallery_shelf_file *found = NULL;
  char path[256];
  for (size_t i = 0; !found && i < sizeof folders / sizeof *folders; i++)
    if (snprintf(path, sizeof path, "%s/%s", folders[i], name) < (int)sizeof path)
      found = gallery_shelf_find(path);
  return found;
}

enum status gallery_shelf_entries(size_t *n, struct gallery_file **files) {
  TRY(array_create(files, gallery_shelf_count, "files of entries"));
  *n = 0;
  for (size_t i = 0; i < gallery_shelf_count; i++) {
    const struct gallery_shelf_file *f = &gallery_shelf[i];
    if (strncmp(f->path, entries, sizeof entries - 1) != 0) continue;
    (*files)[(*n)++] = (struct gallery_file){.name = f->path, .text = f->bytes, .size = f->size};
  }
  return OK;
}
