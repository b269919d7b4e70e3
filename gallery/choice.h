/* Which entries are meant by words of a command line. */
#pragma once
#include "gallery/book.h"

/* Marks entries in `chosen` [book->n_entries]; all of them when there are no words. Each of these
 * stands for one or more, in any case of letters, with ' ', '-' or '_' between its parts:
 *   P 1, p-1, "T Tab 2.1"       an entry; also as several words
 *   P, "T 4", "T Tab 2"         all whose id begins so; of a chapter the tables, too
 *   "T 4-2*", "T ?-1"           all that fit
 *   "T 4-20..T 4-44", P-1..4    from one to another, in the order of the documents
 * ERR_USAGE names the word that stands for none, and what is nearest. */
enum status gallery_choose(const struct gallery_book *book, size_t n, const char *const *word,
                           bool *chosen);
