/* gallery.html: all entries on one page, by which a reader finds, looks and judges. */
#pragma once
#include <jansson.h>

#include "common/base/status.h"

/* Writes DIR/gallery.html from gallery.json (docs/gallery-entries.md); figures are beside it, in
 * DIR/figures, small ones of them in the page. ERR_IO. */
enum status gallery_page_write(const char *dir, const json_t *gallery);
