#include "sph/domain/copies.h"

#include <stdlib.h>

#include "common/base/array.h"

static enum status make_room_to_find(struct sph_copies *c, size_t n) {
  const size_t room = array_room(c->found_room, n);
  if (room == c->found_room) return OK;
  TRY(array_resize(&c->found, room, "images of particles"));
  TRY(array_resize(&c->fx, room, "images of particles"));
  TRY(array_resize(&c->fy, room, "images of particles"));
  c->found_room = room;
  return OK;
}

enum status sph_copies_add(struct sph_copies *c, uint32_t of, size_t n, const struct image *found) {
  TRY(make_room_to_find(c, c->n_found + n));
  for (size_t k = 0; k < n; k++, c->n_found++) {
    c->found[c->n_found] = (struct sph_copy){of, found[k].motion};
    c->fx[c->n_found] = found[k].x;
    c->fy[c->n_found] = found[k].y;
  }
  return OK;
}

static enum status make_room_to_sort(struct sph_copies *c) {
  const size_t room = c->found_room;
  if (room == c->room) return OK;
  TRY(array_resize(&c->copy, room, "images of particles"));
  TRY(array_resize(&c->x, room, "images of particles"));
  TRY(array_resize(&c->y, room, "images of particles"));
  TRY(array_resize(&c->key, room, "images of particles"));
  TRY(array_resize(&c->order, room, "images of particles"));
  c->room = room;
  return OK;
}

enum status sph_copies_sort(struct sph_copies *c, struct sph_grid *grid) {
  TRY(make_room_to_sort(c));
  c->n = sph_grid_sort(grid, c->n_found, c->fx, c->fy, NULL, c->key, c->order);
  for (size_t k = 0; k < c->n; k++) {
    const uint32_t from = c->order[k];
    c->copy[k] = c->found[from];
    c->x[k] = c->fx[from];
    c->y[k] = c->fy[from];
  }
  c->n_found = 0;
  return OK;
}

void sph_copies_destroy(struct sph_copies *c) {
  free(c->copy);
  free(c->x);
  free(c->y);
  free(c->found);
  free(c->fx);
  free(c->fy);
  free(c->key);
  free(c->order);
  *c = (struct sph_copies){0};
}
