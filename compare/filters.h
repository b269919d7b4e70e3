/* What compare.filters ask for: a probe's pressure by another measure, beside what it is. */
#pragma once
#include "compare/data.h"

struct cmp_filtered {
  const struct case_filter *filter; /* borrowed from the settings */
  const char *probe;                /* its name, borrowed from the settings */
  struct cmp_series series;         /* `raw` beside it, but for an impulse; n = 0: there is none */
  const char *units;
  struct cmp_signal_alone before, after; /* over all of it */
  struct cmp_value taken; /* rms of what it has taken out; both say why where there is no series */
};

/* All of the settings' filters of a run's raw pressures, [n_filters]. `T` and `H`: the scales of
 * the settings' times and lengths. ERR_MEMORY. */
enum status cmp_filters_take(const struct case_file *settings, const struct cmp_data *d, double T,
                             double H, double threshold, struct cmp_filtered **out);
void cmp_filters_destroy(size_t n, struct cmp_filtered *filtered);

/* What each filter is, for captions and tables: "low pass, periods of 0.04 √(H/g) and longer". */
void cmp_filter_say(const struct case_filter *f, double T, double H, char *out, size_t room);

/* geo_wall_shares of probes, [n], lengths in H: `weight` [n] and at how many `places` they are.
 * ERR_MEMORY. */
enum status cmp_wall_weights(const struct geo_lines *walls, size_t n,
                             const struct cmp_series *probe, size_t middle, double length,
                             double *weight, size_t *places);
