/* A child process that does what may crash, hang or ask for all memory. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"
#include "common/result/carry.h"

struct guard {
  const char *name[2]; /* of what it reads, for messages; see guard_blame */
  size_t size;         /* bytes of that: time and memory are allowed in proportion */
  void *data;
  enum status (*read)(void *data);                     /* in the child */
  enum status (*carry)(struct carrier *c, void *data); /* in both */
};

/* The status and message of `read`; ERR_INPUT when the child crashed or needed too much, ERR_MEMORY
 * when this process had no more, INTERRUPTED when it was told to stop. */
enum status guard_run(const struct guard *g);

/* In the child: which of the two names a crash from here on is to be put down to. */
void guard_blame(size_t which);
