/* Figures: each is a script and its data in DIR/figures, which compare/drawing.h makes SVG, PDF and
 * PNG of. */
#pragma once
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>

#include "common/base/status.h"
#include "compare/section.h"

enum {                         /* px of a screen, five of which are a millimetre in print */
       CMP_PANELS_WIDTH = 900, /* two columns of a journal, 180 mm */
       CMP_PANELS_NARROW = 450 /* one, 90 mm */
};

/* The files of a figure: its name and `suffix`. */
struct cmp_format {
  const char *fmt;    /* in its script */
  const char *suffix; /* ".svg" */
  const char *end;    /* of what is in the file */
  const char *says;   /* to readers */
};
enum { CMP_FORMATS = 4 };
extern const struct cmp_format cmp_formats[CMP_FORMATS];

struct cmp_figure {
  char name[96];     /* of its files, without suffix */
  char caption[512]; /* one or two sentences, plain text */
  enum cmp_section section;
  bool raster;       /* heavy: the report shows the PNG, not the SVG */
  int width, height; /* px of a screen */
  int column_height; /* in one column of print, if it is wider; 0: it is not drawn so */
  FILE *script;      /* open between begin and end */
  double fine;       /* px of the PNG for each of a screen */
  double layer;      /* the same of pictures that stand in it */
  int thumb;         /* px, width of a small PNG besides; 0: none */
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
  int thumb;             /* px: figures from now on come with a small one, NAME.thumb.png; 0: no */
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
/* Forgets all but the first n, and what was written of the others: such that failed. */
void cmp_figures_forget(struct cmp_figures *f, size_t n);

size_t cmp_figures_missing(const struct cmp_figures *f);

/* Starts a figure: the caller writes gnuplot commands to figure->script. What comes after
 * cmp_figure_formats is executed once per format: `wide` and `high` are the size there, and
 * `narrow` is 1 where that is one column, else 0. The script runs in the folder of its data. The
 * pointer is good until the next begin. */
enum status cmp_figure_begin(struct cmp_figures *f, enum cmp_section section, bool raster,
                             int width, int height, struct cmp_figure **figure, const char *name,
                             ...) __attribute__((format(printf, 7, 8)));
bool cmp_figure_has(const struct cmp_figure *figure, const struct cmp_format *format);

/* Where the next plot is: px between its axes and the edges of the figure, and its height. */
struct cmp_margins {
  double left, right, top, height;
};
/* `column`: those in one column; NULL where there is none. */
void cmp_figure_margins(const struct cmp_figure *figure, const struct cmp_margins *usual,
                        const struct cmp_margins *column);
void cmp_figure_formats(struct cmp_figure *figure);
enum status cmp_figure_end(struct cmp_figure *figure);

/* A data file beside the script: "NAME" + suffix. */
enum status cmp_figure_data(struct cmp_figures *f, const struct cmp_figure *figure,
                            const char *suffix, FILE **stream);
enum status cmp_figure_data_end(const struct cmp_figure *figure, FILE *stream);
