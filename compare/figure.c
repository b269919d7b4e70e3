#include "compare/figure.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

#include "common/base/array.h"
#include "common/base/file.h"
#include "common/base/progress.h"
#include "compare/output.h"

#define TEMPORARY ".drawing-"
#define WRITTEN   ".written" /* the list of a report's figures; of a set: and its name */

/* ---- folders ---- */

static void folder_remove(const char *path) {
  DIR *dir = opendir(path);
  for (struct dirent *e; dir && (e = readdir(dir));) {
    char file[PATH_MAX];
    if (cmp_path_join(path, e->d_name, file) == OK) unlink(file); /* fails for . and .. */
  }
  if (dir) closedir(dir);
  rmdir(path);
}

/* The lock tells a folder in use from one that a killed report has left: it goes with the process.
 * -1: somebody has it, or it is no folder. */
static int folder_lock(const char *path) {
  int lock = open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (lock >= 0 && flock(lock, LOCK_EX | LOCK_NB) != 0) {
    close(lock);
    lock = -1;
  }
  return lock;
}

static void leftovers_remove(const char *figures) {
  DIR *dir = opendir(figures);
  for (struct dirent *e; dir && (e = readdir(dir));) {
    char path[PATH_MAX];
    if (strncmp(e->d_name, TEMPORARY, strlen(TEMPORARY)) != 0 ||
        cmp_path_join(figures, e->d_name, path) != OK)
      continue;
    int lock = folder_lock(path);
    if (lock < 0) continue;
    folder_remove(path);
    close(lock);
  }
  if (dir) closedir(dir);
}

/* ---- the set of figures ---- */

const struct cmp_format cmp_formats[CMP_FORMATS] = {{"svg", ".svg", "</svg>", "SVG"},
                                                    {"pdf", ".pdf", "%%EOF", "PDF of two columns"},
                                                    {"column", "-column.pdf", "%%EOF", "of one"},
                                                    {"png", ".png", "IEND", "PNG"}};

bool cmp_figure_has(const struct cmp_figure *fig, const struct cmp_format *format) {
  if (*fig->only) return !strcmp(fig->only, format->fmt);
  return fig->column_height || strcmp(format->fmt, "column") != 0;
}

static enum status temporary_make(struct cmp_figures *f) {
  TRY(cmp_path_join(f->dir, TEMPORARY "XXXXXX", f->temporary));
  if (!mkdtemp(f->temporary)) {
    f->temporary[0] = 0;
    return status_raise(ERR_IO, "cannot make a folder in %s: %s", f->dir, strerror(errno));
  }
  f->lock = folder_lock(f->temporary);
  return OK;
}

static enum status open_folder(const char *out_dir, struct cmp_figures *f) {
  TRY(cmp_path_join(out_dir, "figures", f->dir));
  return cmp_directory_make(f->dir);
}

enum status cmp_figures_open(const char *out_dir, struct cmp_figures *f) {
  *f = (struct cmp_figures){.lock = -1, .list = WRITTEN};
  TRY(open_folder(out_dir, f));
  leftovers_remove(f->dir);
  return temporary_make(f);
}

/* It leaves leftovers alone: what another is just making looks like one, until it is locked. */
enum status cmp_figures_open_set(const char *out_dir, const char *set, struct cmp_figures *f) {
  *f = (struct cmp_figures){.lock = -1};
  const int n = snprintf(f->list, sizeof f->list, WRITTEN "-%s", set);
  CHECK(n > 0 && n < (int)sizeof f->list, ERR_USAGE, "the name %.100s... is too long", set);
  TRY(open_folder(out_dir, f));
  return temporary_make(f);
}

/* What stands behind the dot of a file's name, if it is a format. */
static const char *format_of(const char *name) {
  const char *dot = strrchr(name, '.');
  for (size_t k = 0; dot && k < CMP_FORMATS; k++)
    if (!strcmp(dot, cmp_formats[k].suffix)) return cmp_formats[k].fmt;
  return NULL;
}

enum status cmp_figures_open_file(const char *path, struct cmp_figures *f) {
  *f = (struct cmp_figures){.lock = -1};
  const char *slash = strrchr(path, '/');
  CHECK(format_of(slash ? slash : path), ERR_USAGE,
        "%s is no name of a figure; allowed: NAME.svg, NAME.pdf, NAME.png", path);
  int n = snprintf(f->target, sizeof f->target, "%s", path);
  CHECK(n > 0 && n < PATH_MAX, ERR_IO, "the path %.100s... is too long", path);
  if (slash)
    snprintf(f->dir, sizeof f->dir, "%.*s", (int)(slash - path + 1), path);
  else
    snprintf(f->dir, sizeof f->dir, ".");
  leftovers_remove(f->dir);
  return temporary_make(f);
}

