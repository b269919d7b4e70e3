/* One error idiom for the whole program: a function that can fail returns `enum status`, and the
 * first failure on a thread leaves one message that says what was found and what to do. */
#pragma once

enum status {
  OK = 0,
  ERR_USAGE,    /* the command line asks for something impossible */
  ERR_INPUT,    /* a file that was read is missing, damaged or wrong */
  ERR_IO,       /* a file could not be written */
  ERR_MEMORY,   /* an allocation failed */
  ERR_SOLVER,   /* a linear solve or a time integration gave up */
  ERR_DIVERGED, /* a run produced a value that is not finite */
  INTERRUPTED,  /* the user asked to stop; what exists so far is complete and readable */
};

/* Leaves the message (printf style, one line, no full stop at its end) and returns `code`. */
enum status status_raise(enum status code, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Puts a prefix such as "run antuono: " before the current message; returns `code`. */
enum status status_context(enum status code, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The message of the last failure on this thread; "" when there was none. */
const char *status_message(void);

/* The process exit code of a status: 0 fine, 2 usage or bad input, 3 the run failed. */
int status_exit_code(enum status status);

/* Returns the failure of `call` to the caller. */
#define TRY(call)                                                                                  \
  do {                                                                                             \
    enum status try_ = (call);                                                                     \
    if (try_ != OK) return try_;                                                                   \
  } while (0)

/* Where something must be released first: sets the local `status` and jumps to the label `done`. */
#define ATTEMPT(call)                                                                              \
  do {                                                                                             \
    status = (call);                                                                               \
    if (status != OK) goto done;                                                                   \
  } while (0)

#define CHECK(cond, ...)                                                                           \
  do {                                                                                             \
    if (!(cond)) return status_raise(__VA_ARGS__);                                                 \
  } while (0)
