#include "fuzz/result_edit.h"

#include <hdf5.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/result/result_guard.h"
#include "common/result/result_hdf.h"
#include "common/result/result_seal.h"

uint32_t draw(uint32_t *state, uint32_t n) {
  *state = *state * 1664525u + 1013904223u;
  return (uint32_t)(((uint64_t)*state * n) >> 32);
}

static uint32_t rotate(uint32_t x, int k) {
  return x << k | x >> (32 - k);
}

/* The checksum of HDF5's headers: Bob Jenkins' lookup3 (public domain, 2006), byte by byte. */
static uint32_t lookup3(const unsigned char *key, size_t n) {
  uint32_t a = 0xdeadbeef + (uint32_t)n, b = a, c = a;
  while (n > 0) {
    uint32_t word[3] = {0};
    size_t part = n < 12 ? n : 12;
    memcpy(word, key, part);
    a += word[0], b += word[1], c += word[2];
    if (n > 12) {
      a -= c, a ^= rotate(c, 4), c += b, b -= a, b ^= rotate(a, 6), a += c;
      c -= b, c ^= rotate(b, 8), b += a, a -= c, a ^= rotate(c, 16), c += b;
      b -= a, b ^= rotate(a, 19), a += c, c -= b, c ^= rotate(b, 4), b += a;
    } else {
      c ^= b, c -= rotate(b, 14), a ^= c, a -= rotate(c, 11), b ^= a, b -= rotate(a, 25);
      c ^= b, c -= rotate(b, 16), a ^= c, a -= rotate(c, 4), b ^= a, b -= rotate(a, 14);
      c ^= b, c -= rotate(b, 24);
    }
    key += part;
    n -= part;
  }
  return c;
}

/* ---- edits through HDF5 ---- */

static const double numbers[] = {0,     -1,      1,    NAN,          INFINITY, -INFINITY,
                                 1e300, -1e-300, 1e18, 4294967296.0, 65536,    3e9,
                                 255,   0.5,     7,    -9e18};

enum { MOST_OBJECTS = 256 };
static uint32_t n_objects;
static struct object {
  char name[64];
  bool set;
} objects[MOST_OBJECTS];

static herr_t add_object(hid_t root, const char *name, const H5O_info_t *info, void *data) {
  (void)root, (void)data;
  struct object *o = &objects[n_objects++];
  snprintf(o->name, sizeof o->name, "%s", name);
  o->set = info->type == H5O_TYPE_DATASET;
  return n_objects == MOST_OBJECTS;
}

/* In memory from first to last. */
static hid_t open_image(uint8_t *data, size_t size) {
  hid_t fapl = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_core(fapl, 1 << 16, false);
  H5Pset_fclose_degree(fapl, H5F_CLOSE_STRONG); /* closes what the edits left open */
  H5Pset_file_image(fapl, data, size - sizeof(struct result_seal));
  hid_t file = H5Fopen("fuzz", H5F_ACC_RDWR, fapl);
  H5Pclose(fapl);
  return file;
}

void edit_learn(uint8_t *data, size_t size) {
  hid_t file = open_image(data, size);
  H5Ovisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, add_object, NULL);
  H5Fclose(file);
  if (!n_objects) abort();
}

static void edit_set(hid_t file, const char *name, uint32_t *state) {
  hid_t set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
  hsize_t dims[2] = {1, 1}, start[2] = {0, 0}, one[2] = {1, 1};
  int rank = H5Sget_simple_extent_ndims(space);
  double value = numbers[draw(state, sizeof numbers / sizeof *numbers)];
  if (rank > 0 && rank <= 2) H5Sget_simple_extent_dims(space, dims, NULL);
  if (rank > 0 && draw(state, 3) == 0) {
    hsize_t lengths[] = {0, 1, dims[0] - 1, dims[0] + 1, dims[0] * 2, 1u << 20, (hsize_t)1 << 50};
    dims[0] = lengths[draw(state, 7)];
    H5Dset_extent(set, dims);
  } else if (rank > 0 && dims[0] && H5Tget_class(H5Dget_type(set)) != H5T_STRING) {
    start[0] = draw(state, (uint32_t)dims[0]);
    if (rank == 2 && dims[1]) start[1] = draw(state, (uint32_t)dims[1]);
    hid_t memory = H5Screate_simple(1, one, NULL);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start, NULL, one, NULL);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, &value);
  } else if (rank == 0 && H5Tget_class(H5Dget_type(set)) != H5T_STRING) {
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value);
  }
}

