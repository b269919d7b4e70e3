#include "compare/absent.h"

#include <stddef.h>

static bool any_has(const struct comparison *c, size_t offset) {
  size_t n = 0;
  for (size_t r = 0; r <= c->n_runs; r++) {
    const struct cmp_data *d = r < c->n_runs ? &c->run[r].data : &c->ref.data;
    n += *(const size_t *)((const char *)d->file + offset);
  }
  return n > 0;
}

size_t cmp_absent_find(const struct comparison *c, const struct cmp_run *run,
                       const char *what[CMP_MOST_ABSENT]) {
  const struct result_file *f = run->data.file;
  const struct {
    const char *name;
    size_t has;
    bool asked;
  } parts[CMP_MOST_ABSENT] = {
      {"walls", f->walls.pieces, true},
      {"surfaces", f->n_surfaces, true},
      {"energies", f->n_energy, true},
      {"volumes", f->n_steps, true},
      {"probes", f->n_probes, any_has(c, offsetof(struct result_file, n_probes))},
      {"gauges", f->n_gauges, any_has(c, offsetof(struct result_file, n_gauges))},
  };
  size_t n = 0;
  for (size_t k = 0; k < CMP_MOST_ABSENT; k++)
    if (parts[k].asked && !parts[k].has) what[n++] = parts[k].name;
  return n;
}
