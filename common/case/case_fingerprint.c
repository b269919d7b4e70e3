/* What a run's result depends on, as text with all digits, and a hash of it; and the same of what
 * makes two results comparable, with as many digits as two ways of writing a length share. */
#include <stdio.h>
#include <stdlib.h>

#include "common/case/case_draft.h"
#include "common/flow/flow.h"
#include "revision.h"

static void write_lines(FILE *out, const char *name, const struct geo_lines *l) {
  for (size_t k = 0; k < l->pieces; k++) {
    fprintf(out, "%s %d", name, l->closed[k]);
    for (size_t i = l->first[k]; i < l->first[k + 1]; i++)
      fprintf(out, " %.17g %.17g", l->p[i][0], l->p[i][1]);
    fputc('\n', out);
  }
}

static void write_motion(FILE *out, const struct tank_motion *m) {
  const double number[] = {m->about[0],    m->about[1],   m->hinge,    m->sine.amplitude,
                           m->sine.period, m->sine.phase, m->sine.ramp};
  fprintf(out, "motion %s %d", tank_motion_name(m), m->side);
  for (size_t i = 0; i < sizeof number / sizeof *number; i++)
    fprintf(out, " %.12g", number[i] + 0.0);
  for (size_t i = 0; i < m->file.n; i++)
    fprintf(out, " %.12g %.12g", m->file.t[i] + 0.0, m->file.q[i] + 0.0);
  fputc('\n', out);
}

/* Of regions that have their own. */
static void write_velocities(FILE *out, const struct case_file *c) {
  for (size_t k = 0; c->regions_differ && k < c->water.pieces; k++)
    fprintf(out, "moves %.12g %.12g\n", c->velocities[k][0] + 0.0, c->velocities[k][1] + 0.0);
}

static void write_inputs(FILE *out, const struct case_file *c, const struct case_run *r) {
  fprintf(out, "plunge %s %s\n", PLUNGE_VERSION, PLUNGE_REVISION);
  fprintf(out, "fluid %.17g %.17g\nH %.17g\ng %.17g\n", c->density, c->gravity, c->H, c->g);
  fprintf(out, "down %.17g %.17g\n", c->down[0], c->down[1]);
  write_lines(out, "wall", &c->walls);
  fprintf(out, "periodic %d %d\n", c->periodic[0], c->periodic[1]);
  for (size_t i = 0; i < c->n_motions; i++) write_motion(out, &c->motions[i]);
  write_lines(out, "water", &c->water);
  fprintf(out, "velocity %.17g %.17g\nflow %s\n", c->velocity[0], c->velocity[1],
          flow_name(c->flow));
  write_velocities(out, c);
  params_write(out, c->flow->params, c->flow->n_params, c->form);
  if (c->flow->write) c->flow->write(out, c->form);
  fprintf(out, "time %.17g %.17g %.17g\n", c->end, c->every, c->sample);
  for (size_t i = 0; i < c->n_probes; i++)
    fprintf(out, "probe %s %.17g %.17g %.17g\n", c->probes[i].name, c->probes[i].x, c->probes[i].y,
            c->probes[i].size);
  for (size_t i = 0; i < c->n_gauges; i++)
    fprintf(out, "gauge %s %.17g\n", c->gauges[i].name, c->gauges[i].x);
  for (size_t i = 0; i < c->n_points; i++)
    fprintf(out, "point %s %.17g %.17g %d%s\n", c->points[i].name, c->points[i].x, c->points[i].y,
            c->points[i].every, c->points[i].follow ? " follow" : "");
  fprintf(out, "solver %s %.17g\n", r->solver->name, r->resolution);
  params_write(out, r->solver->params, r->solver->n_params, r->options);
}

/* FNV-1a in 128 bits (Fowler, Noll, Vo; RFC 9923): a key for "is this the same run", no secret. */
void case_text_fingerprint(const char *text, size_t n, char out[33]) {
  __extension__ typedef unsigned __int128 wide;
  const wide prime = ((wide)1 << 88) + 0x13b;
  wide h = ((wide)0x6c62272e07bb0142 << 64) + 0x62b821756295c58d;
  for (size_t i = 0; i < n; i++) h = (h ^ (unsigned char)text[i]) * prime;
  snprintf(out, 33, "%016llx%016llx", (unsigned long long)(h >> 64), (unsigned long long)h);
}

/* To twelve digits: 3.2196 and 5.366 H differ in their last bit. Adding 0 makes -0 a 0. */
static void write_rounded(FILE *out, const char *name, size_t n, const double *value) {
  fputs(name, out);
  for (size_t i = 0; i < n; i++) fprintf(out, " %.12g", value[i] + 0.0);
  fputc('\n', out);
}

static void write_rounded_lines(FILE *out, const char *name, const struct geo_lines *l) {
  for (size_t k = 0; k < l->pieces; k++) {
    fprintf(out, "%s %d\n", name, l->closed[k]);
    for (size_t i = l->first[k]; i < l->first[k + 1]; i++) write_rounded(out, "at", 2, l->p[i]);
  }
}

/* The numbers on one line, whatever else there is as it is. */
static void write_form(FILE *out, const struct flow *flow, const void *form) {
  fputs("form", out);
  for (size_t i = 0; i < flow->n_params; i++)
    if (flow->params[i].type == PARAM_REAL)
      fprintf(out, " %.12g", *(const double *)((const char *)form + flow->params[i].offset) + 0.0);
  fputc('\n', out);
  for (size_t i = 0; i < flow->n_params; i++)
    if (flow->params[i].type != PARAM_REAL && flow->params[i].type != PARAM_TEXT)
      params_write(out, &flow->params[i], 1, form);
  if (flow->write) flow->write(out, form);
}

/* Waves and bodies by their parameters: an outline is only as fine as this version draws it. */
static void write_water(FILE *out, const struct case_file *c) {
  const double scales[] = {c->density, c->gravity, c->H};
  write_rounded(out, "scales", 3, scales);
  write_rounded_lines(out, "wall", &c->walls);
  if (c->periodic[0]) fputs("periodic sides\n", out);
  if (c->periodic[1]) fputs("periodic bed\n", out);
  if (c->gravity == 0) fprintf(out, "g %.12g\n", c->g);
  if (case_is_turned(c)) write_rounded(out, "down", 2, c->down);
  for (size_t i = 0; i < c->n_motions; i++) write_motion(out, &c->motions[i]);
  if (c->flow->scale) {
    fprintf(out, "%s %zu\n", flow_is_wave(c->flow) ? "wave" : "body", 1 + flow_place(c->flow));
    write_form(out, c->flow, c->form);
    return;
  }
  write_rounded_lines(out, "water", &c->water);
  write_rounded(out, "velocity", 2, c->velocity);
  write_velocities(out, c);
  fprintf(out, "pressure %zu\n", flow_place(c->flow));
}

/* `r` NULL: of the water alone. Without memory: a fingerprint that matches no file's. */
static void fingerprint(const struct case_file *c, const struct case_run *r, char out[33]) {
  char *text = NULL;
  size_t n = 0;
  FILE *stream = open_memstream(&text, &n);
  if (stream) {
    if (r)
      write_inputs(stream, c, r);
    else
      write_water(stream, c);
    fclose(stream);
  }
  out[0] = 0;
  if (text) case_text_fingerprint(text, n, out);
  free(text);
}

void case_fingerprint(const struct case_file *c, const struct case_run *r, char out[33]) {
  fingerprint(c, r, out);
}

void case_water_fingerprint(const struct case_file *c, char out[33]) {
  fingerprint(c, NULL, out);
}
