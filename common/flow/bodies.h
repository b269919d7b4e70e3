/* What bodies of water that float in the middle of a tank share. */
#pragma once
#include "common/case/case.h"
#include "common/flow/flow.h"

/* A row of a struct that has a rate of the key's name. */
#define BODY_RATE(struct_, member, least, first, text)                                             \
  {                                                                                                \
    .key = #member, .type = PARAM_REAL, .quantity = QTY_RATE, .offset = offsetof(struct_, member), \
    .min = least, .max = 1e6, .value = first, .help = text                                         \
  }

/* The middle of the tank, m. */
void flow_body_middle(const struct case_file *c, double middle[2]);

/* Of a body of this area, m^2. */
struct flow_scale flow_body_scale(const struct case_file *c, double size, double area);

/* That the tank has room for a body that goes so far, m, from its middle. */
void flow_body_check_room(const struct case_file *c, struct case_draft *d, double reach,
                          const char *key);
