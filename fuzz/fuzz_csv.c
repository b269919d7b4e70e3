/* A text of columns that an import reads. */
#include <math.h>

#include "fuzz/fuzz.h"
#include "import/formats.h"

int LLVMFuzzerInitialize(int *argc, char ***argv) {
  (void)argc, (void)argv;
  fuzz_file_create(FUZZ_FILE);
  return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  struct import_ask ask = {.path = FUZZ_PATH,
                           .separator = ",;\t "[size % 4],
                           .time_after = "t=",
                           .names[IMPORT_x] = "x",
                           .names[IMPORT_y] = "2"};
  struct import_table t;
  fuzz_file_fill(FUZZ_FILE, data, size);
  if (import_csv_read(&ask, &t) == OK) {
    if (!t.n || !t.column[IMPORT_x] || !t.column[IMPORT_y]) abort();
    for (size_t i = 0; i < t.n; i++)
      if (isinf(t.column[IMPORT_x][i]) || isinf(t.column[IMPORT_y][i])) abort();
  }
  import_table_destroy(&t);
  return 0;
}
