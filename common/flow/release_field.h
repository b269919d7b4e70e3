/* The released pressure (release.h) on one division of the water into triangles, by finite elements
 * of second degree. */
#pragma once
#include "common/flow/release.h"

struct release_field;

/* Arguments as those of release_create; `size`: of triangles, m. */
enum status release_field_create(const struct geo_lines *water, const struct geo_lines *walls,
                                 double size, double near, const struct release_drive *drive,
                                 struct release_field **out);
void release_field_destroy(struct release_field *f); /* NULL is fine */
double release_field_at(const struct release_field *f, const double at[2]);
