/* Arrays of numpy, as numpy.savez and savez_compressed write them: a zip of one NAME.npy each
 * (numpy.lib.format, versions 1 to 3). Names are those of the arrays, "v:1" is component 1 of rows.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <zip.h>

#include "common/base/array.h"
#include "import/guarded.h"

#define MOST_BYTES ((zip_uint64_t)4 << 30) /* of one array */

struct npy {
  char *bytes; /* owned */
  size_t size;
  const char *data;     /* behind the header */
  char kind;            /* f, i, u or b */
  size_t width;         /* bytes of a number */
  size_t n, components; /* rows, numbers in each */
  bool by_column;       /* Fortran's order */
};

static enum status load(const char *path, zip_t *zip, const char *name, struct npy *a) {
  zip_stat_t about;
  zip_stat_init(&about);
  CHECK(!zip_stat(zip, name, 0, &about) && (about.valid & ZIP_STAT_SIZE), ERR_INPUT,
        "%s has no array '%s'", path, name);
  CHECK(about.size < MOST_BYTES, ERR_INPUT, "%s has an array '%s' of more than 4 GB", path, name);
  TRY(array_create(&a->bytes, about.size + 1, "an array of a file"));
  zip_file_t *file = zip_fopen(zip, name, 0);
  zip_int64_t got = file ? zip_fread(file, a->bytes, about.size) : -1;
  if (file && zip_fclose(file)) got = -1;
  CHECK(got >= 0 && (zip_uint64_t)got == about.size, ERR_INPUT, "%s is damaged at '%s'", path,
        name);
  a->size = about.size;
  return OK;
}

/* What stands behind a key of the header, a Python dictionary; "" where it does not. */
static const char *value_of(const char *header, const char *key) {
  const char *at = strstr(header, key);
  if (!at) return "";
  at += strlen(key);
  return at + strspn(at, " :");
}

static bool parse_shape(const char *s, struct npy *a) {
  size_t shape[2] = {1, 1}, n = 0;
  if (*s++ != '(') return false;
  while (*s && *s != ')') {
    char *end;
    const unsigned long long length = strtoull(s, &end, 10);
    if (end == s || n == 2 || length > (1ull << 40)) return false;
    shape[n++] = (size_t)length;
    s = end + strspn(end, ", ");
  }
  a->n = shape[0];
  a->components = shape[1];
  return *s == ')';
}

/* Of '<f8' and the like. */
static bool is_plain(const char *type) {
  return *type == '\'' && (type[1] == '<' || type[1] == '|') && type[2] &&
         strchr("fiub", type[2]) && type[3] && strchr("1248", type[3]) && type[4] == '\'' &&
         !(type[2] == 'f' && type[3] < '4');
}

/* Of a type as it is shown: a word between strokes, or a list in brackets. */
static size_t length_of(const char *type) {
  const size_t n = *type ? 1 + strcspn(type + 1, *type == '[' ? "]" : "'") : 0;
  return n && type[n] ? n + 1 : n;
}

static enum status parse(const char *path, const char *name, struct npy *a) {
  unsigned char *b = (unsigned char *)a->bytes;
  CHECK(a->size > 12 && !memcmp(b, "\x93NUMPY", 6) && b[6] >= 1 && b[6] <= 3, ERR_INPUT,
        "%s: '%s' is no array of numpy", path, name);
  const size_t begin = b[6] == 1 ? 10 : 12;
  const size_t length =
      b[6] == 1 ? (size_t)b[8] | (size_t)b[9] << 8
                : (size_t)b[8] | (size_t)b[9] << 8 | (size_t)b[10] << 16 | (size_t)b[11] << 24;
  CHECK(length <= a->size - begin, ERR_INPUT, "%s: '%s' is cut short", path, name);
  char header[1024];
  snprintf(header, sizeof header, "%.*s", (int)(length < 1023 ? length : 1023), a->bytes + begin);
  const char *type = value_of(header, "'descr'");
  CHECK(is_plain(type), ERR_INPUT,
        "%s: '%s' is not of plain numbers (%.*s); allowed: floats and integers, little-endian; "
        "objects are not read, save the arrays themselves",
        path, name, (int)length_of(type), type);
  a->kind = type[2];
  a->width = (size_t)(type[3] - '0');
  a->by_column = !strncmp(value_of(header, "'fortran_order'"), "True", 4);
  CHECK(parse_shape(value_of(header, "'shape'"), a), ERR_INPUT,
        "%s: '%s' has more than two dimensions", path, name);
  a->data = a->bytes + begin + length;
  const size_t there = a->size - begin - length;
  CHECK(a->n <= there && a->components <= there + 1 &&
            (double)a->n * (double)a->components * (double)a->width == (double)there,
        ERR_INPUT, "%s: '%s' has another size than its shape says", path, name);
  return OK;
}

