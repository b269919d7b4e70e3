#include "common/result/result_hdf.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/result/result_chunks.h"

void hdf_quiet(void) {
  H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
}

struct reason {
  char text[160];
  bool memory;
};

static herr_t innermost(unsigned n, const H5E_error2_t *error, void *out) {
  struct reason *reason = out;
  if (n == 0 && error->desc) snprintf(reason->text, sizeof reason->text, "%s", error->desc);
  if (error->maj_num == H5E_RESOURCE && error->min_num == H5E_NOSPACE) reason->memory = true;
  return 0;
}

enum status hdf_raise(enum status code, const char *format, ...) {
  char text[1024];
  struct reason reason = {"", false};
  va_list args;
  va_start(args, format);
  vsnprintf(text, sizeof text, format, args);
  va_end(args);
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, innermost, &reason);
  H5Eclear2(H5E_DEFAULT);
  if (reason.memory) code = ERR_MEMORY;
  return *reason.text ? status_raise(code, "%s (HDF5: %s)", text, reason.text)
                      : status_raise(code, "%s", text);
}

/* ---- writing ---- */

enum status hdf_group_create(hid_t parent, const char *name, hid_t *group) {
  hid_t plist = H5Pcreate(H5P_GROUP_CREATE);
  H5Pset_link_creation_order(plist, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  *group = H5Gcreate2(parent, name, H5P_DEFAULT, plist, H5P_DEFAULT);
  H5Pclose(plist);
  return *group >= 0 ? OK : hdf_raise(ERR_IO, "cannot write group %s", name);
}

static enum status set_attribute(hid_t object, const char *name, hid_t type, size_t n,
                                 const void *value) {
  hsize_t dims = n;
  hid_t space = n ? H5Screate_simple(1, &dims, NULL) : H5Screate(H5S_SCALAR);
  hid_t attribute = H5Aexists(object, name) > 0
                        ? H5Aopen(object, name, H5P_DEFAULT)
                        : H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  bool good = attribute >= 0 && H5Awrite(attribute, type, value) >= 0;
  if (attribute >= 0) H5Aclose(attribute);
  H5Sclose(space);
  return good ? OK : hdf_raise(ERR_IO, "cannot write attribute %s", name);
}

static hid_t text_type(void) {
  hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

enum status hdf_set_string(hid_t object, const char *name, const char *value) {
  hid_t type = text_type();
  enum status status = set_attribute(object, name, type, 0, &value);
  H5Tclose(type);
  return status;
}

enum status hdf_set_ascii(hid_t object, const char *name, const char *value) {
  hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, strlen(value));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  enum status status = set_attribute(object, name, type, 0, value);
  H5Tclose(type);
  return status;
}

enum status hdf_set_number(hid_t object, const char *name, double value) {
  return set_attribute(object, name, H5T_NATIVE_DOUBLE, 0, &value);
}

enum status hdf_set_integers(hid_t object, const char *name, size_t n, const int64_t *values) {
  return set_attribute(object, name, H5T_NATIVE_INT64, n == 1 ? 0 : n, values);
}

enum status hdf_describe(hid_t set, const char *units, const char *help) {
  TRY(hdf_set_string(set, "units", units));
  return hdf_set_string(set, "description", help);
}

static enum status put(hid_t group, const char *name, hid_t type, int rank, const hsize_t *dims,
                       const void *values, const char *units, const char *help) {
  hid_t space = rank ? H5Screate_simple(rank, dims, NULL) : H5Screate(H5S_SCALAR);
  hid_t set = H5Dcreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  bool empty = rank && dims[0] == 0;
  bool good =
      set >= 0 && (empty || H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
  enum status status =
      good ? hdf_describe(set, units, help) : hdf_raise(ERR_IO, "cannot write %s", name);
  if (set >= 0) H5Dclose(set);
  H5Sclose(space);
  return status;
}

enum status hdf_put(hid_t group, const char *name, hid_t type, size_t n, size_t width,
                    const void *values, const char *units, const char *help) {
  hsize_t dims[2] = {n, width};
  return put(group, name, type, width ? 2 : 1, dims, values, units, help);
}

enum status hdf_put_scalar(hid_t group, const char *name, hid_t type, const void *value,
                           const char *units, const char *help) {
  return put(group, name, type, 0, NULL, value, units, help);
}

enum status hdf_put_string(hid_t group, const char *name, const char *value, const char *help) {
  hid_t type = text_type();
  enum status status = put(group, name, type, 0, NULL, &value, "1", help);
  H5Tclose(type);
  return status;
}

/* ---- reading ---- */

/* Where `name` in `group` is in the file, for messages. */
static const char *full_name(hid_t group, const char *name) {
  static _Thread_local char text[512];
  ssize_t n = H5Iget_name(group, text, sizeof text / 2);
  if (n < 0 || (size_t)n >= sizeof text / 2) n = 0;
  snprintf(text + n, sizeof text - (size_t)n, "%s%s", n && text[n - 1] == '/' ? "" : "/", name);
  return text;
}

bool hdf_has(hid_t group, const char *name) {
  return H5Lexists(group, name, H5P_DEFAULT) > 0 && H5Oexists_by_name(group, name, H5P_DEFAULT) > 0;
}

bool hdf_is_there(hid_t group, const char *path) {
  char part[256];
  for (const char *end = path; *end; end++) {
    end += strcspn(end, "/");
    snprintf(part, sizeof part, "%.*s", (int)(end - path), path);
    if (H5Lexists(group, part, H5P_DEFAULT) <= 0) return false;
    if (!*end) break;
  }
  return true;
}

enum status hdf_open_group(hid_t parent, const char *name, hid_t *group) {
  *group = hdf_has(parent, name) ? H5Gopen2(parent, name, H5P_DEFAULT) : -1;
  return *group >= 0 ? OK : hdf_raise(ERR_INPUT, "it has no group %s", full_name(parent, name));
}

/* Reads one variable-length or fixed string with `read`, which fills memory of the given type. */
struct string_source {
  hid_t object; /* attribute or dataset */
  bool attribute;
};

static bool source_read(struct string_source s, hid_t type, void *to) {
  return (s.attribute ? H5Aread(s.object, type, to)
                      : H5Dread(s.object, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, to)) >= 0;
}

static enum status read_fixed_string(struct string_source s, hid_t type, char **value) {
  size_t size = H5Tget_size(type);
  CHECK(size < 65536, ERR_INPUT, "a text of it is damaged");
  *value = calloc(1, size + 1);
  CHECK(*value, ERR_MEMORY, "no memory for %zu bytes", size);
  return source_read(s, type, *value) ? OK : hdf_raise(ERR_INPUT, "a text of it cannot be read");
}

static enum status read_variable_string(struct string_source s, hid_t type, char **value) {
  char *text = NULL;
  if (!source_read(s, type, &text)) return hdf_raise(ERR_INPUT, "a text of it cannot be read");
  *value = strdup(text ? text : "");
  H5free_memory(text);
  CHECK(*value, ERR_MEMORY, "no memory for a text");
  return OK;
}

static enum status read_string(struct string_source s, char **value) {
  hid_t type = s.attribute ? H5Aget_type(s.object) : H5Dget_type(s.object);
  hid_t space = s.attribute ? H5Aget_space(s.object) : H5Dget_space(s.object);
  bool text = type >= 0 && space >= 0 && H5Tget_class(type) == H5T_STRING &&
              H5Sget_simple_extent_npoints(space) == 1;
  enum status status = !text                          ? status_raise(ERR_INPUT, "it is no text")
                       : H5Tis_variable_str(type) > 0 ? read_variable_string(s, type, value)
                                                      : read_fixed_string(s, type, value);
  if (space >= 0) H5Sclose(space);
  if (type >= 0) H5Tclose(type);
  if (status == OK) return OK;
  free(*value);
  *value = NULL;
  return status;
}

enum status hdf_get_string(hid_t object, const char *name, char **value) {
  *value = NULL;
  hid_t attribute = H5Aexists(object, name) > 0 ? H5Aopen(object, name, H5P_DEFAULT) : -1;
  enum status status =
      attribute < 0 ? ERR_INPUT : read_string((struct string_source){attribute, true}, value);
  if (attribute >= 0) H5Aclose(attribute);
  return status == ERR_INPUT ? hdf_raise(ERR_INPUT, "it has no text attribute \"%s\"", name)
                             : status;
}

static enum status get_attribute(hid_t object, const char *name, hid_t type, void *value) {
  hid_t attribute = H5Aexists(object, name) > 0 ? H5Aopen(object, name, H5P_DEFAULT) : -1;
  hid_t space = attribute >= 0 ? H5Aget_space(attribute) : -1;
  bool good = space >= 0 && H5Sget_simple_extent_npoints(space) == 1 &&
              H5Aread(attribute, type, value) >= 0;
  if (space >= 0) H5Sclose(space);
  if (attribute >= 0) H5Aclose(attribute);
  return good ? OK : hdf_raise(ERR_INPUT, "it has no numeric attribute \"%s\"", name);
}

enum status hdf_get_number(hid_t object, const char *name, double *value) {
  return get_attribute(object, name, H5T_NATIVE_DOUBLE, value);
}

enum status hdf_get_integer(hid_t object, const char *name, int64_t *value) {
  return get_attribute(object, name, H5T_NATIVE_INT64, value);
}

/* Deflate cannot shrink more than 1032 : 1, so a dataset that claims more numbers than its stored
 * bytes can hold is damaged. */
static bool plausible(hid_t set, hid_t type, const hsize_t dims[2], int rank) {
  double bytes = (double)dims[0] * (rank == 2 ? (double)dims[1] : 1) * (double)H5Tget_size(type);
  return bytes <= 1032.0 * (double)H5Dget_storage_size(set) + 65536;
}

/* A dataset that is read: what is asked of it, and how it is. */
struct table {
  hid_t group;
  const char *name;
  hid_t type;               /* in memory */
  size_t width;             /* of its rows; 0: a vector */
  hid_t set, space, stored; /* negative when they are not open */
  hsize_t dims[2];
};

static void table_close(const struct table *t) {
  if (t->stored >= 0) H5Tclose(t->stored);
  if (t->space >= 0) H5Sclose(t->space);
  if (t->set >= 0) H5Dclose(t->set);
}

/* Opens it and sees whether it is what is asked for; to be closed in any case. */
static enum status table_open(struct table *t) {
  int rank = t->width ? 2 : 1;
  t->set = hdf_has(t->group, t->name) ? H5Dopen2(t->group, t->name, H5P_DEFAULT) : -1;
  t->space = t->set >= 0 ? H5Dget_space(t->set) : -1;
  t->stored = t->set >= 0 ? H5Dget_type(t->set) : -1;
  if (t->space < 0 || t->stored < 0)
    return hdf_raise(ERR_INPUT, "it has no dataset %s", full_name(t->group, t->name));
  if (H5Sget_simple_extent_ndims(t->space) != rank ||
      H5Sget_simple_extent_dims(t->space, t->dims, NULL) < 0 ||
      (t->width && t->dims[1] != t->width))
    return hdf_raise(ERR_INPUT, "its dataset %s has the wrong shape", full_name(t->group, t->name));
  H5T_class_t has = H5Tget_class(t->stored), asked = H5Tget_class(t->type);
  bool fits = has == asked || (has == H5T_INTEGER && asked == H5T_FLOAT);
  if (!fits)
    return hdf_raise(ERR_INPUT, "its dataset %s has values of another type: %s are needed",
                     full_name(t->group, t->name), asked == H5T_INTEGER ? "integers" : "numbers");
  if (!plausible(t->set, t->stored, t->dims, rank))
    return hdf_raise(ERR_INPUT, "its dataset %s is damaged", full_name(t->group, t->name));
  return OK;
}

/* Its rows [first, first + n), in memory of the caller's. */
static enum status table_read(const struct table *t, hsize_t first, hsize_t n, void **values) {
  if (first > t->dims[0] || n > t->dims[0] - first)
    return hdf_raise(ERR_INPUT, "its dataset %s has %llu rows where %llu are needed",
                     full_name(t->group, t->name), (unsigned long long)t->dims[0],
                     (unsigned long long)(first + n));
  hsize_t start[2] = {first, 0}, count[2] = {n, t->width};
  size_t bytes = (size_t)n * (t->width ? t->width : 1) * H5Tget_size(t->type);
  *values = malloc(bytes ? bytes : 1);
  CHECK(*values, ERR_MEMORY, "no memory for %zu bytes", bytes);
  if (n && H5Tequal(t->type, H5T_NATIVE_DOUBLE) > 0 &&
      hdf_chunks_read(t->set, t->width, first, n, *values))
    return OK;
  hid_t memory = H5Screate_simple(t->width ? 2 : 1, count, NULL);
  bool good = !n || (H5Sselect_hyperslab(t->space, H5S_SELECT_SET, start, NULL, count, NULL) >= 0 &&
                     H5Dread(t->set, t->type, memory, t->space, H5P_DEFAULT, *values) >= 0);
  if (memory >= 0) H5Sclose(memory);
  if (good) return OK;
  free(*values);
  *values = NULL;
  return hdf_raise(ERR_INPUT, "its dataset %s cannot be read", full_name(t->group, t->name));
}

enum status hdf_read_rows(hid_t group, const char *name, hid_t type, size_t width, hsize_t first,
                          hsize_t n, void **values) {
  struct table t = {.group = group, .name = name, .type = type, .width = width};
  *values = NULL;
  enum status status = table_open(&t);
  if (status == OK) status = table_read(&t, first, n, values);
  table_close(&t);
  return status;
}

enum status hdf_read_all(hid_t group, const char *name, hid_t type, size_t width, size_t *n,
                         void **values) {
  struct table t = {.group = group, .name = name, .type = type, .width = width};
  *values = NULL;
  enum status status = table_open(&t);
  if (status == OK) status = table_read(&t, 0, t.dims[0], values);
  if (status == OK) *n = (size_t)t.dims[0];
  table_close(&t);
  return status;
}

enum status hdf_get_scalar(hid_t group, const char *name, hid_t type, void *value) {
  hid_t set = hdf_has(group, name) ? H5Dopen2(group, name, H5P_DEFAULT) : -1;
  hid_t space = set >= 0 ? H5Dget_space(set) : -1;
  bool good = space >= 0 && H5Sget_simple_extent_npoints(space) == 1 &&
              H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value) >= 0;
  if (space >= 0) H5Sclose(space);
  if (set >= 0) H5Dclose(set);
  return good ? OK : hdf_raise(ERR_INPUT, "it has no number %s", full_name(group, name));
}

enum status hdf_get_text(hid_t group, const char *name, char **value) {
  *value = NULL;
  hid_t set = hdf_has(group, name) ? H5Dopen2(group, name, H5P_DEFAULT) : -1;
  enum status status = set < 0 ? ERR_INPUT : read_string((struct string_source){set, false}, value);
  if (set >= 0) H5Dclose(set);
  return status == ERR_INPUT ? hdf_raise(ERR_INPUT, "it has no text %s", full_name(group, name))
                             : status;
}

/* What is wrong with a dataset, or NULL. */
static const char *leads_away(hid_t set) {
  hid_t plist = H5Dget_create_plist(set);
  const char *what = NULL;
  if (plist < 0)
    what = "damaged";
  else if (H5Pget_external_count(plist) > 0)
    what = "kept in another file, which is not followed";
  else if (H5Pget_layout(plist) == H5D_VIRTUAL)
    what = "made of other datasets, which are not followed";
  if (plist >= 0) H5Pclose(plist);
  return what;
}

static herr_t check_link(hid_t root, const char *name, const H5L_info_t *info, void *data) {
  enum status *status = data;
  const char *what = NULL;
  if (info->type == H5L_TYPE_EXTERNAL || info->type >= H5L_TYPE_UD_MIN)
    what = "a link into another file, which is not followed";
  if (info->type == H5L_TYPE_HARD) {
    hid_t object = H5Oopen(root, name, H5P_DEFAULT);
    if (object >= 0 && H5Iget_type(object) == H5I_DATASET) what = leads_away(object);
    if (object >= 0) H5Oclose(object);
  }
  if (what) *status = status_raise(ERR_INPUT, "its /%s is %s", name, what);
  return what != NULL;
}

enum status hdf_check_confined(hid_t file) {
  enum status status = OK;
  if (H5Lvisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, check_link, &status) < 0)
    return hdf_raise(ERR_INPUT, "its groups cannot be listed");
  H5Eclear2(H5E_DEFAULT);
  return status;
}

