/* The sections of a sidecar that name files: profiles, grid, particles, series. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "import/reader.h"

/* ---- the tables ---- */

struct files_section {
  char *file;
  int files, columns, at;
};
static const struct param format_rows[] = {
    {.key = "format",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct import_section, format),
     .choices = import_format_names,
     .help = "format of the files",
     .helps = import_format_helps},
    TEXT(struct import_section, time_after, 64, "",
         "text that the time of a file follows in its comments (csv), or the name of what holds it "
         "(hdf5: an attribute or a dataset; npz: an array; vtk: field data)"),
    {.key = "separator",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct import_section, separator),
     .choices = (const char *const[]){"comma", "semicolon", "tab", "blanks", NULL},
     .value = "comma",
     .help = "between the fields of a line of csv"},
};
static const struct param files_rows[] = {
    TEXT(struct files_section, file, 1000, "", "one file, relative to the sidecar; or files"),
    NODE(struct files_section, files, "", "a list of mappings with file, time"),
};
static const struct param columns_rows[] = {
    NODE(struct files_section, columns, NULL,
         "a mapping of what is read to names of columns in the files"),
};
static const struct param only_rows[] = {
    REAL(struct import_section, is, QTY_NUMBER, 0, 0, "0",
         "value of the column `only` where a particle is water"),
    REAL(
        struct import_section, gap, QTY_LENGTH, 0, 1e6, "0",
        "how far from the walls the program's water ends; beside them particles are half a spacing "
        "more away"),
};
static const char *const axes[] = {"x", "y", "z", NULL};
static const struct param grid_rows[] = {
    {.key = "along",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct import_section, along),
     .choices = axes,
     .value = "x",
     .help = "axis of the files that goes along the tank"},
    {.key = "up",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct import_section, up),
     .choices = axes,
     .help = "axis of the files that goes upwards"},
    REAL(struct import_section, slice, QTY_LENGTH, -1e6, 1e6, "",
         "place of the plane along the third axis, before `origin`; default: the middle"),
    REAL(struct import_section, level, QTY_NUMBER, 0, 0, "0.5", "value of the contour"),
    {.key = "water",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct import_section, water),
     .choices = (const char *const[]){"above", "below", NULL},
     .value = "above",
     .help = "where the field is above or below the level"},
};

struct item_section {
  char *file;
  double time;
};
static const struct param item_rows[] = {
    TEXT(struct item_section, file, 1000, NULL, "relative to the sidecar"),
    REAL(struct item_section, time, QTY_TIME, -1e9, 1e9, "",
         "time of all that is in it, before time_offset; not needed where the file has it"),
};

static const struct param kind_rows[] = {
    {.key = "kind",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct import_section, kind),
     .choices = (const char *const[]){"energy", "probe", "gauge", "run", NULL},
     .help = "what the series is of"},
};
static const struct param energy_rows[] = {
    REAL(struct import_section, rest, QTY_NUMBER, 0, 0, "",
         "potential energy of the same water at rest, in units.energy; a case has it"),
};
static const struct param probe_rows[] = {
    TEXT(struct import_section, name, 64, NULL, "name of the probe"),
    REAL(struct import_section, size, QTY_LENGTH, 0, 1e6, "0",
         "length along the wall over which it averages"),
};
static const struct param place_rows[] = {
    NODE(struct files_section, at, NULL, "a point [x, y] on a wall"),
};
static const struct param gauge_rows[] = {
    TEXT(struct import_section, name, 64, NULL, "name of the gauge"),
    REAL(struct import_section, x, QTY_LENGTH, -1e6, 1e6, NULL, "position of the vertical wire"),
};

/* Which columns a section has: those it must have before the stroke. */
struct roles {
  const char *must, *may;
};
static const struct roles roles_of_profiles = {"x y", "time piece"}, roles_of_grid = {"field", ""},
                          roles_of_particles = {"x y",
                                                "time u v pressure density mass volume only"},
                          roles_of_series[] = {
                              [IMPORT_ENERGY] = {"time kinetic potential", "internal removed"},
                              [IMPORT_PROBE] = {"time pressure", ""},
                              [IMPORT_GAUGE] = {"time elevation", ""},
                              [IMPORT_RUN] = {"time volume", "evaluations wall_time"},
};

#define TABLE(name, rows)                                                                          \
  { name, rows, ROWS(rows) }
