#include "compare/movie/movie.h"

#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/base/array.h"
#include "compare/child.h"
#include "compare/drawing.h"
#include "compare/movie/film.h"
#include "compare/output.h"
#include "compare/overlays.h"
#include "compare/pick.h"

enum { BATCH = 16, MOST_FRAMES = 99999, LOOKS = 5, WIDTH = 1280 /* px, unless asked for */ };

struct movie {
  const struct cmp_movie_plan *plan;
  struct progress *progress;
  struct comparison *c;
  struct cmp_shades shades;
  struct cmp_overlay overlay; /* alike in all frames, but for the figure */
  struct cmp_figures figures;
  size_t *figure;          /* of each frame of the batch, SIZE_MAX for others, [n_times], owned */
  struct cmp_cloud *cloud; /* [n_times], of one run; [n_times][n_runs], of all; owned */
  struct cmp_cloud *clouds;
};

bool cmp_movie_is_film(const char *path) {
  return cmp_film_of(path) != NULL;
}

/* ---- what is shown ---- */

/* The outputs of the first result within the times asked for. */
static enum status times_take(const struct result_file *file, const struct cmp_movie_plan *plan,
                              double **times, size_t *n) {
  const size_t all = file->n_surfaces;
  CHECK(all, ERR_USAGE, "%s has no surfaces (/surface)%s, so no outputs to be drawn", file->path,
        file->n_outputs ? ", and no file has /walls, without which its particles show none" : "");
  TRY(array_create(times, all, "frames"));
  *n = 0;
  for (size_t k = 0; k < all; k++)
    if (file->surface_time[k] >= plan->from * (1 - 1e-9) &&
        file->surface_time[k] <= plan->to * (1 + 1e-9))
      (*times)[(*n)++] = file->surface_time[k];
  CHECK(*n, ERR_USAGE, "%s has no output from %g s to %g s; its outputs are from %g s to %g s",
        file->path, plan->from, plan->to, file->surface_time[0], file->surface_time[all - 1]);
  CHECK(*n <= MOST_FRAMES, ERR_USAGE, "%zu frames are more than %d; choose --from and --to", *n,
        MOST_FRAMES);
  return OK;
}

/* By the names of their runs; a name that came before is numbered. */
static void name_alone(struct comparison *c) {
  for (size_t r = 0; r < c->n_runs; r++) {
    size_t copies = 1;
    for (size_t q = 0; q < r; q++)
      copies += !strcmp(c->run[q].data.file->run, c->run[r].data.file->run);
    char *label = c->run[r].data.label;
    const size_t room = sizeof c->run[r].data.label;
    if (copies > 1)
      snprintf(label, room, "%.60s (%zu)", c->run[r].data.file->run, copies);
    else
      snprintf(label, room, "%.80s", c->run[r].data.file->run);
  }
}

static void view_join(struct geo_box *all, const struct geo_box *one) {
  for (int k = 0; k < 2; k++) {
    all->min[k] = fmin(all->min[k], one->min[k]);
    all->max[k] = fmax(all->max[k], one->max[k]);
  }
}

/* One view, and one range of colours, for all frames. */
static enum status look_choose(struct movie *m) {
  const struct comparison *c = m->c;
  size_t look[LOOKS];
  m->overlay.view = cmp_panes_view(c, 0);
  for (size_t k = 1; k < c->n_times; k++) {
    const struct geo_box view = cmp_panes_view(c, k);
    view_join(&m->overlay.view, &view);
  }
  m->overlay.layout = cmp_panes_layout(&m->overlay.view, cmp_runs_picked(c, CMP_PANELS));
  for (size_t k = 0; k < LOOKS; k++) look[k] = (c->n_times - 1) * k / (LOOKS - 1);
  m->shades.field = m->plan->field;
  m->shades.alone = !m->plan->overlay;
  m->shades.film = true;
  bool any = false;
  bool common = !m->plan->overlay;
  for (size_t k = 0; k < c->n_times; k++) common = common || cmp_comparison_has_output(c, k);
  CHECK(common, ERR_USAGE,
        "no other result has an output at any of the %zu times of %s; --what pressure shows each "
        "for itself, and the first named is the one whose times are taken",
        c->n_times, c->ref.data.file->path);
  TRY(cmp_shades_choose(c, LOOKS, look, &m->shades, &any));
  CHECK(any || m->plan->surfaces, ERR_USAGE,
        "none of the results has points in its water with %s; --what overlay draws surfaces alone",
        cmp_fields[m->plan->field].stored);
  return OK;
}

