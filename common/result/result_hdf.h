/* The few things that result files need of HDF5, each with our error idiom and with `units` and
 * `description` on every dataset. Errors: ERR_IO when writing, ERR_INPUT when reading. */
#pragma once
#include <hdf5.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "common/base/array.h"
#include "common/base/status.h"

/* Leaves the message followed by HDF5's own innermost reason; returns `code`, or ERR_MEMORY if that
 * was the reason. */
enum status hdf_raise(enum status code, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void hdf_quiet(void); /* HDF5 prints nothing itself; call before anything else */

/* ---- writing ---- */

/* A group that remembers the order in which its members were made. */
enum status hdf_group_create(hid_t parent, const char *name, hid_t *group);

enum status hdf_set_string(hid_t object, const char *name, const char *value); /* UTF-8 */
enum status hdf_set_ascii(hid_t object, const char *name, const char *value);  /* fixed length */
enum status hdf_set_number(hid_t object, const char *name, double value);      /* replaces */
enum status hdf_set_integers(hid_t object, const char *name, size_t n, const int64_t *values);

enum status hdf_describe(hid_t set, const char *units, const char *help);

/* Complete datasets: `type` is a native type, width 0 makes a vector and else rows of `width`. */
enum status hdf_put(hid_t group, const char *name, hid_t type, size_t n, size_t width,
                    const void *values, const char *units, const char *help);
enum status hdf_put_scalar(hid_t group, const char *name, hid_t type, const void *value,
                           const char *units, const char *help);
enum status hdf_put_string(hid_t group, const char *name, const char *value, const char *help);

/* ---- reading: nothing is trusted, nothing larger than the file can hold is allocated ---- */

/* Nothing in the file leads into another one: no external link or storage, no virtual dataset. To
 * be called before all else. */
enum status hdf_check_confined(hid_t file);

bool hdf_has(hid_t group, const char *name); /* a link that leads to an object */
/* Whether the path has links all the way, wherever the last of them leads: what a file without it
 * does not have, and one with it must have right. */
bool hdf_is_there(hid_t group, const char *path);
enum status hdf_open_group(hid_t parent, const char *name, hid_t *group);
enum status hdf_get_string(hid_t object, const char *name,
                           char **value); /* attribute; to be freed */
enum status hdf_get_number(hid_t object, const char *name, double *value);
enum status hdf_get_integer(hid_t object, const char *name, int64_t *value);

/* The rows [first, first + n) of a dataset with rows of `width` (0: a vector) as `type`; the array
 * is the caller's to free, never NULL: *array, of elements of that type. */
#define hdf_get_rows(group, name, type, width, first, n, array)                                    \
  array_lend(array, hdf_read_rows(group, name, type, width, first, n, &memory_))
/* All rows, and how many there are. */
#define hdf_get_all(group, name, type, width, n, array)                                            \
  array_lend(array, hdf_read_all(group, name, type, width, n, &memory_))
enum status hdf_read_rows(hid_t group, const char *name, hid_t type, size_t width, hsize_t first,
                          hsize_t n, void **values);
enum status hdf_read_all(hid_t group, const char *name, hid_t type, size_t width, size_t *n,
                         void **values);
enum status hdf_get_scalar(hid_t group, const char *name, hid_t type, void *value);
enum status hdf_get_text(hid_t group, const char *name, char **value); /* string dataset */

/* Names, of which hdf_list_destroy(names.n, names.name) frees the memory. ERR_MEMORY. */
struct hdf_names {
  size_t n, room;
  char **name; /* [n], owned */
};
enum status hdf_names_add(struct hdf_names *names, const char *name);

/* The names of a group's members, in the order of their creation where it is known. */
enum status hdf_list(hid_t group, size_t *n, char ***names);
void hdf_list_destroy(size_t n, char **names);
