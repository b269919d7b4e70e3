/* The settings that results are compared by. */
#pragma once
#include "common/case/case.h"
#include "common/result/result.h"

/* Those in a file of their own, or (`path` NULL) of the case of the first file, which is the
 * reference; problems are printed unless `quiet`. NULL when there are any, with the exit code. */
struct case_file *command_settings(const char *path, size_t n, struct result_file *const *files,
                                   bool quiet, int *exit_code);
