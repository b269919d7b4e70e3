/* Most tries need no child of their own: a process that may die makes many, one after the other. */
#pragma once

/* From here on, in this process, `guard_run` does all by itself: what is read goes through a file
 * in memory instead of a pipe. It ends the process when memory is short. */
void fuzz_hasten(void);
