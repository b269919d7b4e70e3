/* Files of VTK, by its library: legacy (.vtk), XML (.vtu .vtp .vti .vts .vtr .vtm and parallel
 * ones), VTKHDF grids (.vtkhdf .hdf) and OpenFOAM's cases (.foam). Points are the columns
 * "Points:0" to "Points:2", arrays of points and cells go by their names. */
#include <dlfcn.h>
#include <math.h>
#include <string.h>

#include "import/guarded.h"
#include "import/lists.h"
#include "import/vtk_library.h"

/* The libraries take memory and time too; and much of what is read may be in other files: those of
 * a case of OpenFOAM, the parts of a parallel file. */
static size_t extra_of(const char *path) {
  const size_t n = strlen(path);
  const bool foam = (n > 5 && !strcmp(path + n - 5, ".foam")) || strstr(path, "controlDict");
  return foam ? (size_t)1 << 30 : ((size_t)64 << 20) + import_parts_size(path);
}

/* In the child, where a library may be loaded that crashes. */
static enum status find_function(const struct import_ask *ask, const char *name, void **function) {
  void *module = dlopen("libplunge-vtk.so", RTLD_NOW);
  CHECK(module, ERR_INPUT,
        "cannot read %s: this plunge was built without the VTK library; install libvtk9-dev and "
        "build it again (%s)",
        ask->path, dlerror());
  *function = dlsym(module, name);
  CHECK(*function, ERR_INPUT, "cannot read %s: libplunge-vtk.so is of another plunge", ask->path);
  return OK;
}

static enum status steps_there(const struct import_ask *ask, size_t *n, double **times) {
  char message[IMPORT_VTK_MESSAGE] = "";
  void *function;
  TRY(find_function(ask, "import_vtk_library_steps", &function));
  __typeof__(&import_vtk_library_steps) steps = (__typeof__(&import_vtk_library_steps))function;
  CHECK(!steps(ask, n, times, message), ERR_INPUT, "%s %s", ask->path, message);
  return OK;
}

static enum status read_there(const struct import_ask *ask, struct import_table *t) {
  char message[IMPORT_VTK_MESSAGE] = "";
  void *function;
  TRY(find_function(ask, "import_vtk_library_read", &function));
  __typeof__(&import_vtk_library_read) read = (__typeof__(&import_vtk_library_read))function;
  CHECK(!read(ask, t, message), ERR_INPUT, "%s %s", ask->path, message);
  return OK;
}

enum status import_vtk_steps(const struct import_ask *ask, size_t *n, double **times) {
  struct import_guarded g = {.ask = ask, .steps = steps_there, .extra = extra_of(ask->path)};
  TRY(import_guard(&g));
  *n = g.n;
  *times = g.times;
  return OK;
}

enum status import_vtk_read(const struct import_ask *ask, struct import_table *t) {
  *t = (struct import_table){.time = NAN};
  return import_guard(&(struct import_guarded){
      .ask = ask, .read = read_there, .table = t, .extra = extra_of(ask->path)});
}
