/* What must be right before anything else of the program happens. */
#pragma once

/* Puts /dev/null where standard input, output or error is closed: the next file opened, a result
 * perhaps, would get its number, and every word meant for the terminal would go into it. Besides,
 * being called makes sure that the part of this file that runs before main() is linked. */
void start_fill_descriptors(void);
