/* Text that comes from outside: files that people write (cases, settings, experiments, tolerances),
 * which are read whole, so that none can be read for ever; and names on their way to a terminal. */
#pragma once
#include <stddef.h>
#include <stdio.h>

#include "common/status.h"

/* Reads `path`, a regular file of at most `most` bytes, or standard input when it is "-". A UTF-8
 * byte-order mark is left out; a NUL stands behind the last byte and nowhere else. ERR_INPUT with a
 * message that names what was found instead: "a directory", "more than 10 MB". `text` is the
 * caller's to free. */
enum status text_read(const char *path, size_t most, char **text, size_t *n);

/* The next line of `rest` without its line end, NULL after the last; cuts the text up like strsep.
 */
char *text_line(char **rest);

enum { TEXT_LONGEST_LINE = 1000 }; /* bytes, of a table that people write */

/* Prints `text` with its control characters made visible ("\x1b"), so that a name cannot command a
 * terminal or forge a line; those in `keep` are printed as they are. */
void text_show(FILE *out, const char *text, const char *keep);
