/* Writes the results of any program as a file that plunge compares (docs/result-file.md).
 *
 *   plunge_result *r = plunge_result_open("mine.h5", 0.6, 9.81, 1000, 0.01);
 *   plunge_result_wall(r, 4, corners, 0);
 *   for each output: plunge_result_surface(r, t, n, points);
 *   plunge_result_close(r, NULL);
 *
 * SI units, per metre of width. Points are x, y in turn. What is known before the run (texts,
 * walls, probes, gauges, terms) is said before the first output, with which the file comes to be;
 * from then on it is complete up to the last output, whatever happens to the program.
 *
 * Every function but the first returns 0, or another number when it failed: plunge_result_message()
 * then says why. After a failure nothing more is written, and plunge_result_close repeats it, so
 * that a program may look at its answer alone. NULL is taken for a file that could not be opened.
 * One thread at a time. */
#ifndef PLUNGE_RESULT_H
#define PLUNGE_RESULT_H
#ifdef __cplusplus
extern "C" {
#endif

typedef struct plunge_result plunge_result;

/* The scales: H (m) and g (m/s^2) of the units of length and time, the density (kg/m^3) of the
 * water, the spacing (m) of cells or particles. NULL on failure. */
plunge_result *plunge_result_open(const char *path, double H, double g, double density,
                                  double spacing);

/* Why the last call failed; "" when none did. */
const char *plunge_result_message(void);

/* Finishes the file. What `ended` early is told of it, in one sentence; NULL or "": it did not. */
int plunge_result_close(plunge_result *r, const char *ended);

/* ---- before the first output ---- */

/* Names in reports: of the program, of the run (default: the file's), of what was computed. */
int plunge_result_names(plunge_result *r, const char *program, const char *run, const char *title);

/* A wall of the tank, n points with the water on its left (down the left side, along the bed, up
 * the right side); closed: the last point is joined to the first. */
int plunge_result_wall(plunge_result *r, int n, const double *points, int closed);

/* The potential energy (J/m, heights from y = 0) of the same water at rest: needed for energies. */
int plunge_result_rest(plunge_result *r, double potential);

/* A sensor of pressure that is the mean over `size` (m) of a wall, a wire that measures the height
 * of the surface, and what the water loses energy by in this program. Each kind is numbered from 0
 * in this order. */
int plunge_result_probe(plunge_result *r, const char *name, double x, double y, double size);
int plunge_result_gauge(plunge_result *r, const char *name, double x);
int plunge_result_term(plunge_result *r, const char *name, const char *help);

/* ---- outputs: times (s) that do not fall, of each kind by itself ---- */

/* The free surface: n points in one open piece, the water on its right (a flat one goes from left
 * to right). */
int plunge_result_surface(plunge_result *r, double time, int n, const double *points);
/* The same in pieces, piece k from point first[k] to first[k + 1] - 1, [pieces + 1]; closed
 * [pieces] or NULL: those that are not 0 are drops and cavities. */
int plunge_result_pieces(plunge_result *r, double time, int pieces, const int *first,
                         const int *closed, const double *points);

/* Particles with pressure (Pa), density (kg/m^3), mass (kg/m), volume (m^2), [n], and velocity
 * (m/s), u, v in turn. NULL: unknown, at every output. */
int plunge_result_particles(plunge_result *r, double time, int n, const double *points,
                            const double *pressure, const double *density, const double *mass,
                            const double *volume, const double *velocity);

/* ---- series ---- */

/* Energies (J/m): `removed` with water that was taken out; what has left by each term, [terms]. */
int plunge_result_energy(plunge_result *r, double time, double kinetic, double potential,
                         double internal, double removed, const double *terms);
/* Volume (m^2) and what of it was taken out so far; evaluations and seconds of the clock so far. */
int plunge_result_step(plunge_result *r, double time, double dt, double volume, double removed,
                       double evaluations, double wall_time);
int plunge_result_pressure(plunge_result *r, int probe, double time, double pressure);   /* Pa */
int plunge_result_elevation(plunge_result *r, int gauge, double time, double elevation); /* m */

/* A named instant: overturning, touchdown, wall_impact, or another. */
int plunge_result_event(plunge_result *r, const char *name, double time, double x, double y);

#ifdef __cplusplus
}
#endif
#endif
