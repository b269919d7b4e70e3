/* What the fuzzing targets share: files that are only in memory, so that a try costs no disk. */
#pragma once
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

enum { FUZZ_FILE = 100 };
#define FUZZ_PATH "/proc/self/fd/100" /* of the file with the bytes to be tried */

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static inline int fuzz_file_create(int number) {
  int fd = memfd_create("fuzz", MFD_CLOEXEC);
  if (fd < 0 || dup2(fd, number) < 0) abort();
  close(fd);
  return number;
}

static inline void fuzz_file_fill(int fd, const void *data, size_t size) {
  if (ftruncate(fd, 0) || pwrite(fd, data, size, 0) != (ssize_t)size) abort();
}
