/* Where a result file is kept while a run writes it: an HDF5 file driver whose commits are atomic.
 *
 * HDF5 overwrites its indices in place, so a program killed while it writes may leave a file that
 * nobody can open, and a full disk found in the middle of a write leaves one for certain. Here HDF5
 * writes into memory only. A commit writes what changed into a second file (the back file,
 * .NAME.next) and then exchanges the names of the two: whoever opens the file, at any moment and
 * after any kind of death, finds exactly one of the committed states. The price is twice the disk
 * space until the run ends. A reader that has the file open keeps the state it opened: HDF5 locks
 * what it reads, and a back file that is still locked is left to its reader and replaced by a copy
 * of the front. A third, empty file, .NAME.lock, keeps other runs out for as long as the run goes
 * on.
 *
 * A commit also puts a seal behind the HDF5 data: a checksum of the whole file, by which a reader
 * knows a damaged file before HDF5 touches it (result_seal.h). HDF5 programs ignore those bytes. */
#pragma once
#include <hdf5.h>
#include <stdbool.h>

#include "common/base/status.h"

struct result_store;

/* Nothing is written yet, and an earlier file at `path` stays until the first commit. ERR_IO when
 * the directory cannot be written or another program is writing the same file. */
enum status result_store_create(const char *path, struct result_store **out);

/* A new HDF5 file in the store, which must outlive it. ERR_IO. */
enum status result_store_open(struct result_store *s, hid_t *file);

/* Makes all that HDF5 has flushed appear under the path, at once or (ERR_IO: no room, or the disk
 * fails) not at all; then the state before is still there, and a later commit may succeed. `last`
 * spares the second copy: there will be no further commit. */
enum status result_store_commit(struct result_store *s, bool last);

void result_store_destroy(
    struct result_store *s); /* leaves the last committed state; NULL is fine */

/* Whether a run is writing the file at this moment (as far as file locks tell). */
bool result_store_is_written(const char *path);

/* Whether `bytes` more can be written beside `path` and a file of `size` bytes is allowed;
 * ERR_IO with what to do. */
enum status result_store_room(const char *path, unsigned long long bytes, unsigned long long size);
