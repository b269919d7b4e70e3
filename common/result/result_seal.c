#include "common/result/result_seal.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
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

enum { ABREAST = 4 };

/* Of so many whole pages. Within a page each word waits for the one before it, pages do not. */
static uint64_t sum_abreast(const unsigned char *bytes, uint64_t number) {
  uint64_t h[ABREAST], sum = 0;
  for (size_t k = 0; k < ABREAST; k++) h[k] = (number + k + 1) * 0x9e3779b97f4a7c15u;
  for (size_t i = 0; i < RESULT_SEAL_PAGE; i += 8)
    for (size_t k = 0; k < ABREAST; k++) {
      uint64_t word;
      memcpy(&word, bytes + k * RESULT_SEAL_PAGE + i, 8);
      h[k] = (h[k] ^ word) * 0xff51afd7ed558ccdu;
      h[k] ^= h[k] >> 32;
    }
  for (size_t k = 0; k < ABREAST; k++) sum += h[k];
  return sum;
}

/* The checksum of the first `size` bytes; less than all of them when there are no more. */
static uint64_t sum_pages(FILE *f, uint64_t size) {
  enum { AT_ONCE = 256 };
  static const size_t most = (size_t)AT_ONCE * RESULT_SEAL_PAGE;
  unsigned char *bytes = malloc(most);
  uint64_t sum = 0;
  for (uint64_t at = 0, number = 0; bytes && at < size;) {
    const size_t wanted = size - at < most ? (size_t)(size - at) : most;
    const size_t n = fread(bytes, 1, wanted, f);
    size_t i = 0;
    for (; n - i >= ABREAST * RESULT_SEAL_PAGE; i += ABREAST * RESULT_SEAL_PAGE) {
      sum += sum_abreast(bytes + i, number);
      number += ABREAST;
    }
    for (; i < n; i += RESULT_SEAL_PAGE)
      sum += result_seal_page(bytes + i, n - i < RESULT_SEAL_PAGE ? n - i : RESULT_SEAL_PAGE,
                              number++);
    if (n < wanted) break;
    at += n;
  }
  free(bytes);
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
  setvbuf(f, NULL, _IONBF, 0);
  rewind(f);
  struct result_seal right = result_seal_make(size - sizeof seal, sum_pages(f, size - sizeof seal));
  *out = memcmp(&right, &seal, sizeof seal) ? RESULT_SEAL_BROKEN : RESULT_SEAL_GOOD;
  fclose(f);
  return OK;
}
