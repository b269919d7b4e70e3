#include "compare/report.h"

#include <string.h>

#include "compare/charts.h"
#include "compare/convergence/figures.h"
#include "compare/convergence/table.h"
#include "compare/currents.h"
#include "compare/drawing.h"
#include "compare/json.h"
#include "compare/output.h"
#include "compare/overlays.h"
#include "compare/page/page.h"
#include "compare/pick.h"
#include "compare/spectra.h"
#include "compare/stacks.h"
#include "compare/summary.h"

enum status cmp_report(const struct case_file *settings, const struct result_file *reference,
                       size_t n, struct result_file *const *runs, bool anyway, const char *out_dir,
                       struct cmp_verdict *verdict) {
  enum status status = OK;
  struct comparison *c = NULL;
  struct cmp_rows rows = {0};
  struct cmp_convergence convergence = {0};
  struct cmp_figures figures = {.lock = -1};
  json_t *report = NULL;
  char html[PATH_MAX], json[PATH_MAX], table[PATH_MAX];
  memset(verdict, 0, sizeof *verdict);
  TRY(cmp_path_join(out_dir, "report.html", html));
  TRY(cmp_path_join(out_dir, "report.json", json));
  TRY(cmp_path_join(out_dir, "convergence.csv", table));
  TRY(cmp_directory_make(out_dir));

  ATTEMPT(cmp_comparison_create(settings, reference, n, runs, anyway, &c));
  ATTEMPT(cmp_runs_rank(c));
  ATTEMPT(cmp_rows_create(c, &rows));
  ATTEMPT(cmp_convergence_create(c, &rows, &convergence));
  ATTEMPT(cmp_summary_sentence(c, &rows, verdict->sentence, sizeof verdict->sentence));
  verdict->passed = rows.passed;
  verdict->failed = rows.failed;
  ATTEMPT(cmp_json_create(c, &rows, &convergence, verdict->sentence, &report));
  ATTEMPT(cmp_json_save(report, json));
  ATTEMPT(cmp_convergence_table(c, &convergence, table));
  ATTEMPT(cmp_figures_open(out_dir, &figures));
  ATTEMPT(cmp_charts_write(c, &figures));
  ATTEMPT(cmp_overlays_write(c, &figures));
  ATTEMPT(cmp_currents_write(c, &figures));
  ATTEMPT(cmp_stacks_write(c, &figures));
  ATTEMPT(cmp_spectra_write(c, &figures));
  ATTEMPT(cmp_convergence_draw(c, &convergence, &figures));
  enum status drawn = cmp_figures_draw(&figures, CMP_DRAWING_LIMITS);
  if (drawn == INTERRUPTED) ATTEMPT(drawn);
  /* the numbers at least */
  ATTEMPT(cmp_page_write(c, &rows, &figures, verdict->sentence, report, html));
  status = drawn;
done:
  cmp_figures_close(&figures);
  cmp_convergence_destroy(&convergence);
  json_decref(report);
  cmp_rows_destroy(&rows);
  cmp_comparison_destroy(c);
  return status;
}
