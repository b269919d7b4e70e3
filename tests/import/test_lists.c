/* Files that name others: libraries read them in a child process, times are whole numbers or none,
 * and the parts of a parallel file count for its limits. */
#include "import/lists.h"

#include <dlfcn.h>
#include <jansson.h>
#include <libxml/parser.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/test.h"

static bool crash; /* the libraries do */

/* These stand before those of the libraries. */
xmlDocPtr xmlReadMemory(const char *text, int n, const char *url, const char *code, int options) {
  if (crash) abort();
  __typeof__(&xmlReadMemory) next;
  *(void **)&next = dlsym(RTLD_NEXT, "xmlReadMemory");
  return next(text, n, url, code, options);
}

json_t *json_loadb(const char *text, size_t n, size_t flags, json_error_t *error) {
  if (crash) abort();
  __typeof__(&json_loadb) next;
  *(void **)&next = dlsym(RTLD_NEXT, "json_loadb");
  return next(text, n, flags, error);
}

static void write_file(const char *path, const char *text) {
  FILE *f = fopen(path, "w");
  EXPECT(f && fputs(text, f) >= 0 && !fclose(f));
}

static void test_lists_are_read(void) {
  struct import_list list;
  write_file("sub/a.pvd", "<VTKFile><Collection><DataSet timestep=\"0.5\" file=\"a.vtu\"/>"
                          "<DataSet timestep=\" 1e3 \" file=\"b/b.vtu\"/></Collection></VTKFile>");
  EXPECT_OK(import_list_read("sub/a.pvd", &list));
  EXPECT(list.n == 2);
  EXPECT_STR(list.item[1].file, "sub/b/b.vtu");
  EXPECT(list.item[0].time == 0.5 && list.item[1].time == 1000);
  import_list_destroy(&list);
  write_file("a.vtk.series", "{\"files\": [{\"name\": \"a.vtk\", \"time\": 2}]}");
  EXPECT_OK(import_list_read("a.vtk.series", &list));
  EXPECT(list.n == 1 && list.item[0].time == 2);
  EXPECT_STR(list.item[0].file, "a.vtk");
  import_list_destroy(&list);
}

static void test_crash_of_a_library_is_a_message(void) {
  struct import_list list;
  crash = true;
  EXPECT(import_list_read("sub/a.pvd", &list) == ERR_INPUT && !list.n);
  EXPECT_STR(status_message(), "sub/a.pvd is damaged beyond reading");
  EXPECT(import_list_read("a.vtk.series", &list) == ERR_INPUT && !list.n);
  EXPECT_STR(status_message(), "a.vtk.series is damaged beyond reading");
  crash = false;
}

static void test_times_are_numbers(void) {
  static const char *const times[] = {"abc", "0,25", "-1e3x", "", "inf", "1 2"};
  for (size_t k = 0; k < sizeof times / sizeof *times; k++) {
    struct import_list list;
    char text[200];
    snprintf(text, sizeof text, "<VTKFile><DataSet timestep=\"%s\" file=\"a.vtu\"/></VTKFile>",
             times[k]);
    write_file("t.pvd", text);
    EXPECT(import_list_read("t.pvd", &list) == ERR_INPUT && !list.n);
    EXPECT_STR(status_message(), "t.pvd gives 'a.vtu' no time, or one that is no decimal number");
  }
}

static void test_parts_count(void) {
  write_file("sub/p0.vtu", "12345");
  write_file("sub/p1.vtu", "1234567");
  write_file("top.vtu", "123");
  write_file("sub/all.pvtu",
             "<Piece Source=\"p0.vtu\"/><Piece Source='p1.vtu'/><Piece Source=\"p1.vtu\"/>"
             "<Piece Source=\"none.vtu\"/><Piece Source=\"..\"/><Piece Source=\"/dev/zero\"/>");
  EXPECT(import_parts_size("sub/all.pvtu") == 12);
  struct stat about;
  EXPECT(!stat("sub/all.pvtu", &about));
  write_file("round.vtm", "<DataSet index=\"0\" file=\"sub/all.pvtu\"/><DataSet file=\"top.vtu\"/>"
                          "<DataSet file=\"round.vtm\"/>");
  struct stat round;
  EXPECT(!stat("round.vtm", &round));
  EXPECT(import_parts_size("round.vtm") == 12 + 3 + (size_t)about.st_size + (size_t)round.st_size);
  write_file("plain.vtu", "<Piece Source=\"top.vtu\"/>");
  EXPECT(import_parts_size("plain.vtu") == 0 && import_parts_size("none.vtm") == 0);
}

int main(void) {
  char folder[] = "/tmp/lists-XXXXXX";
  if (!mkdtemp(folder) || chdir(folder) || mkdir("sub", 0777)) return 1;
  RUN(test_lists_are_read);
  RUN(test_crash_of_a_library_is_a_message);
  RUN(test_times_are_numbers);
  RUN(test_parts_count);
  static const char *const files[] = {"sub/a.pvd",  "a.vtk.series", "t.pvd",
                                      "sub/p0.vtu", "sub/p1.vtu",   "top.vtu",
                                      "plain.vtu",  "round.vtm",    "sub/all.pvtu"};
  for (size_t k = 0; k < sizeof files / sizeof *files; k++) EXPECT(!unlink(files[k]));
  EXPECT(!rmdir("sub") && !chdir("/") && !rmdir(folder));
  return TEST_RESULT;
}
