/* The spectrum of a signal, one-sided, by a Hann window; and filters of a signal by its cosines. In
 * the units of the signal and of its time. */
#pragma once
#include "common/case/case.h"
#include "compare/series.h"

struct cmp_peak {
  double frequency, amplitude; /* of the sine that it would be, between bins too */
};

struct cmp_spectrum {
  struct cmp_value interval; /* between samples; or why there is no spectrum */
  size_t samples;
  double from, to;    /* of the stretch that it is of */
  bool resampled;     /* its rows are not even in time */
  double mean;        /* taken off before, weighted like the rest */
  double mean_square; /* of what is left: sum of power times step */
  size_t n;           /* bins, from frequency 0 on */
  double step;        /* from bin to bin: 1/(samples interval) */
  double *amplitude;  /* of a sine at the bin, [n], owned */
  double *power;      /* density: value^2 over frequency, [n], owned */
  size_t n_peaks;
  struct cmp_peak peak[CASE_MOST_PEAKS]; /* the highest first */
};

/* Of the longest stretch of rows within [from, to] without a gap, with its `peaks` highest peaks.
 * ERR_MEMORY. */
enum status cmp_spectrum_create(const struct cmp_signal *s, double from, double to, size_t peaks,
                                struct cmp_spectrum *out);
void cmp_spectrum_destroy(struct cmp_spectrum *s);

/* A signal without gaps, at its rows, without the cosines of its even continuation that are much
 * shorter than `period`: CASE_FILTER_low_pass (case.h). out [n]. ERR_MEMORY. */
enum status cmp_signal_low_pass(const struct cmp_signal *s, double period, double *out);

/* int from the first row to each, linear between rows; NaN from a gap on. out [n] */
void cmp_signal_integrate(const struct cmp_signal *s, double *out);
