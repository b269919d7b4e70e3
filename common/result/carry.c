#include "common/result/carry.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static enum status broken(void) {
  return status_raise(ERR_INPUT, "the process that read it has died");
}

enum status carry_end(struct carrier *c) {
  while (c->begin < c->end) {
    ssize_t put = write(c->pipe, c->buffer + c->begin, c->end - c->begin);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return broken();
    c->begin += (size_t)put;
  }
  c->begin = c->end = 0;
  return OK;
}

static enum status fill(struct carrier *c) {
  ssize_t got;
  do got = read(c->pipe, c->buffer, sizeof c->buffer);
  while (got < 0 && errno == EINTR);
  if (got <= 0) return broken();
  c->begin = 0;
  c->end = (size_t)got;
  return OK;
}

enum status carry_bytes(struct carrier *c, void *bytes, size_t n) {
  unsigned char *at = bytes;
  while (n) {
    size_t limit = c->sending ? sizeof c->buffer : c->end;
    size_t *from = c->sending ? &c->end : &c->begin;
    if (*from == limit) {
      TRY(c->sending ? carry_end(c) : fill(c));
      continue;
    }
    size_t part = limit - *from < n ? limit - *from : n;
    if (c->sending)
      memcpy(c->buffer + *from, at, part);
    else
      memcpy(at, c->buffer + *from, part);
    *from += part;
    at += part;
    n -= part;
  }
  return OK;
}

enum status carry_number(struct carrier *c, size_t *n) {
  return carry_bytes(c, n, sizeof *n);
}

/* Zeros for n elements and one more, within what may be received. */
static enum status receive_room(struct carrier *c, size_t n, size_t size, void **array) {
  *array = NULL;
  if (n > c->room / size) return broken();
  c->room -= n * size;
  *array = array_memory(NULL, n + 1, size, "elements from another process");
  return *array ? OK : ERR_MEMORY;
}

enum status carry_text(struct carrier *c, char **text) {
  size_t n = c->sending && *text ? strlen(*text) : SIZE_MAX;
  TRY(carry_number(c, &n));
  if (n == SIZE_MAX) {
    *text = NULL;
    return OK;
  }
  if (!c->sending) TRY(array_lend(text, receive_room(c, n, 1, &memory_)));
  return carry_bytes(c, *text, n);
}

enum status carry_elements(struct carrier *c, size_t *n, void **array, size_t size) {
  TRY(carry_number(c, n));
  if (!c->sending) TRY(receive_room(c, *n, size, array));
  return carry_bytes(c, *array, *n * size);
}

enum status carry_each_element(struct carrier *c, size_t *n, void **array, size_t size,
                               enum status (*carry)(struct carrier *c, void *element)) {
  size_t count = *n;
  TRY(carry_number(c, &count));
  if (!c->sending) {
    *n = 0;
    TRY(receive_room(c, count, size, array));
    *n = count;
  }
  for (size_t i = 0; i < count; i++) TRY(carry(c, (char *)*array + i * size));
  return OK;
}
