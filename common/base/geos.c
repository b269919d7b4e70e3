#include "common/base/geos.h"

#include <stdio.h>

static void keep_message(const char *message, void *geos) {
  struct geo_geos *g = geos;
  if (!g->message[0]) snprintf(g->message, sizeof g->message, "%s", message);
}

static void ignore(const char *message, void *unused) {
  (void)message, (void)unused;
}

void geo_geos_begin(struct geo_geos *g) {
  *g = (struct geo_geos){.h = GEOS_init_r()};
  g->failed = !g->h;
  if (!g->h) return;
  GEOSContext_setErrorMessageHandler_r(g->h, keep_message, g);
  GEOSContext_setNoticeMessageHandler_r(g->h, ignore, NULL);
}

enum status geo_geos_end(struct geo_geos *g, const char *task) {
  const bool told = g->message[0];
  if (g->h) GEOS_finish_r(g->h);
  g->h = NULL;
  CHECK(!g->failed, told ? ERR_SOLVER : ERR_MEMORY, "GEOS could not %s: %s", task,
        told ? g->message : "no memory");
  return OK;
}
