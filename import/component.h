/* "alpha:1" asks for component 1 of the array alpha. Shared with the module of the VTK library. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

enum { IMPORT_LONGEST = 200, IMPORT_WRONG = 2 * IMPORT_LONGEST + 100 };

#ifdef __cplusplus
extern "C" {
#endif
/* The name of the array alone. */
void import_array_name(const char *column, char name[IMPORT_LONGEST + 1]);

/* Which component is asked for of an array that has so many: the only one may go without a number.
 * False with what is wrong, "has no component 5 of 'v', ...". */
bool import_pick(const char *column, size_t components, size_t *component,
                 char wrong[IMPORT_WRONG]);
#ifdef __cplusplus
}
#endif
