#include "compare/figure.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "compare/output.h"

enum { WORKERS = 2 }; /* gnuplots at a time */

/* ---- the set of figures ---- */

enum status cmp_figures_open(const char *out_dir, struct cmp_figures *f) {
  *f = (struct cmp_figures){0};
  TRY(cmp_path_join(out_dir, "figures", f->dir));
  TRY(cmp_directory_make(f->dir));
  TRY(cmp_path_join(f->dir, ".drawing-XXXXXX", f->temporary));
  if (!mkdtemp(f->temporary)) {
    f->temporary[0] = 0;
    return status_raise(ERR_IO, "cannot make a folder in %s: %s", f->dir, strerror(errno));
  }
  return OK;
}

void cmp_figures_close(struct cmp_figures *f) {
  for (size_t i = 0; i < f->n; i++)
    if (f->figure[i].script) fclose(f->figure[i].script);
  DIR *dir = f->temporary[0] ? opendir(f->temporary) : NULL;
  for (struct dirent *e; dir && (e = readdir(dir));) {
    char path[PATH_MAX];
    if (e->d_name[0] != '.' && cmp_path_join(f->temporary, e->d_name, path) == OK) unlink(path);
  }
  if (dir) {
    closedir(dir);
    rmdir(f->temporary);
  }
  free(f->figure);
  *f = (struct cmp_figures){0};
}

static enum status stream_open(const struct cmp_figures *f, const char *name, const char *suffix,
                               FILE **stream) {
  char file[128], path[PATH_MAX];
  snprintf(file, sizeof file, "%s%s", name, suffix);
  TRY(cmp_path_join(f->temporary, file, path));
  *stream = fopen(path, "w");
  CHECK(*stream, ERR_IO, "cannot write %s: %s", path, strerror(errno));
  return OK;
}

enum status cmp_figure_begin(struct cmp_figures *f, enum cmp_section section, bool raster,
                             int width, int height, struct cmp_figure **figure, const char *name,
                             ...) {
  if (f->n == f->room) {
    size_t room = f->room ? 2 * f->room : 16;
    struct cmp_figure *more = realloc(f->figure, room * sizeof *more);
    CHECK(more, ERR_MEMORY, "no memory for %zu figures", room);
    f->figure = more;
    f->room = room;
  }
  struct cmp_figure *fig = &f->figure[f->n];
  *fig =
      (struct cmp_figure){.section = section, .raster = raster, .width = width, .height = height};
  va_list args;
  va_start(args, name);
  vsnprintf(fig->name, sizeof fig->name, name, args);
  va_end(args);
  TRY(stream_open(f, fig->name, ".gp", &fig->script));
  f->n++;
  fprintf(fig->script,
          "# gnuplot %s.gp draws %s.svg, .pdf and .png from the .csv files beside it\n"
          "reset session\nset encoding utf8\nset datafile separator ','\n",
          fig->name, fig->name);
  *figure = fig;
  return OK;
}