enum status cmp_figures_open_frames(const char *dir, double fine, struct cmp_figures *f) {
  *f = (struct cmp_figures){.lock = -1, .frames = true, .fine = fine};
  const int n = snprintf(f->dir, sizeof f->dir, "%s", dir);
  CHECK(n > 0 && n < PATH_MAX, ERR_IO, "the path %.100s... is too long", dir);
  leftovers_remove(f->dir);
  return temporary_make(f);
}

static bool is_frame(const char *name) {
  const char *format = format_of(name);
  return format && !strcmp(format, "png") && !strstr(name, ".layer");
}

enum status cmp_figures_clear(struct cmp_figures *f) {
  DIR *dir = opendir(f->temporary);
  CHECK(dir, ERR_IO, "cannot read %s: %s", f->temporary, strerror(errno));
  for (struct dirent *e; (e = readdir(dir));) {
    char path[PATH_MAX];
    if (!is_frame(e->d_name) && cmp_path_join(f->temporary, e->d_name, path) == OK)
      unlink(path); /* fails for . and .. */
  }
  closedir(dir);
  f->n = 0;
  return OK;
}

/* Whether a file is of a figure: NAME.svg, NAME-points-1.csv. */
static bool is_of(const char *file, const char *figure) {
  const size_t n = strlen(figure);
  return !strncmp(file, figure, n) && (file[n] == '.' || file[n] == '-');
}

void cmp_figures_forget(struct cmp_figures *f, size_t n) {
  for (; f->n > n; f->n--) {
    const struct cmp_figure *fig = &f->figure[f->n - 1];
    DIR *dir = opendir(f->temporary);
    if (fig->script) fclose(fig->script);
    for (struct dirent *e; dir && (e = readdir(dir));) {
      char path[PATH_MAX];
      if (is_of(e->d_name, fig->name) && cmp_path_join(f->temporary, e->d_name, path) == OK)
        unlink(path);
    }
    if (dir) closedir(dir);
  }
}

void cmp_figures_close(struct cmp_figures *f) {
  for (size_t i = 0; i < f->n; i++)
    if (f->figure[i].script) fclose(f->figure[i].script);
  if (f->temporary[0]) {
    folder_remove(f->temporary);
    if (f->lock >= 0) close(f->lock);
  }
  free(f->figure);
  *f = (struct cmp_figures){.lock = -1};
}

size_t cmp_figures_missing(const struct cmp_figures *f) {
  size_t missing = 0;
  for (size_t i = 0; i < f->n; i++) missing += *f->figure[i].missing != 0;
  return missing;
}

static enum status stream_open(const struct cmp_figures *f, const char *name, const char *suffix,
                               FILE **stream) {
  char file[128], path[PATH_MAX];
  snprintf(file, sizeof file, "%s%s", name, suffix);
  TRY(cmp_path_join(f->temporary, file, path));
  *stream = file_create(path);
  CHECK(*stream, ERR_IO, "cannot write %s: %s", path, strerror(errno));
  return OK;
}

/* Whether a name is another, or with "-column" is. */
static bool alike(const char *name, const char *other) {
  const size_t n = strlen(name);
  return !strncmp(name, other, n) && (!other[n] || !strcmp(other + n, "-column"));
}

static bool name_taken(const struct cmp_figures *f, const char *name) {
  for (size_t i = 0; i < f->n; i++)
    if (alike(name, f->figure[i].name) || alike(f->figure[i].name, name)) return true;
  return false;
}

/* Two probes "P/1" and "P-1" make one name; files of one called "P-column" would be another's. */
static void name_distinct(const struct cmp_figures *f, char *name, size_t room) {
  size_t n = strlen(name);
  for (size_t k = 2; name_taken(f, name); k++) snprintf(name + n, room - n, "-%zu", k);
}

