#include "common/base/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static _Thread_local char message[2048];

enum status status_raise(enum status code, const char *format, ...) {
  va_list args;
  va_start(args, format);
  vsnprintf(message, sizeof message, format, args);
  va_end(args);
  return code;
}

enum status status_context(enum status code, const char *format, ...) {
  char previous[sizeof message];
  memcpy(previous, message, sizeof message);
  va_list args;
  va_start(args, format);
  int n = vsnprintf(message, sizeof message, format, args);
  va_end(args);
  if (n >= 0 && (size_t)n < sizeof message)
    snprintf(message + n, sizeof message - (size_t)n, "%s", previous);
  return code;
}

const char *status_message(void) {
  return message;
}

int status_exit_code(enum status status) {
  switch (status) {
  case OK: return 0;
  case ERR_USAGE:
  case ERR_INPUT: return 2;
  default: return 3;
  }
}