/* The same value in each element; words of a fixed length are cut to it. */
static void fill_attribute(hid_t attribute, uint32_t *state) {
  static const char *const words[] = {"", "\n", "\x1b[2J", "plunge", "a/b", "%s%n", "<script>"};
  const char *word = words[draw(state, 7)];
  double number = numbers[draw(state, sizeof numbers / sizeof *numbers)];
  hid_t type = H5Aget_type(attribute), space = H5Aget_space(attribute);
  bool text = H5Tget_class(type) == H5T_STRING, fixed = text && H5Tis_variable_str(type) <= 0;
  size_t size = fixed ? H5Tget_size(type) : text ? sizeof word : sizeof number;
  hssize_t points = H5Sget_simple_extent_npoints(space);
  size_t n = points > 0 ? (size_t)points : 0;
  const void *from = fixed ? word : text ? (const void *)&word : &number;
  size_t part = fixed && strlen(word) < size ? strlen(word) : size;
  unsigned char *values = calloc(n + 1, size);
  for (size_t i = 0; i < n; i++) memcpy(values + i * size, from, part);
  H5Awrite(attribute, text ? type : H5T_NATIVE_DOUBLE, values);
}

/* An attribute of the other kind in the place of one. */
static hid_t replace_attribute(hid_t object, const char *name, bool text) {
  hid_t type = H5T_NATIVE_DOUBLE, space = H5Screate(H5S_SCALAR);
  if (text) {
    type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
  }
  H5Adelete(object, name);
  return H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
}

static void edit_attribute(hid_t object, uint32_t *state) {
  H5O_info_t info;
  if (H5Oget_info(object, &info) < 0 || !info.num_attrs) return;
  hid_t attribute = H5Aopen_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_NATIVE,
                                   draw(state, (uint32_t)info.num_attrs), H5P_DEFAULT, H5P_DEFAULT);
  char name[64] = "";
  H5Aget_name(attribute, sizeof name, name);
  bool text = H5Tget_class(H5Aget_type(attribute)) == H5T_STRING;
  uint32_t way = draw(state, 3);
  if (way < 2) H5Aclose(attribute);
  if (way == 0)
    H5Adelete(object, name);
  else
    fill_attribute(way == 1 ? replace_attribute(object, name, !text) : attribute, state);
}

static void edit_links(hid_t file, const char *name, uint32_t *state) {
  static const char *const others[] = {"/",         "case",   "walls/points", "surface",
                                       "/nowhere",  "VTKHDF", "events",       "series/energy/time",
                                       "statistics"};
  const char *other = others[draw(state, 9)];
  uint32_t way = draw(state, 4);
  H5Ldelete(file, name, H5P_DEFAULT);
  if (way == 1) H5Lcreate_soft(other, file, name, H5P_DEFAULT, H5P_DEFAULT);
  if (way == 2) H5Lcreate_hard(file, other, file, name, H5P_DEFAULT, H5P_DEFAULT);
  if (way == 3) H5Lcreate_external("/etc/passwd", other, file, name, H5P_DEFAULT, H5P_DEFAULT);
}

static void edit_once(hid_t file, uint32_t *state) {
  const struct object *o = &objects[draw(state, n_objects)];
  uint32_t way = draw(state, 8);
  if (way == 0 && strcmp(o->name, ".")) {
    edit_links(file, o->name, state);
  } else if (way < 4 || !o->set) {
    hid_t object = H5Oopen(file, o->name, H5P_DEFAULT);
    edit_attribute(object, state);
  } else {
    edit_set(file, o->name, state);
  }
}