enum status cmp_figure_begin(struct cmp_figures *f, enum cmp_section section, bool raster,
                             int width, int height, struct cmp_figure **figure, const char *name,
                             ...) {
  CHECK(!progress_is_stopped(), INTERRUPTED, "stopped while preparing figures");
  TRY(array_grow(&f->figure, &f->room, f->n + 1, "figures"));
  struct cmp_figure *fig = &f->figure[f->n];
  *fig =
      (struct cmp_figure){.section = section, .raster = raster, .width = width, .height = height};
  fig->fine = f->fine > 0 ? f->fine : raster ? 1.3 : 2; /* heavy ones stand in the page */
  fig->layer = f->fine > 0 ? f->fine : 2;
  fig->thumb = f->thumb;
  if (f->frames) snprintf(fig->only, sizeof fig->only, "png");
  if (*f->target) snprintf(fig->only, sizeof fig->only, "%s", format_of(f->target));
  va_list args;
  const int used = snprintf(fig->name, sizeof fig->name, "%s", f->prefix);
  va_start(args, name);
  vsnprintf(fig->name + used, sizeof fig->name - (size_t)used, name, args);
  va_end(args);
  name_distinct(f, fig->name, sizeof fig->name);
  TRY(stream_open(f, fig->name, ".gp", &fig->script));
  f->n++;
  fprintf(fig->script,
          "# gnuplot %s.gp draws %s.svg and others from the .csv files beside it\n"
          "reset session\nset encoding utf8\nset datafile separator ','\n",
          fig->name, fig->name);
  *figure = fig;
  return OK;
}

#define PX_PER_INCH (5 * 25.4)

/* The same once more, small, into NAME.thumb.png. */
static void thumb_write(const struct cmp_figure *fig) {
  const double scale = (double)fig->thumb / fig->width;
  fprintf(fig->script,
          "if (fmt eq 'thumb') { set terminal pngcairo size %d,%.0f font 'sans,%.4g' linewidth %.4g "
          "pointscale %.4g background '#ffffff'; small = ',%.4g' }\n",
          fig->thumb, scale * fig->height + 0.5, 10.5 * scale, fmax(1.3 * scale, 0.7), scale,
          8.25 * scale);
}

void cmp_figure_formats(struct cmp_figure *fig) {
  fputs("do for [fmt in '", fig->script);
  for (size_t k = 0; k < CMP_FORMATS; k++)
    if (cmp_figure_has(fig, &cmp_formats[k])) fprintf(fig->script, " %s", cmp_formats[k].fmt);
  if (fig->thumb) fputs(" thumb", fig->script);
  fprintf(fig->script,
          "'] {\ncolumn = fmt eq 'column'\nwide = column ? %d : %d\nhigh = column ? %d : %d\n"
          "narrow = wide <= %d\n"
          "if (fmt eq 'svg') { set terminal svg size %d,%d dynamic font 'sans-serif,14' "
          "background '#ffffff' linewidth 1.3 }\n"
          "if (fmt eq 'png') { set terminal pngcairo size %.0f,%.0f font 'sans,%.4g' linewidth "
          "%.4g pointscale %.4g background '#ffffff' }\n"
          "if (fmt eq 'pdf' || column) { set terminal pdfcairo size (wide/%.1f)in,(high/%.1f)in "
          "font 'sans,8' fontscale 0.75 linewidth 1.1 background '#ffffff' }\n",
          CMP_PANELS_NARROW, fig->width, fig->column_height, fig->height, CMP_PANELS_NARROW,
          fig->width, fig->height, fig->fine * fig->width, fig->fine * fig->height,
          10.5 * fig->fine, 1.3 * fig->fine, fig->fine, PX_PER_INCH, PX_PER_INCH);
  fprintf(fig->script,
          "small = fmt eq 'svg' ? ',11' : fmt eq 'png' ? ',%.4g' : ',6.5'\n"
          "set output '%s'.(column ? '-column.pdf' : fmt eq 'thumb' ? '.thumb.png' : '.'.fmt)\n",
          8.25 * fig->fine, fig->name);
  if (fig->thumb) thumb_write(fig);
  fputs("set style textbox opaque noborder fillcolor '#ffffff' margins 0.6,0.6\n"
        "set border linewidth 0.7 linecolor '#444444'\n"
        "set tics nomirror scale 0.6 textcolor '#222222'\n"
        "set grid linetype 1 linecolor '#e4e4e4' linewidth 0.5\n",
        fig->script);
}

static void margin(FILE *s, const char *side, double usual, double column) {
  fprintf(s, "set %cmargin at screen narrow ? %.5f : %.5f\n", *side, column, usual);
}

void cmp_figure_margins(const struct cmp_figure *fig, const struct cmp_margins *usual,
                        const struct cmp_margins *column) {
  const struct cmp_margins *u = usual, *c = column ? column : usual;
  const double high = fig->height, low = fig->column_height ? fig->column_height : high;
  margin(fig->script, "left", u->left / fig->width, c->left / CMP_PANELS_NARROW);
  margin(fig->script, "right", 1 - u->right / fig->width, 1 - c->right / CMP_PANELS_NARROW);
  margin(fig->script, "top", 1 - u->top / high, 1 - c->top / low);
  margin(fig->script, "bottom", 1 - (u->top + u->height) / high, 1 - (c->top + c->height) / low);
}

