/* Opening files such that nothing else is written into by mistake. */
#pragma once
#include <stdio.h>

/* Like open(2) with mode 0666, closed on exec. The descriptor is never 0, 1 or 2: a program that
 * was started without its standard streams must not print into the file. -1 and errno. */
int file_open(const char *path, int flags);

/* The same open file under a descriptor that is none of these; `fd` is closed. -1 and errno. */
int file_lift(int fd);

/* A new file to be written and then renamed: what is at `path` goes first, and a link there is not
 * followed. NULL and errno. */
FILE *file_create(const char *path);
