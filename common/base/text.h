/* Text that comes from outside: files that people write (cases, settings, experiments, tolerances),
 * which are read whole, so that none can be read for ever; and names on their way to a terminal. */
#pragma once
#include <stddef.h>
#include <stdio.h>

#include "common/base/status.h"

/* Reads `path`, a regular file of at most `most` bytes, or standard input when it is "-". A UTF-8
 * byte-order mark is left out; a NUL stands behind the last byte and nowhere else. ERR_INPUT with a
 * message that names what was found instead: "a directory", "more than 10 MB". `text` is the
 * caller's to free. */
enum status text_read(const char *path, size_t most, char **text, size_t *n);

/* The next line of `rest` without its line end, NULL after the last; cuts the text up like strsep.
 */
char *text_line(char **rest);

enum { TEXT_LONGEST_LINE = 1000 }; /* bytes, of a table that people write */

/* Text that shows what it holds: control characters, marks that turn the direction of writing and
 * bytes that are not UTF-8 become "\x1b", so that a name cannot command a terminal, forge a line or
 * break a file; those in `keep` stay as they are. */
void text_show(FILE *out, const char *text, const char *keep); /* prints it */
char *text_visible(const char *text, const char *keep);        /* a copy; NULL: no memory */

/* The first byte that is not UTF-8 (RFC 3629) among n, NULL when all are. */
const char *text_bad_utf8(const char *text, size_t n);