enum status cmp_figure_end(struct cmp_figure *fig) {
  fprintf(fig->script, "unset output\n}\n");
  FILE *script = fig->script;
  fig->script = NULL;
  return cmp_stream_close(script, fig->name);
}

enum status cmp_figure_data(struct cmp_figures *f, const struct cmp_figure *fig, const char *suffix,
                            FILE **stream) {
  return stream_open(f, fig->name, suffix, stream);
}

enum status cmp_figure_data_end(const struct cmp_figure *fig, FILE *stream) {
  return cmp_stream_close(stream, fig->name);
}

/* ---- into place ---- */

static bool is_kept(const char *name) {
  const char *dot = strrchr(name, '.');
  bool source = dot && (!strcmp(dot, ".gp") || !strcmp(dot, ".csv"));
  return (source || format_of(name)) && !strstr(name, ".layer");
}

/* Pictures of an earlier report would pass for those that this one lacks. */
static void earlier_remove(const struct cmp_figures *f, const struct cmp_figure *fig) {
  for (size_t k = 0; k < CMP_FORMATS; k++) {
    const char *dir[] = {f->dir, f->temporary};
    char name[128], path[PATH_MAX];
    snprintf(name, sizeof name, "%s%s", fig->name, cmp_formats[k].suffix);
    for (size_t i = 0; i < 2; i++)
      if (cmp_path_join(dir[i], name, path) == OK) unlink(path);
  }
}

/* What an earlier report has put there, of figures that this one has not: by its own list, so that
 * nobody else's file goes. */
static void stale_remove(const struct cmp_figures *f) {
  char list[PATH_MAX], path[PATH_MAX], fresh[PATH_MAX], name[256];
  if (cmp_path_join(f->dir, f->list, list) != OK) return;
  FILE *in = fopen(list, "r");
  while (in && fgets(name, sizeof name, in)) {
    name[strcspn(name, "\n")] = 0;
    if (!is_kept(name) || strchr(name, '/') || cmp_path_join(f->dir, name, path) != OK ||
        cmp_path_join(f->temporary, name, fresh) != OK)
      continue;
    if (access(fresh, F_OK) != 0) unlink(path);
  }
  if (in) fclose(in);
}

static enum status target_publish(const struct cmp_figures *f) {
  const struct cmp_figure *fig = &f->figure[0];
  char name[128], from[PATH_MAX];
  if (*fig->missing) return OK; /* the drawing says so */
  snprintf(name, sizeof name, "%s.%s", fig->name, fig->only);
  TRY(cmp_path_join(f->temporary, name, from));
  CHECK(rename(from, f->target) == 0, ERR_IO, "cannot write %s: %s", f->target, strerror(errno));
  return OK;
}

static enum status list_publish(const struct cmp_figures *f) {
  char from[PATH_MAX], to[PATH_MAX];
  TRY(cmp_path_join(f->temporary, f->list, from));
  TRY(cmp_path_join(f->dir, f->list, to));
  CHECK(rename(from, to) == 0, ERR_IO, "cannot write %s: %s", to, strerror(errno));
  return OK;
}

enum status cmp_figures_publish(struct cmp_figures *f) {
  if (f->frames) return OK;
  if (*f->target) return target_publish(f);
  for (size_t i = 0; i < f->n; i++)
    if (*f->figure[i].missing) earlier_remove(f, &f->figure[i]);
  stale_remove(f);
  DIR *dir = opendir(f->temporary);
  CHECK(dir, ERR_IO, "cannot read %s: %s", f->temporary, strerror(errno));
  FILE *list = NULL;
  enum status status = stream_open(f, f->list, "", &list);
  for (struct dirent *e; status == OK && (e = readdir(dir));) {
    char from[PATH_MAX], to[PATH_MAX];
    if (!is_kept(e->d_name)) continue;
    ATTEMPT(cmp_path_join(f->temporary, e->d_name, from));
    ATTEMPT(cmp_path_join(f->dir, e->d_name, to));
    if (rename(from, to) != 0)
      status = status_raise(ERR_IO, "cannot write %s: %s", to, strerror(errno));
    else
      fprintf(list, "%s\n", e->d_name);
  }
done:
  closedir(dir);
  if (list) {
    const enum status closed = cmp_stream_close(list, f->list);
    if (status == OK) status = closed;
  }
  return status == OK ? list_publish(f) : status;
}
