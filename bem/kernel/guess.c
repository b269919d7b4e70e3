#include "bem/kernel/guess.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

/* Sum of the magnitudes of the weights up to which a polynomial is trusted: beyond it, it makes
 * more of the residuals than of the flow. */
static const double WILD = 30;

enum status bem_guess_begin(struct bem_guess *g, size_t n) {
  if (n > g->room) {
    TRY(array_resize(&g->memory, BEM_GUESSES * n, "guesses of psi"));
    g->room = n;
  }
  for (size_t i = 0; i < BEM_GUESSES; i++) g->psi[i] = g->memory + i * n;
  g->n = n;
  g->count = 0;
  return OK;
}

void bem_guess_destroy(struct bem_guess *g) {
  free(g->memory);
  *g = (struct bem_guess){0};
}

/* Weights at `time` of the polynomial through the latest `count`; the sum of their magnitudes. */
static double weigh(const struct bem_guess *g, size_t count, double time, double *weight) {
  double sum = 0;
  for (size_t i = 0; i < count; i++) {
    weight[i] = 1;
    for (size_t j = 0; j < count; j++)
      if (j != i) weight[i] *= (time - g->time[j]) / (g->time[i] - g->time[j]);
    sum += fabs(weight[i]);
  }
  return sum;
}

void bem_guess_make(const struct bem_guess *g, double time, double *psi) {
  double weight[BEM_GUESSES];
  size_t count = g->count;
  while (count > 1 && !(weigh(g, count, time, weight) < WILD)) count--;
  if (!count) return;
  weigh(g, count, time, weight);
  for (size_t k = 0; k < g->n; k++) {
    double sum = 0;
    for (size_t i = 0; i < count; i++) sum += weight[i] * g->psi[i][k];
    psi[k] = sum;
  }
}

/* The first instant becomes the last (by 1), or the last the first (by BEM_GUESSES - 1). */
static void rotate(struct bem_guess *g, size_t by) {
  double time[BEM_GUESSES], *psi[BEM_GUESSES];
  memcpy(time, g->time, sizeof time);
  memcpy(psi, g->psi, sizeof psi);
  for (size_t i = 0; i < BEM_GUESSES; i++) {
    g->time[i] = time[(i + by) % BEM_GUESSES];
    g->psi[i] = psi[(i + by) % BEM_GUESSES];
  }
}

void bem_guess_keep(struct bem_guess *g, double time, const double *psi) {
  for (; g->count > 0 && g->time[0] >= time; g->count--) rotate(g, 1);
  rotate(g, BEM_GUESSES - 1);
  g->time[0] = time;
  memcpy(g->psi[0], psi, g->n * sizeof *psi);
  if (g->count < BEM_GUESSES) g->count++;
}