enum status hdf_names_add(struct hdf_names *names, const char *name) {
  TRY(array_grow(&names->name, &names->room, names->n + 1, "names in a result"));
  names->name[names->n] = strdup(name);
  CHECK(names->name[names->n], ERR_MEMORY, "no memory for a name in a result");
  names->n++;
  return OK;
}

static herr_t add_name(hid_t group, const char *name, const H5L_info_t *info, void *data) {
  (void)group, (void)info;
  return hdf_names_add(data, name) == OK ? 0 : -1;
}

enum status hdf_list(hid_t group, size_t *n, char ***names) {
  struct hdf_names found = {0};
  hsize_t at = 0;
  if (H5Literate(group, H5_INDEX_CRT_ORDER, H5_ITER_INC, &at, add_name, &found) < 0) {
    hdf_list_destroy(found.n, found.name);
    found = (struct hdf_names){0};
    H5Eclear2(H5E_DEFAULT);
    at = 0;
    if (H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, &at, add_name, &found) < 0) {
      hdf_list_destroy(found.n, found.name);
      return hdf_raise(ERR_INPUT, "a group of it cannot be listed");
    }
  }
  *n = found.n;
  *names = found.name;
  return OK;
}

void hdf_list_destroy(size_t n, char **names) {
  for (size_t i = 0; i < n; i++) free(names[i]);
  free(names);
}
