/* Entries of the gallery at work, and what each leaves: OUT/entries/KEY.json
 * (docs/gallery-entries.md). */
#pragma once
#include <jansson.h>

#include "cli/gallery_runs.h"
#include "common/base/progress.h"

/* What is there of an entry, made of the same text by the same program with or without --quick.
 * NULL: nothing. `runs`: they must be the same, too, and nothing of it missing; NULL: whichever. */
json_t *gallery_entries_read(const char *out, const struct gallery_entry *e, bool quick,
                             const struct gallery_runs *runs);

/* ERR_USAGE when the folder has entries made with --quick and these are to be without, or the other
 * way round: what took an hour must not go for want of an option. */
enum status gallery_entries_check_folder(const char *out, const struct gallery_book *book,
                                         bool quick);

/* Makes the entries marked in `chosen`, several at a time, of runs that have been made, as far as
 * they could. One that cannot be made says why in what it leaves. INTERRUPTED. */
enum status gallery_entries_make(const struct gallery_runs *runs, const bool *chosen, int jobs,
                                 struct progress *progress);

/* What --quick leaves out leaves this. ERR_IO. */
enum status gallery_entries_leave(const struct gallery_runs *runs, const struct gallery_entry *e);

/* A file of JSON that appears whole. */
enum status gallery_entries_write(const char *folder, const char *name, const json_t *json);
