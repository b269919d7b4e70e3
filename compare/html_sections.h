/* The sections of the report below its summary. */
#pragma once
#include "compare/html_parts.h"

/* A table of the measures of a section, if it has any: one that is taken at the comparison times
 * has a row per time, one of the whole run a row; a column per run. */
void cmp_html_measures(struct page *p, const struct comparison *c, const struct cmp_rows *rows,
                       enum cmp_section section);

void cmp_html_jets(struct page *p, const struct comparison *c);
/* A row for the reference and for each run: can it be believed, and by which numbers. */
void cmp_html_health(struct page *p, const struct comparison *c);
/* Where the energy of the reference and of each run went, up to the last comparison time. */
enum status cmp_html_ledger(struct page *p, const struct comparison *c);
/* Signals of one quantity. */
/* What the numbers of the section are. */
void cmp_html_diagnostics(struct page *p, const struct comparison *c);
void cmp_html_filters(struct page *p, const struct comparison *c);
void cmp_html_spectra(struct page *p, const struct comparison *c);
void cmp_html_signals(struct page *p, const struct comparison *c, enum cmp_quantity quantity);
void cmp_html_provenance(struct page *p, const struct comparison *c);
void cmp_html_method(struct page *p, const struct comparison *c);
