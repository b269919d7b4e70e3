/* ffmpeg at work on the frames of a movie. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

#include "common/base/status.h"

struct cmp_film { /* a kind of it */
  const char *suffix;
  bool even;               /* sides of an even number of pixels only */
  const char *filter;      /* behind the one that fits the size; "": none */
  const char *options[14]; /* of the encoder, NULL-terminated */
};

const struct cmp_film *cmp_film_of(const char *path); /* by its suffix; NULL: none */

/* Of the files frame-00001.png and so on in `dir` makes there "movie" and the suffix. Width and
 * height: to be filled with white, 0: as the frames are. ERR_IO with ffmpeg's complaint,
 * INTERRUPTED. */
enum status cmp_film_encode(const struct cmp_film *film, const char *dir, double fps, int width,
                            int height);
