/* The last bytes of a result file: a checksum of all that stands before them. It tells damage, not
 * trust: anybody can put the right seal on any bytes. */
#pragma once
#include <stddef.h>
#include <stdint.h>

#include "common/base/status.h"

#define RESULT_SEAL_PAGE 4096 /* bytes that are summed together; the last page may be shorter */

struct result_seal {
  char magic[8];
  uint64_t size; /* bytes of HDF5 data before the seal */
  uint64_t sum;  /* of the page checksums, modulo 2^64 */
  uint64_t self; /* of the three above */
};

uint64_t result_seal_page(const unsigned char *bytes, size_t n, uint64_t number);
struct result_seal result_seal_make(uint64_t size, uint64_t sum);

enum result_seal_state { RESULT_SEAL_GOOD, RESULT_SEAL_NONE, RESULT_SEAL_BROKEN };

/* Reads the whole open file of `size` bytes and compares it with its seal. ERR_INPUT when it cannot
 * be read. */
enum status result_seal_check(const char *path, int fd, uint64_t size,
                              enum result_seal_state *state);
