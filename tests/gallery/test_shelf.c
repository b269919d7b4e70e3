/* The files of the gallery are in the program, byte for byte, with all that they name. */
#include <ctype.h>
#include <stdlib.h>

#include "common/base/text.h"
#include "gallery/shelf.h"
#include "tests/test.h"

static void test_bytes_are_those_of_the_sources(void) {
  EXPECT(gallery_shelf_count > 0);
  for (size_t i = 0; i < gallery_shelf_count; i++) {
    const struct gallery_shelf_file *f = &gallery_shelf[i];
    char path[1024], *text = NULL;
    size_t n = 0;
    snprintf(path, sizeof path, SOURCE_DIR "/%s", f->path);
    EXPECT_OK(text_read(path, 1 << 24, &text, &n));
    if (!text) continue;
    if (n != f->size || memcmp(text, f->bytes, n + 1) != 0) TEST_FAIL("%s differs", f->path);
    free(text);
    if (i && strcmp(gallery_shelf[i - 1].path, f->path) >= 0) TEST_FAIL("%s: order", f->path);
  }
}

static void test_files_are_found(void) {
  for (size_t i = 0; i < gallery_shelf_count; i++)
    EXPECT(gallery_shelf_find(gallery_shelf[i].path) == &gallery_shelf[i]);
  EXPECT(gallery_shelf_find("cases/dam-break.yaml") != NULL);
  EXPECT(gallery_shelf_find("dam-break.yaml") == NULL);
  EXPECT(gallery_shelf_find_case("dam-break.yaml") == gallery_shelf_find("cases/dam-break.yaml"));
  EXPECT(gallery_shelf_find_case("none.yaml") == NULL);
  EXPECT(gallery_shelf_find_case("") == NULL);
}

/* What cases read beside themselves: "file: PATH", from the folder of the case. */
static void test_data_of_cases_are_there(void) {
  size_t n = 0;
  for (size_t i = 0; i < gallery_shelf_count; i++) {
    const struct gallery_shelf_file *f = &gallery_shelf[i];
    const char *slash = strrchr(f->path, '/'), *dot = strrchr(f->path, '.');
    if (strcmp(dot ? dot : "", ".yaml") != 0 || strstr(f->path, "entries/")) continue;
    for (const char *at = f->bytes; (at = strstr(at, "file: ")); n++) {
      char path[1024];
      const bool is_key = at > f->bytes && !isalpha((unsigned char)at[-1]); /* not a profile */
      at += strlen("file: ");
      if (!is_key) continue;
      snprintf(path, sizeof path, "%.*s/%.*s", (int)(slash - f->path), f->path,
               (int)strcspn(at, ",} \n"), at);
      if (!gallery_shelf_find(path)) TEST_FAIL("%s: %s is not there", f->path, path);
    }
  }
  EXPECT(n > 0);
}

int main(void) {
  RUN(test_bytes_are_those_of_the_sources);
  RUN(test_files_are_found);
  RUN(test_data_of_cases_are_there);
  return TEST_RESULT;
}
