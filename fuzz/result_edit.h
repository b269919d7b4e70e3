/* Edits of result files for the fuzzer. Their seal is to be put right afterwards. */
#pragma once
#include <stddef.h>
#include <stdint.h>

/* A number below n that follows from the state, which goes on. */
uint32_t draw(uint32_t *state, uint32_t n);

/* Which objects the writer's file has, of which the edits are made. */
void edit_learn(uint8_t *data, size_t size);

/* One to four edits through HDF5: links, attributes, lengths, numbers. The new size, or 0 when
 * nothing came of it: HDF5 may crash while it writes as well, so a child does it. */
size_t edit_through_hdf5(uint8_t *data, size_t size, size_t most, uint32_t *state);

/* One to three edits of bytes; the checksums of HDF5's headers are put right again. */
void edit_bytes(uint8_t *data, size_t size, uint32_t *state);
