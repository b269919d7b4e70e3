#include "cli/settings.h"

#include <stdio.h>
#include <stdlib.h>

#include "cli/command.h"
#include "cli/registry.h"

/* What results say of themselves, for their settings: runs by their names, the reference's probes
 * and gauges, and the points of all, of which a reference may have none. `room`: for the names. */
static struct case_frame frame_of(size_t n, struct result_file *const *files, const char **room) {
  const struct result_file *ref = files[0];
  struct case_frame frame = {
      .H = ref->H,
      .g = ref->g,
      .tank = geo_lines_box(&ref->walls),
      .walls = ref->walls.pieces ? &ref->walls : NULL,
      .tank_text = *ref->case_text ? ref->case_text : NULL,
      .n_times = ref->n_surfaces,
      .times = ref->surface_time,
  };
  frame.runs = (struct case_names){n, room};
  for (size_t i = 0; i < n; i++) *room++ = files[i]->run;
  frame.probes = (struct case_names){ref->n_probes, room};
  for (size_t i = 0; i < ref->n_probes; i++) *room++ = ref->probes[i].name;
  frame.gauges = (struct case_names){ref->n_gauges, room};
  for (size_t i = 0; i < ref->n_gauges; i++) *room++ = ref->gauges[i].name;
  frame.points.name = room;
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < files[i]->n_points; k++) *room++ = files[i]->points[k].name;
  frame.points.n = (size_t)(room - frame.points.name);
  return frame;
}

struct case_file *command_settings(const char *path, size_t n, struct result_file *const *files,
                                   bool quiet, int *exit_code) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  const struct result_file *ref = files[0];
  size_t n_names = n + ref->n_probes + ref->n_gauges;
  for (size_t i = 0; i < n; i++) n_names += files[i]->n_points;
  const char **names = calloc(n_names, sizeof *names);
  enum status status = names ? OK : status_raise(ERR_MEMORY, "no memory for %zu runs", n);
  if (status == OK) {
    const struct case_frame frame = frame_of(n, files, names);
    status = path
                 ? case_load_settings(path, &frame, &registry, &problems, &c)
                 : case_parse_settings(ref->path, ref->case_text, &frame, &registry, &problems, &c);
  }
  if (!path && problems.n && !quiet)
    fprintf(stderr, "plunge: the settings in %s are not ones that this version reads:\n",
            ref->path);
  if (!quiet) command_list_problems(&problems);
  *exit_code = status_exit_code(status);
  if (status != OK && !problems.n && !quiet) command_fail(status);
  problems_destroy(&problems);
  free(names);
  return c;
}
