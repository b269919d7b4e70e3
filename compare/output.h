/* Files that appear whole or not at all: written beside their place, then renamed. */
#pragma once
#include <limits.h>
#include <stdio.h>

#include "common/base/status.h"

struct cmp_output {
  FILE *stream;
  char path[PATH_MAX], temporary[PATH_MAX];
};

enum status cmp_output_open(const char *path, struct cmp_output *o);
/* Puts the file in its place; ERR_IO, and nothing left behind, when any write has failed. */
enum status cmp_output_commit(struct cmp_output *o);
void cmp_output_abandon(struct cmp_output *o); /* fine after a commit, and on a zeroed struct */

/* Closes a plain stream and says whether everything reached `path`. */
enum status cmp_stream_close(FILE *stream, const char *path);

/* "DIR/NAME" into `out`, [PATH_MAX]; ERR_IO when it is too long. */
enum status cmp_path_join(const char *dir, const char *name, char *out);
enum status cmp_directory_make(const char *path); /* with its parents */

/* A whole file; the caller frees *bytes. ERR_IO. */
enum status cmp_file_read(const char *path, char **bytes, size_t *n);
