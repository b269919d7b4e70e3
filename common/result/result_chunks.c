#include "common/result/result_chunks.h"

#include <libdeflate.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { SLACK = 65536, MOST_BYTES = 1 << 26 }; /* deflated bytes beyond the chunk's; of a chunk */

struct chunks {
  hid_t set;
  int rank;
  size_t rows, row; /* of a chunk; bytes of a row */
  struct libdeflate_decompressor *inflate;
  unsigned char *packed, *shuffled, *bytes; /* of one chunk */
};

/* Shuffled and deflated, and nothing else. */
static bool filters_fit(hid_t plist) {
  static const H5Z_filter_t wanted[] = {H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE};
  if (H5Pget_nfilters(plist) != 2) return false;
  for (unsigned k = 0; k < 2; k++) {
    unsigned flags, values[8];
    size_t n = 8;
    if (H5Pget_filter2(plist, k, &flags, &n, values, 0, NULL, NULL) != wanted[k]) return false;
  }
  return true;
}

static bool layout_fits(struct chunks *c, size_t width) {
  hid_t plist = H5Dget_create_plist(c->set), type = H5Dget_type(c->set);
  hsize_t dims[2] = {0, 1};
  c->rank = width ? 2 : 1;
  const bool good = plist >= 0 && type >= 0 && H5Tequal(type, H5T_NATIVE_DOUBLE) > 0 &&
                    H5Pget_layout(plist) == H5D_CHUNKED &&
                    H5Pget_chunk(plist, c->rank, dims) == c->rank && filters_fit(plist);
  if (type >= 0) H5Tclose(type);
  if (plist >= 0) H5Pclose(plist);
  if (!good || (width && dims[1] != width) || !dims[0]) return false;
  c->row = (width ? width : 1) * sizeof(double);
  c->rows = (size_t)dims[0];
  return dims[0] <= MOST_BYTES / c->row;
}

/* The numbers of a chunk: byte k of all of them stood together. */
static void unshuffle(const unsigned char *from, size_t numbers, unsigned char *to) {
  for (size_t i = 0; i < numbers; i++)
    for (size_t k = 0; k < sizeof(double); k++) to[i * sizeof(double) + k] = from[k * numbers + i];
}

static bool chunk_read(struct chunks *c, hsize_t number) {
  const hsize_t offset[2] = {number * c->rows, 0};
  const size_t bytes = c->rows * c->row;
  hsize_t stored = 0;
  uint32_t left_out = 0;
  size_t got = 0;
  if (H5Dget_chunk_storage_size(c->set, offset, &stored) < 0 || !stored || stored > bytes + SLACK ||
      H5Dread_chunk(c->set, H5P_DEFAULT, offset, &left_out, c->packed) < 0 || left_out)
    return false;
  if (libdeflate_zlib_decompress(c->inflate, c->packed, (size_t)stored, c->shuffled, bytes, &got) !=
          LIBDEFLATE_SUCCESS ||
      got != bytes)
    return false;
  unshuffle(c->shuffled, bytes / sizeof(double), c->bytes);
  return true;
}

static bool rows_read(struct chunks *c, hsize_t first, hsize_t n, unsigned char *values) {
  for (hsize_t at = first, end = first + n; at < end;) {
    const hsize_t number = at / c->rows, within = at % c->rows;
    const hsize_t left = c->rows - within, part = left < end - at ? left : end - at;
    if (!chunk_read(c, number)) return false;
    memcpy(values, c->bytes + within * c->row, (size_t)part * c->row);
    values += (size_t)part * c->row;
    at += part;
  }
  return true;
}

bool hdf_chunks_read(hid_t set, size_t width, hsize_t first, hsize_t n, double *values) {
  struct chunks c = {.set = set};
  if (!layout_fits(&c, width)) return false;
  const size_t bytes = c.rows * c.row;
  c.inflate = libdeflate_alloc_decompressor();
  c.packed = malloc(bytes + SLACK);
  c.shuffled = malloc(bytes);
  c.bytes = malloc(bytes);
  const bool good = c.inflate && c.packed && c.shuffled && c.bytes &&
                    rows_read(&c, first, n, (unsigned char *)values);
  if (c.inflate) libdeflate_free_decompressor(c.inflate);
  free(c.packed);
  free(c.shuffled);
  free(c.bytes);
  if (!good) H5Eclear2(H5E_DEFAULT);
  return good;
}
