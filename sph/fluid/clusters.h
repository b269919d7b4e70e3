/* What a pair loop does to each cluster of the water, by threads. */
#pragma once
#include "sph/sph.h"

/* `wanted` is what the caller passed on. It may write what belongs to the cluster only. */
typedef void sph_cluster_function(struct sph *s, size_t cluster, const void *wanted);

/* Calls it once for every cluster, in any order. */
void sph_each_cluster(struct sph *s, sph_cluster_function *of, const void *wanted);
