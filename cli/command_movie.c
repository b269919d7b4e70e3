#include <argp.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/settings.h"
#include "common/base/text.h"
#include "compare/movie/movie.h"

struct movie_arguments {
  const char *what, *out, *from, *to;
  double fps;
  int width, height;
  char **files; /* [n], in argv */
  size_t n;
};

static void parse_size(struct argp_state *state, const char *text, struct movie_arguments *a) {
  int n = 0;
  const bool read = sscanf(text, "%5dx%5d%n", &a->width, &a->height, &n) == 2 && !text[n];
  if (!read || a->width < 64 || a->height < 64 || a->width > 7680 || a->height > 7680)
    argp_error(state, "--size %s: give pixels from 64x64 to 7680x7680, as in 1280x720", text);
}

static double parse_fps(struct argp_state *state, const char *text) {
  char *end;
  const double fps = strtod(text, &end);
  if (end == text || *end || !(fps >= 0.1 && fps <= 240))
    argp_error(state, "--fps %s: give frames a second, from 0.1 to 240", text);
  return fps;
}

static error_t parse(int key, char *arg, struct argp_state *state) {
  struct movie_arguments *a = state->input;
  switch (key) {
  case 'w':
    a->what = arg;
    return 0;
  case 'o':
    if (!*arg) argp_error(state, "--out: the name is empty");
    a->out = arg;
    return 0;
  case 'r':
    a->fps = parse_fps(state, arg);
    return 0;
  case 's':
    parse_size(state, arg, a);
    return 0;
  case 'f':
    a->from = arg;
    return 0;
  case 't':
    a->to = arg;
    return 0;
  case ARGP_KEY_ARGS:
    a->files = state->argv + state->next;
    a->n = (size_t)(state->argc - state->next);
    return 0;
  case ARGP_KEY_END:
    if (!a->n) argp_error(state, "name at least one result");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

/* "1.2" or "1.2 s", and "4 sqrt(H/g)" as in a case. */
static enum status time_read(const char *option, const char *text, const struct result_file *file,
                             double *time) {
  char *end;
  *time = strtod(text, &end);
  const bool number = end != text && isfinite(*time);
  end += strspn(end, " ");
  if (!strcmp(end, "sqrt(H/g)"))
    *time *= sqrt(file->H / file->g);
  else
    CHECK(number && (!*end || !strcmp(end, "s")), ERR_USAGE,
          "--%s: found %.60s, allowed: a time in s, or as in '4 sqrt(H/g)'", option, text);
  CHECK(number && *time >= 0, ERR_USAGE, "--%s: found %.60s, allowed: a time of at least 0", option,
        text);
  return OK;
}

static enum status what_read(const struct movie_arguments *a, struct cmp_movie_plan *plan) {
  char allowed[128] = "overlay";
  plan->surfaces = !strcmp(a->what, "overlay");
  plan->overlay = plan->surfaces && a->n > 1;
  if (plan->surfaces) return OK;
  for (size_t k = 0; k < CMP_FIELDS; k++) {
    plan->field = (enum cmp_field)k;
    if (!strcmp(a->what, cmp_fields[k].name)) return OK;
    snprintf(allowed + strlen(allowed), sizeof allowed - strlen(allowed), ", %s",
             cmp_fields[k].name);
  }
  return status_raise(ERR_USAGE, "--what: found %.60s, allowed: %s", a->what, allowed);
}

/* A name with a suffix is meant to be a film. */
static enum status out_check(const struct movie_arguments *a) {
  const size_t length = strlen(a->out);
  CHECK(length <= CMP_MOVIE_PATH, ERR_USAGE,
        "--out: found a path of %zu bytes, allowed: at most %d; choose a shorter one", length,
        CMP_MOVIE_PATH);
  const char *slash = strrchr(a->out, '/'), *dot = strrchr(slash ? slash : a->out, '.');
  const char *suffix =
      dot && dot[1] && dot != a->out && dot[-1] != '/' && dot[-1] != '.' ? dot : "";
  const bool film = cmp_movie_is_film(a->out), gif = !strcmp(suffix, ".gif");
  CHECK(film || !*suffix, ERR_USAGE,
        "--out: found a name that ends in %.20s, allowed: .mp4, .webm, .gif, or a folder for "
        "frames, without a suffix",
        suffix);
  CHECK(!gif || a->fps <= 50, ERR_USAGE, "--fps %g: a GIF has at most 50 frames a second", a->fps);
  CHECK(gif || !film || (a->width % 2 == 0 && a->height % 2 == 0), ERR_USAGE,
        "--size %dx%d: such a film has even numbers of pixels", a->width, a->height);
  return OK;
}

static enum status plan_make(const struct movie_arguments *a, const struct result_file *file,
                             struct cmp_movie_plan *plan) {
  *plan = (struct cmp_movie_plan){
      .out = a->out, .fps = a->fps, .width = a->width, .height = a->height, .to = INFINITY};
  TRY(what_read(a, plan));
  TRY(out_check(a));
  if (!file) return OK;
  if (a->from) TRY(time_read("from", a->from, file, &plan->from));
  if (a->to) TRY(time_read("to", a->to, file, &plan->to));
  CHECK(plan->from <= plan->to, ERR_USAGE, "--from %s is after --to %s", a->from, a->to);
  return OK;
}

static enum status movie(const struct movie_arguments *a) {
  struct cmp_movie_plan plan;
  struct case_file *settings = NULL;
  struct progress *progress = progress_create(PROGRESS_AUTO);
  struct result_file **files = calloc(a->n, sizeof *files);
  char where[PATH_MAX] = "";
  int ignored;
  enum status status = files && progress ? OK : status_raise(ERR_MEMORY, "no memory");
  if (status != OK) goto done;
  ATTEMPT(plan_make(a, NULL, &plan)); /* before anything is read */
  for (size_t i = 0; i < a->n; i++) ATTEMPT(result_read(a->files[i], &files[i]));
  ATTEMPT(plan_make(a, files[0], &plan));
  ATTEMPT(command_find_surfaces(a->n, files, progress));
  settings = command_settings(NULL, a->n, files, true, &ignored);
  ATTEMPT(cmp_movie_write(settings, a->n, files, &plan, progress, where));
  if (cmp_movie_is_film(a->out) && strcmp(where, a->out) != 0)
    command_warn("ffmpeg is not installed (apt install ffmpeg): the frames are in %s", where);
  fputs("movie: ", stdout);
  text_show(stdout, where, "");
  putchar('\n');
done:
  case_destroy(settings);
  for (size_t i = 0; files && i < a->n; i++) result_file_destroy(files[i]);
  free(files);
  progress_destroy(progress);
  return status;
}

int command_movie(int argc, char **argv) {
  static const struct argp_option options[] = {
      {"what", 'w', "WHAT", 0,
       "overlay: the surface of the first result over the others, whose particles are coloured by "
       "pressure (default); pressure, speed, density: of the points of each",
       0},
      {"out", 'o', "FILE", 0,
       "NAME.mp4 (default: movie.mp4), .webm or .gif, by ffmpeg; a name without a suffix is a "
       "folder for frames (PNG), which is also what you get without ffmpeg",
       0},
      {"fps", 'r', "N", 0, "frames a second, each an output (default 15)", 0},
      {"size", 's', "WxH", 0, "pixels, filled with white (default: 1280 wide)", 0},
      {"from", 'f', "T", 0, "first time, s or as in '4 sqrt(H/g)'", 0},
      {"to", 't', "T", 0, "last time", 0},
      {0}};
  static const struct argp argp = {
      .options = options,
      .parser = parse,
      .args_doc = "RESULT.h5...",
      .doc = "A film of results: a frame for every output of the first one, drawn like the "
             "pictures of the report, and a panel for each of the others.",
  };
  struct movie_arguments a = {.what = "overlay", .out = "movie.mp4", .fps = 15};
  argp_parse(&argp, argc, argv, 0, NULL, &a);
  const enum status status = movie(&a);
  return status == OK ? EXIT_FINE : command_fail(status);
}
