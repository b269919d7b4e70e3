/* The comparator: result files in; report.html, report.json, figures/ and a verdict out. */
#pragma once
#include "common/case/case.h"
#include "common/result/result.h"
#include "compare/measure.h"

struct cmp_verdict {
  size_t passed, failed; /* checks against tolerances; a run passes when failed is 0 */
  char sentence[2048];   /* what the report says first */
};

/* `settings`: the `compare` section and names of runs (case_load's, or case_parse of the text in
 * the reference file); experiments are taken from the reference file. Runs are of the reference's
 * tank, water and scales, or it is ERR_INPUT unless `anyway`. `out_dir` is made when missing; its
 * files are replaced whole.
 */
enum status cmp_report(const struct case_file *settings, const struct result_file *reference,
                       size_t n, struct result_file *const *runs, bool anyway, const char *out_dir,
                       struct cmp_verdict *verdict);