void cmp_figure_formats(struct cmp_figure *fig) {
  fprintf(fig->script,
          "do for [fmt in 'svg pdf png'] {\n"
          "if (fmt eq 'svg') { set terminal svg size %d,%d dynamic font 'sans-serif,14' "
          "background '#ffffff' linewidth 1.3 }\n"
          "if (fmt eq 'pdf') { set terminal pdfcairo size %.3fin,%.3fin font 'sans,10' "
          "linewidth 1.3 background '#ffffff' }\n"
          "if (fmt eq 'png') { set terminal pngcairo size %d,%d font 'sans,21' linewidth 2.6 "
          "pointscale 2 background '#ffffff' }\n"
          "set output '%s.'.fmt\n"
          "set border linewidth 0.7 linecolor '#444444'\n"
          "set tics nomirror scale 0.6 textcolor '#222222'\n"
          "set grid linetype 1 linecolor '#e4e4e4' linewidth 0.5\n",
          fig->width, fig->height, fig->width / 100.0, fig->height / 100.0, 2 * fig->width,
          2 * fig->height, fig->name);
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

/* ---- drawing ---- */

/* In the child: nothing here but system calls. */
static void child_run(const char *dir, const char *script, const char *log) {
  int null = open("/dev/null", O_RDWR);
  if (null < 0 || chdir(dir) != 0) _exit(126);
  int complaints = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (complaints < 0) _exit(126);
  dup2(null, STDIN_FILENO);
  dup2(null, STDOUT_FILENO);
  dup2(complaints, STDERR_FILENO);
  execlp("gnuplot", "gnuplot", "-d", script, (char *)NULL);
  _exit(127);
}

static enum status child_start(const struct cmp_figures *f, const struct cmp_figure *fig,
                               pid_t *pid) {
  char script[128], log[128];
  snprintf(script, sizeof script, "%s.gp", fig->name);
  snprintf(log, sizeof log, "%s.log", fig->name);
  *pid = fork();
  CHECK(*pid >= 0, ERR_IO, "cannot start gnuplot: %s", strerror(errno));
  if (*pid == 0) child_run(f->temporary, script, log);
  return OK;
}

/* gnuplot's first complaint about a figure, for the message. */
static void complaint_read(const struct cmp_figures *f, const struct cmp_figure *fig, char *out,
                           size_t room) {
  char name[128], path[PATH_MAX], line[256];
  snprintf(name, sizeof name, "%s.log", fig->name);
  snprintf(out, room, "no reason given");
  if (cmp_path_join(f->temporary, name, path) != OK) return;
  FILE *log = fopen(path, "r");
  while (log && fgets(line, sizeof line, log)) {
    line[strcspn(line, "\r\n")] = 0;
    if (strspn(line, " \t^") == strlen(line)) continue;
    snprintf(out, room, "%s", line);
    if (strstr(line, "line ")) break; /* the one that names the place */
  }
  if (log) fclose(log);
}

static enum status child_check(const struct cmp_figures *f, const struct cmp_figure *fig,
                               int outcome) {
  if (WIFEXITED(outcome) && WEXITSTATUS(outcome) == 0) return OK;
  CHECK(!WIFSIGNALED(outcome), ERR_IO, "drawing %s was stopped (%s)", fig->name,
        strsignal(WTERMSIG(outcome)));
  CHECK(!(WIFEXITED(outcome) && WEXITSTATUS(outcome) == 127), ERR_IO,
        "cannot draw figures: gnuplot is not installed (apt install gnuplot-nox)");
  char why[256];
  complaint_read(f, fig, why, sizeof why);
  return status_raise(ERR_IO, "gnuplot could not draw %s: %s", fig->name, why);
}

/* A full disk does not stop gnuplot: the end of what it wrote tells. */
static enum status drawing_check(const struct cmp_figures *f, const struct cmp_figure *fig) {
  static const struct {
    const char *suffix, *end;
  } formats[] = {{".svg", "</svg>"}, {".pdf", "%%EOF"}, {".png", "IEND"}};
  for (size_t k = 0; k < sizeof formats / sizeof *formats; k++) {
    char name[128], path[PATH_MAX], tail[33] = "";
    snprintf(name, sizeof name, "%s%s", fig->name, formats[k].suffix);
    TRY(cmp_path_join(f->temporary, name, path));
    FILE *file = fopen(path, "rb");
    size_t n = 0;
    if (file && fseek(file, -32, SEEK_END) == 0) n = fread(tail, 1, 32, file);
    if (file) fclose(file);
    CHECK(n && memmem(tail, n, formats[k].end, strlen(formats[k].end)), ERR_IO,
          "gnuplot wrote only part of %s/%s; is the disk full?", f->dir, name);
  }
  return OK;
}

static bool is_kept(const char *name) {
  const char *dot = strrchr(name, '.');
  static const char *const kept[] = {".gp", ".csv", ".svg", ".pdf", ".png"};
  for (size_t k = 0; dot && k < sizeof kept / sizeof *kept; k++)
    if (!strcmp(dot, kept[k])) return !strstr(name, ".layer");
  return false;
}

static enum status figures_publish(struct cmp_figures *f) {
  DIR *dir = opendir(f->temporary);
  CHECK(dir, ERR_IO, "cannot read %s: %s", f->temporary, strerror(errno));
  enum status status = OK;
  for (struct dirent *e; status == OK && (e = readdir(dir));) {
    char from[PATH_MAX], to[PATH_MAX];
    if (!is_kept(e->d_name)) continue;
    ATTEMPT(cmp_path_join(f->temporary, e->d_name, from));
    ATTEMPT(cmp_path_join(f->dir, e->d_name, to));
    if (rename(from, to) != 0)
      status = status_raise(ERR_IO, "cannot write %s: %s", to, strerror(errno));
  }
done:
  closedir(dir);
  return status;
}

enum status cmp_figures_draw(struct cmp_figures *f) {
  enum status status = OK;
  pid_t pid[WORKERS] = {0};
  size_t drawing[WORKERS], next = 0, running = 0;
  while (running || (next < f->n && status == OK)) {
    while (running < WORKERS && next < f->n && status == OK) {
      size_t slot = 0;
      while (pid[slot]) slot++;
      status = child_start(f, &f->figure[next], &pid[slot]);
      if (status != OK) {
        pid[slot] = 0;
        break;
      }
      drawing[slot] = next++;
      running++;
    }
    if (!running) break;
    int outcome;
    pid_t ended = waitpid(-1, &outcome, 0);
    if (ended < 0 && errno == EINTR) continue;
    for (size_t slot = 0; slot < WORKERS; slot++) {
      if (!pid[slot] || (ended >= 0 && pid[slot] != ended)) continue;
      if (status == OK)
        status = ended < 0 ? status_raise(ERR_IO, "lost sight of gnuplot: %s", strerror(errno))
                           : child_check(f, &f->figure[drawing[slot]], outcome);
      pid[slot] = 0;
      running--;
    }
  }
  for (size_t i = 0; status == OK && i < f->n; i++) status = drawing_check(f, &f->figure[i]);
  if (status == OK) status = figures_publish(f);
  f->drawn = status == OK;
  return status;
}