/* ---- frames ---- */

static enum status batch_begin(struct movie *m, size_t first, size_t end) {
  const struct comparison *c = m->c;
  for (size_t k = first; k < end; k++) {
    struct cmp_figure *fig;
    TRY(cmp_figure_begin(&m->figures, CMP_SECTION_OVERLAY, true, CMP_PANELS_WIDTH,
                         m->overlay.layout.total, &fig, "frame-%05zu", k + 1));
    m->figure[k] = m->figures.n - 1;
    TRY(cmp_panes_surfaces(c, &m->figures, fig, k, CMP_PANELS));
  }
  for (size_t r = 0; r < c->n_runs; r++) {
    if (!cmp_run_is_picked(c, r, CMP_PANELS)) continue;
    TRY(cmp_clouds_write(c, r, m->plan->field, &m->figures, m->figure, m->cloud));
    for (size_t k = first; k < end; k++) m->clouds[k * c->n_runs + r] = m->cloud[k];
  }
  return OK;
}

static enum status batch_draw(struct movie *m, size_t first, size_t end) {
  const struct cmp_drawing_limits limits = {CMP_DRAWING_LIMITS.each, INFINITY};
  TRY(batch_begin(m, first, end));
  for (size_t k = first; k < end; k++) {
    m->overlay.figure = m->figure[k];
    TRY(cmp_overlay_draw(m->c, &m->figures, k, &m->overlay, &m->shades,
                         &m->clouds[k * m->c->n_runs]));
    m->figure[k] = SIZE_MAX;
  }
  TRY(cmp_figures_draw(&m->figures, limits));
  return cmp_figures_clear(&m->figures);
}

static enum status frames_draw(struct movie *m) {
  const size_t n = m->c->n_times;
  TRY(array_create(&m->figure, n, "frames"));
  TRY(array_create(&m->cloud, n, "frames"));
  TRY(array_create(&m->clouds, n * m->c->n_runs, "frames"));
  for (size_t k = 0; k < n; k++) m->figure[k] = SIZE_MAX;
  for (size_t first = 0; first < n; first += BATCH) {
    CHECK(!progress_stop_requested(), INTERRUPTED, "stopped while drawing frames");
    TRY(batch_draw(m, first, first + BATCH < n ? first + BATCH : n));
    progress_count(m->progress, first + BATCH < n ? first + BATCH : n, n, "frames");
  }
  return OK;
}

/* ---- into place ---- */

static bool is_frame(const char *name) {
  return strlen(name) == strlen("frame-00001.png") && !strncmp(name, "frame-", 6) &&
         strspn(name + 6, "0123456789") == 5 && !strcmp(name + 11, ".png");
}

/* Those of an earlier movie, which may have had more. */
static void frames_remove(const char *folder) {
  DIR *dir = opendir(folder);
  for (struct dirent *e; dir && (e = readdir(dir));) {
    char path[PATH_MAX];
    if (is_frame(e->d_name) && cmp_path_join(folder, e->d_name, path) == OK) unlink(path);
  }
  if (dir) closedir(dir);
}

static enum status frames_place(const struct movie *m, const char *folder) {
  TRY(cmp_directory_make(folder));
  frames_remove(folder);
  for (size_t k = 0; k < m->c->n_times; k++) {
    char name[32], from[PATH_MAX], to[PATH_MAX];
    snprintf(name, sizeof name, "frame-%05zu.png", k + 1);
    TRY(cmp_path_join(m->figures.temporary, name, from));
    TRY(cmp_path_join(folder, name, to));
    CHECK(rename(from, to) == 0, ERR_IO, "cannot write %s: %s", to, strerror(errno));
  }
  return OK;
}

