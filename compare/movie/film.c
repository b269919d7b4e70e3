#include "compare/movie/film.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>

#include "compare/child.h"

enum { LIMIT = 3600 }; /* s that ffmpeg gets */

/* Players want 4:2:0, hence even sides; a GIF has colours of its own. */
static const struct cmp_film films[] = {
    {".mp4",
     true,
     "",
     {"-c:v", "libx264", "-preset", "medium", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags",
      "+faststart"}},
    {".webm",
     true,
     "",
     {"-c:v", "libvpx-vp9", "-crf", "28", "-b:v", "0", "-row-mt", "1", "-pix_fmt", "yuv420p"}},
    {".gif",
     false,
     ",split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=none",
     {"-loop", "0"}}};

const struct cmp_film *cmp_film_of(const char *path) {
  const char *dot = strrchr(path, '.');
  for (size_t k = 0; dot && dot != path && dot[-1] != '/' && k < sizeof films / sizeof *films; k++)
    if (!strcmp(dot, films[k].suffix)) return &films[k];
  return NULL;
}

static void filter_write(const struct cmp_film *film, int width, int height, char *out,
                         size_t room) {
  if (width)
    snprintf(out, room, "pad=%d:%d:(ow-iw)/2:(oh-ih)/2:white%s", width, height, film->filter);
  else
    snprintf(out, room, "pad=%s:0:0:white%s", film->even ? "ceil(iw/2)*2:ceil(ih/2)*2" : "iw:ih",
             film->filter);
}

enum status cmp_film_encode(const struct cmp_film *film, const char *dir, double fps, int width,
                            int height) {
  static const char log[] = "ffmpeg.log";
  char rate[32], filter[256], name[32];
  snprintf(rate, sizeof rate, "%.6g", fps);
  snprintf(name, sizeof name, "movie%s", film->suffix);
  filter_write(film, width, height, filter, sizeof filter);
  const char *word[40] = {"ffmpeg",         "-nostdin",   "-y",  "-loglevel",
                          "error",          "-framerate", rate,  "-i",
                          "frame-%05d.png", "-vf",        filter};
  size_t n = 11;
  for (size_t k = 0; film->options[k]; k++) word[n++] = film->options[k];
  word[n] = name;
  pid_t pid;
  int outcome;
  char why[160];
  TRY(cmp_child_start(dir, log, word, &pid));
  enum status status = cmp_child_wait(&pid, LIMIT, &outcome);
  if (status == ERR_IO) return status_context(status, "ffmpeg: ");
  if (status != OK) return status;
  if (WIFEXITED(outcome) && WEXITSTATUS(outcome) == 0) return OK;
  cmp_child_complaint(dir, log, "", why, sizeof why);
  CHECK(WIFEXITED(outcome), ERR_IO, "ffmpeg was stopped (%s)", strsignal(WTERMSIG(outcome)));
  return status_raise(ERR_IO, "ffmpeg could not write the film: %s", why);
}
