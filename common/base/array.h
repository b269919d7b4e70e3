/* Arrays in the heap: how they are made and grow. `array` is the address of a pointer to elements,
 * whose type says their size; `what` they are is said when there is no memory for them. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"

/* How many elements an array that has room for `room` should have to hold n: twice as many when it
 * grows, so that adding one at a time costs a constant. */
size_t array_room(size_t room, size_t n);

/* n zeroed elements (at least one), in place of nothing; freed with free(). ERR_MEMORY. */
#define array_create(array, n, what)                                                               \
  ({                                                                                               \
    void *created_ = array_memory(NULL, (n), sizeof **(array), what);                              \
    *(array) = created_;                                                                           \
    created_ ? OK : ERR_MEMORY;                                                                    \
  })

/* Makes it n elements long (at least one); those that it had and has are kept, others are whatever
 * they are. ERR_MEMORY leaves it as it was. */
#define array_resize(array, n, what)                                                               \
  ({                                                                                               \
    void *resized_ = array_memory(*(array), (n), sizeof **(array), what);                          \
    if (resized_) *(array) = resized_;                                                             \
    resized_ ? OK : ERR_MEMORY;                                                                    \
  })

/* Makes sure that it has room for n elements: array_resize when it has not. *room: for how many it
 * has. */
#define array_grow(array, room, n, what)                                                           \
  ({                                                                                               \
    size_t grown_ = array_room(*(room), (n));                                                      \
    enum status grow_ = grown_ == *(room) ? OK : array_resize(array, grown_, what);                \
    if (grow_ == OK) *(room) = grown_;                                                             \
    grow_;                                                                                         \
  })

/* Lends the pointer to a call that takes a `void **`: &memory_ within it. */
#define array_lend(array, call)                                                                    \
  ({                                                                                               \
    void *memory_ = *(array);                                                                      \
    enum status lent_ = (call);                                                                    \
    *(array) = memory_;                                                                            \
    lent_;                                                                                         \
  })

/* What the above are made of: n elements of `size` bytes, zeroed when old is NULL; NULL and a
 * message when there is no memory. */
void *array_memory(void *old, size_t n, size_t size, const char *what);

/* Order of doubles, for qsort. */
int array_ascending(const void *a, const void *b);