const struct case_table import_section_tables[] = {
    TABLE("profiles, grid, particles and each of series", format_rows),
    TABLE("the same: one of", files_rows),
    TABLE("the same", columns_rows),
    TABLE("files (a list)", item_rows),
    TABLE("grid", grid_rows),
    TABLE("particles", only_rows),
    TABLE("series (a list)", kind_rows),
    TABLE("series of kind energy", energy_rows),
    TABLE("series of kind probe", probe_rows),
    TABLE("the same: its place", place_rows),
    TABLE("series of kind gauge", gauge_rows),
    {0},
};

/* ---- reading ---- */

void import_complain(struct import_reader *r, int node, const char *path, const char *found,
                     const char *allowed, const char *todo) {
  case_doc_problem(&r->d.doc, case_doc_line(&r->d.doc, node), path, found, allowed, todo);
}

enum status import_join_path(const struct import_sidecar *s, const char *file, char **out) {
  const char *slash = strrchr(s->path, '/');
  const int n = asprintf(out, "%.*s%s", *file == '/' || !slash ? 0 : (int)(slash - s->path + 1),
                         s->path, file);
  CHECK(n >= 0, ERR_MEMORY, "no memory for a file name");
  return OK;
}

static bool has_word(const char *words, const char *word) {
  const size_t n = strlen(word);
  for (const char *at = words; (at = strstr(at, word)); at += n)
    if ((at == words || at[-1] == ' ') && (!at[n] || at[n] == ' ')) return true;
  return false;
}

/* Rows for the columns of a section. */
static size_t list_roles(const struct roles *roles, struct param rows[IMPORT_N_ROLES]) {
  static const char *const helps[] = {
#define X(name, unit, help) help,
      IMPORT_ROLES(X)
#undef X
  };
  size_t n = 0;
  for (size_t k = 0; k < IMPORT_N_ROLES; k++) {
    const bool must = has_word(roles->must, import_roles[k]);
    if (!must && !has_word(roles->may, import_roles[k])) continue;
    rows[n++] = (struct param){.key = import_roles[k],
                               .type = PARAM_TEXT,
                               .offset = k * sizeof(char *),
                               .max = IMPORT_LONGEST,
                               .value = must ? NULL : "",
                               .help = helps[k]};
  }
  return n;
}

/* A file, or those that a file of names and times stands for. */
static enum status add_file(struct import_reader *r, int node, const char *path, const char *file,
                            double time, struct import_section *section) {
  struct import_item item = {.time = time};
  enum status status = import_join_path(r->s, file, &item.file);
  if (status == OK &&
      asprintf(&item.where, "%s:%d: %s", r->s->path, case_doc_line(&r->d.doc, node), path) < 0) {
    item.where = NULL;
    status = status_raise(ERR_MEMORY, "no memory for a file name");
  }
  if (status == OK) status = array_resize(&section->items, section->n_items + 1, "files");
  if (status == OK)
    section->items[section->n_items++] = item;
  else {
    free(item.file);
    free(item.where);
  }
  return status;
}

static enum status read_items(struct import_reader *r, int list, const char *path,
                              struct import_section *section) {
  struct case_doc *doc = &r->d.doc;
  if (!case_doc_expect_list(doc, list, path, 1, IMPORT_MOST_FILES, "mappings with file, time"))
    return OK;
  for (size_t i = 0; i < case_doc_size(doc, list); i++) {
    struct item_section s = {.time = NAN};
    char name[CASE_PATH + 32];
    const int node = case_doc_item(doc, list, i);
    snprintf(name, sizeof name, "%s[%zu]", path, i);
    enum status status = OK;
    if (case_read_section(&r->d, node, name, item_rows, ROWS(item_rows), &s))
      status = add_file(r, node, name, s.file, s.time, section);
    free(s.file);
    TRY(status);
  }
  return OK;
}

/* The unit of a role must be told. */
static void check_units(struct import_reader *r, int node, const char *path,
                        const struct import_section *section) {
  static const char *const units[] = {
#define X(name, unit, help) #unit,
      IMPORT_ROLES(X)
#undef X
  };
  for (size_t k = 0; k < IMPORT_N_ROLES && !r->units_bad; k++) {
    const bool asked = section->column[k] || (k == IMPORT_time && section->time_after);
    if (!asked || !isnan(import_unit(r->s, (enum import_role)k))) continue;
    char key[64], found[64 + CASE_PATH];
    snprintf(key, sizeof key, "units.%s", units[k]);
    snprintf(found, sizeof found, "nothing, but %s has %s", path,
             section->column[k] ? import_roles[k] : "time_after");
    import_complain(r, r->top.units ? r->top.units : node, key, found, "the unit of those numbers",
                    "add this key");
  }
}