struct edit {
  uint8_t *data; /* of the file; what comes of it is from malloc, without a seal */
  size_t size;
  uint32_t state;
};

/* The checksum of the superblock: in an image, HDF5 clears a flag of it and leaves the sum as it
 * was. */
static void mend_superblock(uint8_t *data) {
  enum { SUM_AT = 44 }; /* version 2, addresses of 8 bytes */
  uint32_t sum = lookup3(data, SUM_AT);
  memcpy(data + SUM_AT, &sum, sizeof sum);
}

static enum status edit_file(void *data) {
  struct edit *e = data;
  hdf_quiet();
  hid_t file = open_image(e->data, e->size);
  for (uint32_t k = 1 + draw(&e->state, 4); file >= 0 && k > 0; k--) edit_once(file, &e->state);
  H5Fflush(file, H5F_SCOPE_GLOBAL);
  ssize_t n = H5Fget_file_image(file, NULL, 0);
  e->data = n > 0 ? malloc((size_t)n) : NULL;
  if (!e->data || H5Fget_file_image(file, e->data, (size_t)n) != n) return ERR_INPUT;
  mend_superblock(e->data);
  e->size = (size_t)n;
  return OK;
}

static enum status carry_edit(struct carrier *c, void *data) {
  struct edit *e = data;
  return carry_array(c, &e->size, &e->data);
}

size_t edit_through_hdf5(uint8_t *data, size_t size, size_t most, uint32_t *state) {
  struct edit e = {data, size, draw(state, UINT32_MAX)};
  struct guard guard = {
      .name = {"edit"}, .size = size, .data = &e, .read = edit_file, .carry = carry_edit};
  size_t edited = 0;
  if (guard_run(&guard) == OK && e.size <= most - sizeof(struct result_seal)) {
    memcpy(data, e.data, e.size);
    edited = e.size + sizeof(struct result_seal);
  }
  if (e.data != data) free(e.data);
  return edited;
}

/* ---- edits of bytes ---- */

/* Where a header's checksum stands: it was right before the edit. 0: not found. */
static size_t find_checksum(const unsigned char *data, size_t size, size_t header) {
  for (size_t n = 8; n < 1024 && header + n + 4 <= size; n++) {
    uint32_t sum;
    memcpy(&sum, data + header + n, sizeof sum);
    if (sum == lookup3(data + header, n)) return header + n;
  }
  return 0;
}

static void change_byte(uint8_t *byte, uint32_t *state) {
  static const uint8_t odd[] = {0, 1, 0x7f, 0x80, 0xff, 3, 8};
  *byte = draw(state, 2) ? (uint8_t)(*byte ^ 1u << draw(state, 8)) : odd[draw(state, 7)];
}

/* Changes a byte or two of a header that begins with a signature, and its checksum. */
static void edit_header(uint8_t *data, size_t size, uint32_t *state) {
  static const char *const signatures[] = {"OHDR", "OCHK", "FRHP", "BTHD", "BTLF", "FHDB", "BTIN"};
  const char *signature = signatures[draw(state, 7)];
  uint8_t *at = data, *chosen = NULL;
  for (uint32_t left = draw(state, 40); (at = memmem(at, size - (size_t)(at - data), signature, 4));
       at++) {
    chosen = at;
    if (!left--) break;
  }
  if (!chosen) return;
  size_t header = (size_t)(chosen - data), sum_at = find_checksum(data, size, header);
  if (!sum_at) return;
  for (uint32_t k = 1 + draw(state, 2); k > 0; k--)
    change_byte(data + header + 4 + draw(state, (uint32_t)(sum_at - header - 4)), state);
  uint32_t sum = lookup3(data + header, sum_at - header);
  memcpy(data + sum_at, &sum, sizeof sum);
}

void edit_bytes(uint8_t *data, size_t size, uint32_t *state) {
  size -= sizeof(struct result_seal);
  for (uint32_t k = 1 + draw(state, 3); k > 0; k--) {
    if (draw(state, 3))
      edit_header(data, size, state);
    else
      change_byte(data + draw(state, (uint32_t)size), state);
  }
}
