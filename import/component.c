#include "import/component.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* Splits a copy; whether it has a number. */
static bool split(const char *column, char name[IMPORT_LONGEST + 1], size_t *component) {
  snprintf(name, IMPORT_LONGEST + 1, "%s", column);
  char *colon = strrchr(name, ':');
  *component = 0;
  if (!colon || !isdigit((unsigned char)colon[1]) || colon[2]) return false;
  *colon = 0;
  *component = (size_t)(colon[1] - '0');
  return true;
}

void import_array_name(const char *column, char name[IMPORT_LONGEST + 1]) {
  size_t component;
  split(column, name, &component);
}

bool import_pick(const char *column, size_t components, size_t *component,
                 char wrong[IMPORT_WRONG]) {
  char name[IMPORT_LONGEST + 1];
  const bool told = split(column, name, component);
  if (!told && components > 1)
    snprintf(wrong, IMPORT_WRONG, "has %zu components of '%s'; ask for one, as '%s:0'", components,
             name, name);
  else if (*component >= components)
    snprintf(wrong, IMPORT_WRONG, "has no component %zu of '%s', which has %zu, from 0", *component,
             name, components);
  else
    return true;
  return false;
}
