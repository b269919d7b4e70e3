/* What a run's result depends on, as text with all digits, and a hash of it. */
#include <stdio.h>
#include <stdlib.h>

#include "common/case_draft.h"
#include "revision.h"

static void write_lines(FILE *out, const char *name, const struct geo_lines *l) {
  for (size_t k = 0; k < l->pieces; k++) {
    fprintf(out, "%s %d", name, l->closed[k]);
    for (size_t i = l->first[k]; i < l->first[k + 1]; i++)
      fprintf(out, " %.17g %.17g", l->p[i][0], l->p[i][1]);
    fputc('\n', out);
  }
}

static void write_inputs(FILE *out, const struct case_file *c, const struct case_run *r) {
  fprintf(out, "plunge %s %s\n", PLUNGE_VERSION, PLUNGE_REVISION);
  fprintf(out, "fluid %.17g %.17g\nH %.17g\n", c->density, c->gravity, c->H);
  write_lines(out, "wall", &c->walls);
  write_lines(out, "water", &c->water);
  fprintf(out, "velocity %.17g %.17g\npressure %d\n", c->velocity[0], c->velocity[1], c->pressure);
  fprintf(out, "wave %d %.17g %.17g %.17g\n", c->wave.kind, c->wave.amplitude, c->wave.wavelength,
          c->wave.depth);
  fprintf(out, "time %.17g %.17g %.17g\n", c->end, c->every, c->sample);
  for (size_t i = 0; i < c->n_probes; i++)
    fprintf(out, "probe %s %.17g %.17g %.17g\n", c->probes[i].name, c->probes[i].x, c->probes[i].y,
            c->probes[i].size);
  for (size_t i = 0; i < c->n_gauges; i++)
    fprintf(out, "gauge %s %.17g\n", c->gauges[i].name, c->gauges[i].x);
  fprintf(out, "solver %s %.17g\n", r->solver->name, r->resolution);
  params_write(out, r->solver->params, r->solver->n_params, r->options);
}

/* FNV-1a in 128 bits (Fowler, Noll, Vo; RFC 9923): a key for "is this the same run", no secret. */
static void hash(const char *text, size_t n, char out[33]) {
  __extension__ typedef unsigned __int128 wide;
  const wide prime = ((wide)1 << 88) + 0x13b;
  wide h = ((wide)0x6c62272e07bb0142 << 64) + 0x62b821756295c58d;
  for (size_t i = 0; i < n; i++) h = (h ^ (unsigned char)text[i]) * prime;
  snprintf(out, 33, "%016llx%016llx", (unsigned long long)(h >> 64), (unsigned long long)h);
}

void case_fingerprint(const struct case_file *c, const struct case_run *r, char out[33]) {
  char *text = NULL;
  size_t n = 0;
  FILE *stream = open_memstream(&text, &n);
  if (stream) {
    write_inputs(stream, c, r);
    fclose(stream);
  }
  out[0] = 0; /* without memory: a fingerprint that matches no file's */
  if (text) hash(text, n, out);
  free(text);
}
