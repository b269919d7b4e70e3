#include <argp.h>
#include <stdio.h>

#include "cli/command.h"
#include "cli/registry.h"
#include "common/base/params.h"
#include "gallery/drawer.h"
#include "gallery/reduce.h"
#include "gallery/source.h"

/* What entries of the gallery may hold. */
static void list_gallery(void) {
#define X(name, n, help) {#name, help},
  static const struct { const char *name, *help; } functions[] = {GALLERY_REDUCTIONS(X)};
#undef X
  for (size_t i = 0; gallery_sources[i]; i++) {
    printf("source of curves %s: %s\n", gallery_sources[i]->name, gallery_sources[i]->help);
    params_print(stdout, gallery_sources[i]->params, gallery_sources[i]->n_params);
    putchar('\n');
  }
  puts("functions of a curve, in formulas:");
  for (size_t i = 0; i < sizeof functions / sizeof *functions; i++)
    printf("  %-24s %s\n", functions[i].name, functions[i].help);
  puts("\nkinds of figures:");
  for (size_t i = 0; gallery_drawers[i]; i++)
    printf("  %-24s %s\n", gallery_drawers[i]->name, gallery_drawers[i]->help);
}

int command_list(int argc, char **argv) {
  static const struct argp argp = {
      .doc = "Prints what a case file may hold: the sections and their keys, the solvers with the "
             "parameters of their runs, and the measures that tolerances can be set for; then what "
             "entries of the gallery may hold.",
  };
  argp_parse(&argp, argc, argv, 0, NULL, NULL);
  case_print_keys(stdout);
  for (size_t i = 0; i < registry.n_solvers; i++) {
    const struct solver *s = registry.solvers[i];
    printf("solver %s: %s\n", s->name, s->help);
    params_print(stdout, s->params, s->n_params);
    putchar('\n');
    if (!s->n_presets) continue;
    printf("schemes of solver %s, and what each sets unless a run says otherwise:\n", s->name);
    param_presets_print(stdout, s->presets, s->n_presets);
    putchar('\n');
  }
  puts("measures (compare.tolerances):");
  for (size_t i = 0; i < registry.n_measures; i++) {
    const struct measure *m = &registry.measures[i];
    printf("  %-24s [%s] %s\n", m->name, m->units, m->help);
  }
  putchar('\n');
  list_gallery();
  return EXIT_FINE;
}