static enum status film_place(const struct movie *m, const struct cmp_film *film) {
  char name[32], from[PATH_MAX];
  progress_say(m->progress, "encoding %s", m->plan->out);
  TRY(cmp_film_encode(film, m->figures.temporary, m->plan->fps, m->plan->width, m->plan->height));
  snprintf(name, sizeof name, "movie%s", film->suffix);
  TRY(cmp_path_join(m->figures.temporary, name, from));
  CHECK(rename(from, m->plan->out) == 0, ERR_IO, "cannot write %s: %s", m->plan->out,
        strerror(errno));
  return OK;
}

/* "dam-frames" of dam.mp4. */
static enum status folder_name(const struct cmp_movie_plan *plan, const struct cmp_film *film,
                               char *out) {
  const size_t n = strlen(plan->out) - (film ? strlen(film->suffix) : 0);
  const int length = snprintf(out, PATH_MAX, "%.*s%s", (int)n, plan->out, film ? "-frames" : "");
  CHECK(length < PATH_MAX, ERR_IO, "the path %.100s... is too long", plan->out);
  return OK;
}

/* The folder that the result is put in: beside it pictures are drawn. */
static void folder_of(const char *path, char *out) {
  char copy[PATH_MAX];
  size_t n = (size_t)snprintf(copy, sizeof copy, "%s", path);
  while (n > 1 && copy[n - 1] == '/') copy[--n] = 0;
  char *slash = strrchr(copy, '/');
  if (slash) slash[slash == copy] = 0;
  snprintf(out, PATH_MAX, "%s", slash ? copy : ".");
}

static double scale_of(const struct movie *m) {
  const struct cmp_movie_plan *p = m->plan;
  if (!p->width) return (double)WIDTH / CMP_PANELS_WIDTH;
  return fmin((double)p->width / CMP_PANELS_WIDTH, (double)p->height / m->overlay.layout.total);
}

static enum status draw_and_place(struct movie *m, char *where) {
  const struct cmp_film *film = cmp_film_of(m->plan->out);
  const bool encodes = film && cmp_child_exists("ffmpeg");
  char folder[PATH_MAX];
  struct stat about;
  CHECK(!film || stat(m->plan->out, &about) != 0 || !S_ISDIR(about.st_mode), ERR_USAGE,
        "%s is a folder; choose another --out", m->plan->out);
  CHECK(film || stat(m->plan->out, &about) != 0 || S_ISDIR(about.st_mode), ERR_USAGE,
        "%s is not a folder; choose another --out", m->plan->out);
  folder_of(m->plan->out, folder);
  CHECK(!progress_stop_requested(), INTERRUPTED, "stopped"); /* from here on it is asked */
  TRY(cmp_directory_make(folder));
  TRY(cmp_figures_open_frames(folder, scale_of(m), &m->figures));
  progress_say(m->progress, "drawing %zu frames", m->c->n_times);
  TRY(frames_draw(m));
  if (encodes) {
    snprintf(where, PATH_MAX, "%s", m->plan->out);
    return film_place(m, film);
  }
  TRY(folder_name(m->plan, film, where));
  return frames_place(m, where);
}

enum status cmp_movie_write(const struct case_file *settings, size_t n,
                            struct result_file *const *files, const struct cmp_movie_plan *plan,
                            struct progress *progress, char where[PATH_MAX]) {
  struct movie m = {.plan = plan, .progress = progress, .figures = {.lock = -1}};
  const bool alone = !plan->overlay;
  double *times = NULL;
  size_t n_times = 0;
  enum status status;
  ATTEMPT(times_take(files[0], plan, &times, &n_times));
  const struct case_file s =
      cmp_settings_at(settings, settings ? &settings->compare.window : NULL, times, n_times);
  ATTEMPT(
      cmp_comparison_open(&s, files[0], alone ? n : n - 1, alone ? files : files + 1, true, &m.c));
  ATTEMPT(cmp_runs_rank(m.c));
  if (alone) name_alone(m.c);
  ATTEMPT(look_choose(&m));
  progress_begin(progress, "movie", 1, 1);
  status = draw_and_place(&m, where);
  progress_end(progress, status == OK ? "done" : status == INTERRUPTED ? "stopped" : "failed");
done:
  cmp_figures_close(&m.figures);
  cmp_comparison_destroy(m.c);
  free(m.figure);
  free(m.cloud);
  free(m.clouds);
  free(times);
  return status;
}
