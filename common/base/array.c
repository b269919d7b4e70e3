#include "common/base/array.h"

#include <stdlib.h>

enum { FEWEST = 16 };

size_t array_room(size_t room, size_t n) {
  if (n <= room) return room;
  size_t twice = 2 * room > FEWEST ? 2 * room : FEWEST;
  return n > twice ? n : twice;
}

void *array_memory(void *old, size_t n, size_t size, const char *what) {
  if (n == 0) n = 1; /* never NULL for want of anything to hold */
  if (size == 0) size = 1;
  void *memory = old ? reallocarray(old, n, size) : calloc(n, size);
  if (!memory) status_raise(ERR_MEMORY, "no memory for %zu %s", n, what);
  return memory;
}

int array_ascending(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}
