/* What a child process says to its parent through a pipe. The same calls send on one side and
 * receive on the other, so one function describes both directions. The receiver trusts nothing: it
 * allocates no more than it was allowed, and bad lengths end the conversation. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

#include "common/base/array.h"
#include "common/base/status.h"

struct carrier {
  int pipe;
  bool sending;
  size_t room;       /* bytes that may still be received */
  size_t begin, end; /* of what waits in the buffer */
  unsigned char buffer[1 << 16];
};

/* Each: ERR_INPUT when the other side is gone or talks nonsense, ERR_MEMORY. */
enum status carry_bytes(struct carrier *c, void *bytes, size_t n);
enum status carry_number(struct carrier *c, size_t *n);
enum status carry_text(struct carrier *c, char **text); /* NULL stays NULL */

/* `n` elements of *array, without pointers; received ones are in new memory, never NULL. */
#define carry_array(c, n, array) array_lend(array, carry_elements(c, n, &memory_, sizeof **(array)))
enum status carry_elements(struct carrier *c, size_t *n, void **array, size_t size);

/* `n` elements of any kind, each by `carry`; received ones begin as zeros, and are counted in *n
 * before they arrive. */
#define carry_each(c, n, array, carry)                                                             \
  array_lend(array, carry_each_element(c, n, &memory_, sizeof **(array), carry))
enum status carry_each_element(struct carrier *c, size_t *n, void **array, size_t size,
                               enum status (*carry)(struct carrier *c, void *element));

enum status carry_end(struct carrier *c); /* sends what waits */
