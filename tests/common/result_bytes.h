/* A result as bytes in memory, and the seal that any bytes can be given. */
#pragma once
#include <string.h>

#include "common/result/result_seal.h"

/* Overwrites the last bytes, where a seal stands, with the right one for those before. */
static inline void bytes_seal(unsigned char *bytes, size_t size) {
  struct result_seal seal;
  size_t n = size - sizeof seal;
  uint64_t sum = 0;
  for (size_t k = 0; k * RESULT_SEAL_PAGE < n; k++) {
    size_t part = n - k * RESULT_SEAL_PAGE;
    if (part > RESULT_SEAL_PAGE) part = RESULT_SEAL_PAGE;
    sum += result_seal_page(bytes + k * RESULT_SEAL_PAGE, part, k);
  }
  seal = result_seal_make(n, sum);
  memcpy(bytes + n, &seal, sizeof seal);
}
