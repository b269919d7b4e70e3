#include "bem/start/mirror.h"

#include <stdlib.h>
#include <string.h>

#include "bem/start/outline.h"
#include "common/base/array.h"
#include "common/flow/flow.h"
#include "common/tank/tank.h"

/* The points of each piece the other way round: the water stays on the same side. */
static enum status turn_lines(const struct case_file *c, const struct geo_lines *from,
                              struct geo_lines *to) {
  *to = (struct geo_lines){0};
  for (size_t k = 0; k < from->pieces; k++) {
    TRY(geo_lines_begin(to, from->closed[k]));
    for (size_t i = from->first[k + 1]; i-- > from->first[k];)
      TRY(geo_lines_add(to, bem_mirror_x(c, from->p[i][0]), from->p[i][1]));
  }
  return OK;
}

/* n structs of so many bytes, once more; *copy: [n], owned. */
static enum status duplicate(const void *from, size_t n, size_t size, void **copy) {
  *copy = array_memory(NULL, n, size, "what a mirror shows");
  if (!*copy) return ERR_MEMORY;
  if (n) memcpy(*copy, from, n * size);
  return OK;
}

static enum status turn_record(const struct tank_record *from, double sign,
                               struct tank_record *to) {
  *to = (struct tank_record){.n = from->n};
  TRY(duplicate(from->t, from->n, sizeof *to->t, (void **)&to->t));
  TRY(duplicate(from->q, from->n, sizeof *to->q, (void **)&to->q));
  TRY(duplicate(from->q_t, from->n, sizeof *to->q_t, (void **)&to->q_t));
  for (size_t i = 0; i < to->n; i++) {
    to->q[i] *= sign;
    to->q_t[i] *= sign;
  }
  return OK;
}

/* To the right becomes to the left, anticlockwise clockwise; upwards stays. */
static enum status turn_motion(const struct case_file *c, const struct tank_motion *from,
                               struct tank_motion *to) {
  const double sign = from->kind == TANK_MOTION_heave ? 1 : -1;
  *to = *from;
  to->side = from->side == TANK_LEFT ? TANK_RIGHT : TANK_LEFT;
  to->about[0] = bem_mirror_x(c, from->about[0]);
  to->sine.amplitude *= sign;
  to->file = (struct tank_record){0};
  return from->file.n ? turn_record(&from->file, sign, &to->file) : OK;
}

static enum status turn_velocities(const struct case_file *c, struct case_file *m) {
  const size_t n = c->water.pieces;
  TRY(duplicate(c->velocities, n, sizeof *c->velocities, (void **)&m->velocities));
  for (size_t k = 0; k < n; k++) m->velocities[k][0] = -c->velocities[k][0];
  return OK;
}

static enum status turn(const struct case_file *c, struct case_file *m) {
  m->probes = NULL, m->gauges = NULL, m->points = NULL, m->motions = NULL, m->velocities = NULL;
  m->walls = m->water = (struct geo_lines){0};
  m->velocity[0] = -c->velocity[0];
  TRY(duplicate(c->probes, c->n_probes, sizeof *c->probes, (void **)&m->probes));
  TRY(duplicate(c->gauges, c->n_gauges, sizeof *c->gauges, (void **)&m->gauges));
  TRY(duplicate(c->points, c->n_points, sizeof *c->points, (void **)&m->points));
  if (c->regions_differ) TRY(turn_velocities(c, m));
  TRY(array_create(&m->motions, c->n_motions, "motions in a mirror"));
  TRY(turn_lines(c, &c->walls, &m->walls));
  TRY(turn_lines(c, &c->water, &m->water));
  for (size_t i = 0; i < c->n_probes; i++) m->probes[i].x = bem_mirror_x(c, c->probes[i].x);
  for (size_t i = 0; i < c->n_gauges; i++) m->gauges[i].x = bem_mirror_x(c, c->gauges[i].x);
  for (size_t i = 0; i < c->n_points; i++) m->points[i].x = bem_mirror_x(c, c->points[i].x);
  for (size_t i = 0; i < c->n_motions; i++) TRY(turn_motion(c, &c->motions[i], &m->motions[i]));
  return OK;
}

static enum status find_need(const struct case_file *c, bool *needed) {
  struct bem_outline o;
  const char *problem;
  *needed = false;
  if (flow_is_wave(c->flow) || c->periodic[0]) return OK;
  const enum status status = bem_outline_find(c, &o, &problem);
  *needed = status == OK && !problem && o.toe[0];
  bem_outline_destroy(&o);
  return status;
}

enum status bem_mirror_create(const struct case_file *c, struct bem_mirror *m) {
  *m = (struct bem_mirror){.c = *c};
  TRY(find_need(c, &m->turned));
  return m->turned ? turn(c, &m->c) : OK;
}

void bem_mirror_destroy(struct bem_mirror *m) {
  struct case_file *c = &m->c;
  if (!m->turned) return;
  for (size_t i = 0; c->motions && i < c->n_motions; i++) tank_record_destroy(&c->motions[i].file);
  free(c->motions);
  free(c->velocities);
  free(c->probes);
  free(c->gauges);
  free(c->points);
  geo_lines_destroy(&c->walls);
  geo_lines_destroy(&c->water);
}
