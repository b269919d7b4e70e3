/* The end of a run that cannot go on. */
#pragma once
#include "bem/run/run.h"

/* Ends the run and says what cannot be followed: a film or sheet, a cavity, or a wrinkle. */
enum status bem_ending_write(struct bem_run *r);
