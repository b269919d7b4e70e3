/* The end of a run that cannot go on. */
#pragma once
#include "bem/run/run.h"

/* Ends the run and says what cannot be followed: a film or sheet, a cavity, or a wrinkle. */
enum status bem_ending_write(struct bem_run *r);

/* Ends the run and says how far the end of its case still is after so many steps. */
enum status bem_ending_spent(struct bem_run *r);