static enum status read_files(struct import_reader *r, int node, const char *path,
                              const struct files_section *f, struct import_section *section) {
  char list[CASE_PATH + 8];
  if (!f->file == !f->files) {
    import_complain(r, node, path, f->file ? "both file and files" : "no file",
                    "one of file and files", f->file ? "remove one" : "add it");
    return OK;
  }
  snprintf(list, sizeof list, "%s.file%s", path, f->files ? "s" : "");
  if (f->file) return add_file(r, node, list, f->file, NAN, section);
  return read_items(r, f->files, list, section);
}

/* Times must come from somewhere, and from one place only. */
static void check_times(struct import_reader *r, int node, const char *path,
                        const struct import_section *section) {
  const bool inside = section->column[IMPORT_time] || section->time_after;
  if (section->column[IMPORT_time] && section->time_after) {
    import_complain(r, case_doc_member(&r->d.doc, node, "time_after"), path,
                    "time_after beside columns.time", "one of them", "remove one");
    return;
  }
  for (size_t i = 0; i < section->n_items; i++) {
    const bool told = !isnan(section->items[i].time);
    char found[CASE_PATH + 64];
    const bool own = import_formats[section->format].timed; /* the file may have one */
    if (told != inside || (!told && own)) continue;
    snprintf(found, sizeof found, "%s time of file %zu", told ? "more than one" : "no", i);
    import_complain(r, node, path, found,
                    "one of files[i].time, columns.time and time_after for each file",
                    told ? "remove one" : "add one");
    return;
  }
}

/* A table of the section's own. */
struct own_block {
  struct case_block block;
  bool of_files; /* it describes the files_section, not the import_section */
};

/* The parts that all sections have, and those of its own. */
static enum status read_section(struct import_reader *r, int node, const char *path,
                                const struct roles *roles, size_t n_more,
                                const struct own_block *more, struct import_section *section) {
  struct files_section f = {0};
  struct param rows[IMPORT_N_ROLES];
  struct case_block blocks[8] = {{format_rows, ROWS(format_rows), section, NULL},
                                 {files_rows, ROWS(files_rows), &f, NULL},
                                 {columns_rows, ROWS(columns_rows), &f, NULL}};
  char columns[CASE_PATH], at[CASE_PATH];
  size_t n = 3;
  for (size_t k = 0; k < n_more; k++, n++) {
    blocks[n] = more[k].block;
    blocks[n].into = more[k].of_files ? (void *)&f : section;
  }
  section->given = true;
  section->line = case_doc_line(&r->d.doc, node);
  enum status status = OK;
  const bool good = case_doc_read(&r->d.doc, node, path, section->line, n, blocks);
  snprintf(columns, sizeof columns, "%s.columns", path);
  if (f.columns &&
      case_read_section(&r->d, f.columns, columns, rows, list_roles(roles, rows), section->column))
    check_units(r, node, path, section);
  if (case_doc_is_mapping(&r->d.doc, node)) status = read_files(r, node, path, &f, section);
  snprintf(at, sizeof at, "%s.at", path);
  double p[2];
  if (f.at && case_read_point(&r->d.doc, f.at, at, p)) {
    section->x = p[0];
    section->y = p[1];
  }
  free(f.file);
  if (status == OK && good && f.columns) check_times(r, node, path, section);
  return status;
}

#define OWN(table)                                                                                 \
  { {table, ROWS(table), NULL, NULL}, false }
static const struct own_block blocks_of_particles[] = {OWN(only_rows)},
                              blocks_of_grid[] = {OWN(grid_rows)},
                              blocks_of_series[][3] = {
                                  [IMPORT_ENERGY] = {OWN(kind_rows), OWN(energy_rows)},
                                  [IMPORT_PROBE] = {OWN(kind_rows),
                                                    OWN(probe_rows),
                                                    {{place_rows, ROWS(place_rows), NULL, NULL},
                                                     true}},
                                  [IMPORT_GAUGE] = {OWN(kind_rows), OWN(gauge_rows)},
                                  [IMPORT_RUN] = {OWN(kind_rows)},
};

/* The kind decides which keys there are. */
static int kind_of(struct import_reader *r, int node) {
  const char *text = case_doc_text(&r->d.doc, case_doc_member(&r->d.doc, node, "kind"));
  for (int k = 0; text && kind_rows[0].choices[k]; k++)
    if (!strcmp(kind_rows[0].choices[k], text)) return k;
  return IMPORT_ENERGY;
}

