#include "compare/page/planes.h"

#include <libdeflate.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "common/base/array.h"

enum { NO_NUMBER = 65535, LEVEL = 9 };

struct cmp_packer {
  struct libdeflate_compressor *deflate; /* owned */
};

struct cmp_packer *cmp_packer_create(void) {
  struct cmp_packer *p = calloc(1, sizeof *p);
  if (p && !(p->deflate = libdeflate_alloc_compressor(LEVEL))) {
    free(p);
    p = NULL;
  }
  return p;
}

void cmp_packer_destroy(struct cmp_packer *p) {
  if (!p) return;
  libdeflate_free_compressor(p->deflate);
  free(p);
}

char *cmp_base64(const uint8_t *from, size_t n) {
  static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  char *text = malloc(4 * ((n + 2) / 3) + 1), *to = text;
  if (!text) return NULL;
  for (size_t i = 0; i < n; i += 3) {
    const uint32_t bits = (uint32_t)from[i] << 16 | (i + 1 < n ? (uint32_t)from[i + 1] << 8 : 0) |
                          (i + 2 < n ? from[i + 2] : 0);
    *to++ = digit[bits >> 18];
    *to++ = digit[bits >> 12 & 63];
    *to++ = i + 1 < n ? digit[bits >> 6 & 63] : '=';
    *to++ = i + 2 < n ? digit[bits & 63] : '=';
  }
  *to = 0;
  return text;
}

static void range_of(size_t n, const double *v, double *lo, double *hi) {
  *lo = INFINITY;
  *hi = -INFINITY;
  for (size_t i = 0; i < n; i++) {
    if (!isfinite(v[i])) continue;
    *lo = fmin(*lo, v[i]);
    *hi = fmax(*hi, v[i]);
  }
  if (!(*lo <= *hi)) *lo = *hi = 0;
}

/* The differences with their sign in the lowest bit, so that small ones of both signs have a high
 * byte of zero. */
static void plane(size_t n, const double *v, double lo, double hi, uint16_t steps, uint8_t *to) {
  const double scale = hi > lo ? steps / (hi - lo) : 0;
  uint16_t before = 0;
  for (size_t i = 0; i < n; i++) {
    const uint16_t step = isfinite(v[i]) ? (uint16_t)lrint((v[i] - lo) * scale) : NO_NUMBER;
    const uint16_t way = (uint16_t)(step - before),
                   folded = (uint16_t)(way << 1 ^ (way & 0x8000 ? 0xffff : 0));
    before = step;
    to[i] = (uint8_t)(folded & 0xff);
    to[n + i] = (uint8_t)(folded >> 8);
  }
}

static json_t *object_of(size_t n, size_t planes, const double *lo, const double *hi,
                         const uint16_t *steps, const char *text) {
  json_t *low = json_array(), *high = json_array(), *counts = json_array();
  for (size_t k = 0; k < planes; k++) {
    json_array_append_new(low, json_real(lo[k]));
    json_array_append_new(high, json_real(hi[k]));
    json_array_append_new(counts, json_integer(steps[k]));
  }
  return json_pack("{s:I,s:o,s:o,s:o,s:s}", "n", (json_int_t)n, "lo", low, "hi", high, "steps",
                   counts, "data", text);
}

enum status cmp_planes_pack(struct cmp_packer *p, size_t n, size_t planes,
                            const double *const *column, const uint16_t *steps, json_t **out) {
  enum status status = OK;
  double lo[CMP_PLANES], hi[CMP_PLANES];
  *out = NULL;
  const size_t size = 2 * n * planes, room = libdeflate_zlib_compress_bound(p->deflate, size);
  uint8_t *raw = NULL, *packed = NULL;
  char *text = NULL;
  ATTEMPT(array_create(&raw, size + 1, "packed numbers"));
  ATTEMPT(array_create(&packed, room, "packed numbers"));
  for (size_t k = 0; k < planes; k++) {
    range_of(n, column[k], &lo[k], &hi[k]);
    plane(n, column[k], lo[k], hi[k], steps[k], raw + 2 * n * k);
  }
  const size_t used = libdeflate_zlib_compress(p->deflate, raw, size, packed, room);
  text = cmp_base64(packed, used);
  if (text) *out = object_of(n, planes, lo, hi, steps, text);
  if (!text || !*out) status = status_raise(ERR_MEMORY, "no memory for packed numbers");
done:
  free(raw);
  free(packed);
  free(text);
  return status;
}
