/* Columns of numbers as text: each in so many steps between its least and its largest (65534 at
 * most), as differences from one to the next, their low bytes before their high ones, deflated
 * (zlib), in base64. */
#pragma once
#include <jansson.h>
#include <stdint.h>

#include "common/base/status.h"

enum { CMP_PLANES = 8 }; /* at most */

struct cmp_packer;
struct cmp_packer *cmp_packer_create(void);    /* NULL: no memory */
void cmp_packer_destroy(struct cmp_packer *p); /* NULL is fine */

/* {"n", "lo": [...], "hi": [...], "steps": [...], "data": "..."} of `planes` columns of n numbers,
 * `steps` [planes]; what is not finite is the value 65535. ERR_MEMORY. */
enum status cmp_planes_pack(struct cmp_packer *p, size_t n, size_t planes,
                            const double *const *column, const uint16_t *steps, json_t **out);

/* RFC 4648; the caller's to free, NULL: no memory. */
char *cmp_base64(const uint8_t *from, size_t n);
