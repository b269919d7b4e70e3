/* Where an import may write. */
#pragma once
#include "import/sidecar.h"

/* ERR_INPUT with what to do, unless `path` ends in .h5, is none of the files that the import reads
 * (neither is the .xdmf beside it), and is either not there or a result, which is replaced. */
enum status import_check_target(const char *path, const struct import_sidecar *s);