static void check_series(struct import_reader *r, int node, const char *path, size_t i) {
  const struct import_section *one = &r->s->series[i];
  if (one->kind == IMPORT_ENERGY && isnan(one->rest) && !r->s->has_case)
    import_complain(r, node, path, "energies without their value at rest, and no case",
                    "the key rest: the potential energy of the same water at rest, in units.energy",
                    "add it");
  if (one->kind == IMPORT_PROBE && r->d.good.tank)
    case_check_probe(&r->d, &(struct case_probe){one->name, one->x, one->y, one->size}, node, path);
  if (one->kind == IMPORT_GAUGE && r->d.good.tank) case_check_gauge(&r->d, one->x, node, path);
  if (one->n_items > 1)
    import_complain(r, node, path, "more than one file", "one file", "put the rows into one");
  for (size_t k = 0; k < i; k++) {
    const struct import_section *other = &r->s->series[k];
    if (other->kind != one->kind || (one->name && other->name && strcmp(one->name, other->name)))
      continue;
    char found[128];
    snprintf(found, sizeof found, "the same series a second time (first in line %d)", other->line);
    import_complain(r, node, path, found, "each series once", "remove one, or name it otherwise");
    return;
  }
}

static enum status read_series(struct import_reader *r, int list) {
  struct case_doc *doc = &r->d.doc;
  const size_t n = case_doc_size(doc, list);
  if (!list || !case_doc_expect_list(doc, list, "series", 1, CASE_MOST_ITEMS, "series")) return OK;
  TRY(array_create(&r->s->series, n, "series"));
  for (size_t i = 0; i < n; i++) {
    struct import_section *one = &r->s->series[i];
    const int node = case_doc_item(doc, list, i), kind = kind_of(r, node);
    char path[CASE_PATH];
    case_doc_item_path(doc, "series", node, i, path);
    one->rest = NAN;
    r->s->n_series++;
    const size_t more = kind == IMPORT_PROBE ? 3 : kind == IMPORT_RUN ? 1 : 2;
    const size_t faults = doc->faults;
    TRY(read_section(r, node, path, &roles_of_series[kind], more, blocks_of_series[kind], one));
    if (doc->faults == faults) check_series(r, node, path, i);
  }
  return OK;
}

/* Whether they make sense together. */
static void check_sections(struct import_reader *r) {
  const struct import_sidecar *s = r->s;
  const int root = case_doc_root(&r->d.doc);
  if (s->profiles.given && s->grid.given)
    import_complain(r, r->top.grid, "grid", "a surface from a grid beside one from profiles",
                    "one of them", "remove one");
  if (!s->profiles.given && !s->grid.given && !s->particles.given)
    import_complain(r, root, "", "none of profiles, grid and particles",
                    "at least one of them: a result has a surface", "add one");
  if (case_doc_member(&r->d.doc, r->top.grid, "up") && s->grid.along == s->grid.up)
    import_complain(r, r->top.grid, "grid.up", "the axis that goes along the tank", "another axis",
                    "");
  if (s->grid.given && s->grid.n_items && !import_formats[s->grid.format].grids) {
    char found[96];
    snprintf(found, sizeof found, "%s, whose files have no grids",
             import_format_names[s->grid.format]);
    import_complain(r, r->top.grid, "grid.format", found, "vtk", "");
  }
  if (s->particles.column[IMPORT_only] == NULL &&
      case_doc_member(&r->d.doc, r->top.particles, "is"))
    import_complain(r, case_doc_member(&r->d.doc, r->top.particles, "is"), "particles.is",
                    "a value of no column", "only beside columns.only",
                    "name the column or remove it");
  if (!!s->particles.column[IMPORT_u] != !!s->particles.column[IMPORT_v])
    import_complain(r, r->top.particles, "particles.columns", "one of u and v", "both or none",
                    "add the other");
}

enum status import_read_sections(struct import_reader *r) {
  struct import_sidecar *s = r->s;
  s->grid.slice = NAN;
  if (r->top.profiles)
    TRY(read_section(r, r->top.profiles, "profiles", &roles_of_profiles, 0, NULL, &s->profiles));
  if (r->top.grid)
    TRY(read_section(r, r->top.grid, "grid", &roles_of_grid, 1, blocks_of_grid, &s->grid));
  if (r->top.particles)
    TRY(read_section(r, r->top.particles, "particles", &roles_of_particles, 1, blocks_of_particles,
                     &s->particles));
  TRY(read_series(r, r->top.series));
  check_sections(r);
  return OK;
}
