/* Figures: each is a script and its data in DIR/figures, which compare/drawing.h makes SVG, PDF and
 * PNG of. */
#pragma once
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>

#include "common/base/status.h"
#include "compare/section.h"

struct cmp_figure {
  char name[96];     /* of its files, without suffix */
  char caption[512]; /* one or two sentences, plain text */
  enum cmp_section section;
  bool raster;       /* heavy: the report shows the PNG, not the SVG */
  int width, height; /* px of a screen */
  FILE *script;      /* open between begin and end */
  double fine;       /* px of the PNG for each of a screen */
  double layer;      /* the same of pictures that stand in it */
  char only[4];      /* the one format that is drawn; "": all */
  char missing[256]; /* why it is not drawn; "" when it is */
};

struct cmp_figures {
  char dir[PATH_MAX], temporary[PATH_MAX];
  char target[PATH_MAX]; /* the one file that is wanted; "": all, in `dir` */
  char prefix[48];       /* of the names of figures from now on */
  char list[80];         /* file in `dir` with the names of its figures, a line each */
  bool frames;           /* PNG alone, which stay where they are drawn */
  double fine;           /* px of a PNG for each of a screen; 0: as is usual */
  int lock;              /* on `temporary`, held while it is in use; -1: none */
  size_t n, room;
  struct cmp_figure *figure;
};

/* Also removes what killed reports have left behind. */
enum status cmp_figures_open(const char *out_dir, struct cmp_figures *f);
/* For a set of figures that shares the folder with others, made at the same time or not: publishing
 * removes what an earlier set of that name has left there. */
enum status cmp_figures_open_set(const char *out_dir, const char *set, struct cmp_figures *f);
/* For one figure, which becomes the file `path`: .svg, .pdf or .png. ERR_USAGE when it is none. */
enum status cmp_figures_open_file(const char *path, struct cmp_figures *f);
/* For frames of a film: PNG that are left in the temporary folder, in `dir`. */
enum status cmp_figures_open_frames(const char *dir, double fine, struct cmp_figures *f);
/* Forgets the figures and removes all files but the frames. */
enum status cmp_figures_clear(struct cmp_figures *f);
/* Puts what there is into `dir`; of a figure that is missing, its script and data. */
enum status cmp_figures_publish(struct cmp_figures *f);
void cmp_figures_close(struct cmp_figures *f); /* removes what is temporary */

size_t cmp_figures_missing(const struct cmp_figures *f);

/* Starts a figure: the caller writes gnuplot commands to figure->script. What comes after
 * cmp_figure_formats is executed once per format (the variable fmt is svg, pdf or png); the script
 * runs in the folder of its data. The pointer is good until the next begin. */
enum status cmp_figure_begin(struct cmp_figures *f, enum cmp_section section, bool raster,
                             int width, int height, struct cmp_figure **figure, const char *name,
                             ...) __attribute__((format(printf, 7, 8)));
void cmp_figure_formats(struct cmp_figure *figure);
enum status cmp_figure_end(struct cmp_figure *figure);

/* A data file beside the script: "NAME" + suffix. */
enum status cmp_figure_data(struct cmp_figures *f, const struct cmp_figure *figure,
                            const char *suffix, FILE **stream);
enum status cmp_figure_data_end(const struct cmp_figure *figure, FILE *stream);