#define NUMBER(type)                                                                               \
  ({                                                                                               \
    type x_;                                                                                       \
    memcpy(&x_, at, sizeof x_);                                                                    \
    (double)x_;                                                                                    \
  })

static double number(const struct npy *a, size_t i) {
  const char *at = a->data + i * a->width;
  if (a->kind == 'f') return a->width == 4 ? NUMBER(float) : NUMBER(double);
  const bool sign = a->kind == 'i';
  switch (a->width) {
  case 1:
    return sign ? NUMBER(int8_t) : NUMBER(uint8_t);
  case 2:
    return sign ? NUMBER(int16_t) : NUMBER(uint16_t);
  case 4:
    return sign ? NUMBER(int32_t) : NUMBER(uint32_t);
  default:
    return sign ? NUMBER(int64_t) : NUMBER(uint64_t);
  }
}

static enum status no_array(const char *path, zip_t *zip, const char *column) {
  enum { MOST = 200 };
  char *name[MOST];
  size_t n = 0;
  for (zip_int64_t i = 0; i < zip_get_num_entries(zip, 0) && n < MOST; i++) {
    const char *entry = zip_get_name(zip, (zip_uint64_t)i, 0);
    const size_t length = entry ? strlen(entry) : 0;
    if (length > 4 && !strcmp(entry + length - 4, ".npy") && (name[n] = strndup(entry, length - 4)))
      n++;
  }
  enum status status = import_no_column(path, column, n, (const char *const *)name);
  for (size_t i = 0; i < n; i++) free(name[i]);
  return status;
}

static enum status open_array(const char *path, zip_t *zip, const char *name, struct npy *a) {
  char entry[IMPORT_LONGEST + 8];
  snprintf(entry, sizeof entry, "%s.npy", name);
  if (zip_name_locate(zip, entry, 0) < 0) return no_array(path, zip, name);
  TRY(load(path, zip, entry, a));
  return parse(path, name, a);
}

static enum status take(const struct npy *a, const char *path, const char *column, size_t n,
                        double *out) {
  char wrong[IMPORT_WRONG];
  size_t component;
  CHECK(import_pick(column, a->components, &component, wrong), ERR_INPUT, "%s %s", path, wrong);
  CHECK(a->n == n, ERR_INPUT, "%s: '%s' has %zu rows, other columns %zu", path, column, a->n, n);
  for (size_t i = 0; i < n; i++)
    out[i] = number(a, a->by_column ? component * a->n + i : i * a->components + component);
  return OK;
}

static enum status read_columns(const struct import_ask *ask, zip_t *zip, struct import_table *t) {
  bool first = true;
  for (size_t k = 0; k < IMPORT_N_ROLES; k++) {
    char name[IMPORT_LONGEST + 1];
    struct npy a = {0};
    if (!ask->names[k]) continue;
    import_array_name(ask->names[k], name);
    enum status status = open_array(ask->path, zip, name, &a);
    if (status == OK && first) status = import_table_make(t, ask->names, a.n);
    first = false;
    if (status == OK) status = take(&a, ask->path, ask->names[k], t->n, t->column[k]);
    free(a.bytes);
    TRY(status);
  }
  if (!ask->time_after) return OK;
  struct npy a = {0};
  enum status status = open_array(ask->path, zip, ask->time_after, &a);
  if (status == OK && (a.n != 1 || a.components != 1))
    status = status_raise(ERR_INPUT, "%s: '%s' is not one number", ask->path, ask->time_after);
  if (status == OK) t->time = number(&a, 0);
  free(a.bytes);
  return status;
}

static enum status read_there(const struct import_ask *ask, struct import_table *t) {
  int reason;
  zip_t *zip = zip_open(ask->path, ZIP_RDONLY, &reason);
  CHECK(zip, ERR_INPUT, "%s is no npz: it cannot be read as a zip", ask->path);
  enum status status = read_columns(ask, zip, t);
  zip_discard(zip);
  return status;
}

enum status import_npz_steps(const struct import_ask *ask, size_t *n, double **times) {
  (void)ask;
  return import_one_step(n, times);
}

enum status import_npz_read(const struct import_ask *ask, struct import_table *t) {
  *t = (struct import_table){.time = NAN};
  return import_guard(&(struct import_guarded){.ask = ask, .read = read_there, .table = t});
}
