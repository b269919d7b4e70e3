#include "common/result/result_seal.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char seal_magic[8] = "plunge\r\n";

/* Every step is a bijection of the state, so a change within one word of the input always shows. */
uint64_t result_seal_page(const unsigned char *bytes, size_t n, uint64_t number) {
  uint64_t h = (number + 1) * 0x9e3779b97f4a7c15u;
  for (size_t i = 0; i < n; i += 8) {
    uint64_t word = 0;
    memcpy(&word, bytes + i, n - i < 8 ? n - i : 8);
    h = (h ^ word) * 0xff51afd7ed558ccdu;
    h ^= h >> 32;
  }
  return h;
}

struct result_seal result_seal_make(uint64_t size, uint64_t sum) {
  struct result_seal seal = {.size = size, .sum = sum};
  memcpy(seal.magic, seal_magic, sizeof seal.magic);
  seal.self = result_seal_page((const unsigned char *)&seal, offsetof(struct result_seal, self), 0);
  return seal;
}

/* The checksum of the first `size` bytes; less than all of them when there are no more. */
static uint64_t sum_pages(FILE *f, uint64_t size) {
  unsigned char page[RESULT_SEAL_PAGE];
  uint64_t sum = 0;
  for (uint64_t k = 0; k * RESULT_SEAL_PAGE < size; k++) {
    size_t n = size - k * RESULT_SEAL_PAGE < RESULT_SEAL_PAGE
                   ? (size_t)(size - k * RESULT_SEAL_PAGE)
                   : RESULT_SEAL_PAGE;
    if (fread(page, 1, n, f) != n) break;
    sum += result_seal_page(page, n, k);
  }
  return sum;
}

enum status result_seal_check(const char *path, int fd, uint64_t size,
                              enum result_seal_state *out) {
  struct result_seal seal;
  *out = RESULT_SEAL_NONE;
  if (size < sizeof seal ||
      pread(fd, &seal, sizeof seal, (off_t)(size - sizeof seal)) != sizeof seal ||
      memcmp(seal.magic, seal_magic, sizeof seal_magic))
    return OK;
  int own = fcntl(fd, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  FILE *f = own < 0 ? NULL : fdopen(own, "rb");
  if (own >= 0 && !f) close(own);
  CHECK(f, ERR_INPUT, "cannot read %s: %s", path, strerror(errno));
  setvbuf(f, NULL, _IOFBF, 64 * RESULT_SEAL_PAGE);
  rewind(f);
  struct result_seal right = result_seal_make(size - sizeof seal, sum_pages(f, size - sizeof seal));
  *out = memcmp(&right, &seal, sizeof seal) ? RESULT_SEAL_BROKEN : RESULT_SEAL_GOOD;
  fclose(f);
  return OK;
}
