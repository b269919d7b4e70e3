#include <argp.h>
#include <stdio.h>

#include "cli/command.h"
#include "cli/registry.h"
#include "common/base/params.h"

int command_list(int argc, char **argv) {
  static const struct argp argp = {
      .doc = "Prints what a case file may hold: the sections and their keys, the solvers with the "
             "parameters of their runs, and the measures that tolerances can be set for.",
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
  return EXIT_FINE;
}
