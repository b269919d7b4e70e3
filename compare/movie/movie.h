/* The pictures of an overlay, or of a field of the points in the water, at every output, as a film
 * (by ffmpeg) or as a folder of frames. */
#pragma once
#include <limits.h>

#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/result/result.h"
#include "compare/cloud.h"

enum { CMP_MOVIE_PATH = PATH_MAX - 64 }; /* bytes: frames have longer paths than their film */

struct cmp_movie_plan {
  bool overlay;         /* the first result's surface over all others; else each for itself */
  bool surfaces;        /* are enough, where no result has points */
  enum cmp_field field; /* that points are coloured by */
  const char *out;      /* .mp4, .webm, .gif; else a folder for frames; at most CMP_MOVIE_PATH */
  double fps;
  int width, height; /* px; 0: as they come */
  double from, to;   /* s */
};

/* Whether `path` is named like a film. */
bool cmp_movie_is_film(const char *path);

/* Draws n results by the settings of the first one's case (NULL: with walls at rest). `where`: what
 * was written in the end, the film, or, without ffmpeg, the folder of frames. ERR_USAGE when there
 * is nothing to be drawn; ERR_IO; INTERRUPTED, and nothing is left behind. */
enum status cmp_movie_write(const struct case_file *settings, size_t n,
                            struct result_file *const *files, const struct cmp_movie_plan *plan,
                            struct progress *progress, char where[PATH_MAX]);
