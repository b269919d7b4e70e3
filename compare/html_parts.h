/* What the sections of the report are made of. */
#pragma once
#include "compare/chart.h"
#include "compare/figure.h"
#include "compare/measure.h"
#include "compare/page.h"

/* Reasons collected while a table is written, listed below it. */
struct cmp_html_reasons {
  size_t n, unlisted;
  char text[24][112];
};

void cmp_html_cell(struct page *p, const char *class, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* A number in a table cell, or n/a with a mark that leads to its reason. */
void cmp_html_value(struct page *p, const struct cmp_value *v, struct cmp_html_reasons *why);
void cmp_html_reasons_list(struct page *p, const struct cmp_html_reasons *why);

/* The heading cell of a run (SIZE_MAX: the reference): its colour and its name. */
void cmp_html_run(struct page *p, const struct comparison *c, size_t r);
/* A row of headings, from a NULL-terminated list; then </thead> and <tbody> may follow. */
void cmp_html_headings(struct page *p, const char *const *heading);
void cmp_html_table_open(struct page *p);
void cmp_html_table_close(struct page *p);

/* Every figure of a section. ERR_IO when one cannot be read back. */
enum status cmp_html_figures(struct page *p, const struct cmp_figures *figures,
                             enum cmp_section section);
