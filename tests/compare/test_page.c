/* What stands in the page for its scripts: report.json itself, and packed numbers that unpack to
 * what was put in. */
#include "compare/page/pack.h"

#include <libdeflate.h>

#include "compare/page/planes.h"
#include "tests/compare/made_up.h"

/* The JSON of a script element of the page; the caller's. */
static json_t *script_of(const char *page, const char *id) {
  char open[64];
  snprintf(open, sizeof open, "id=\"%s\">", id);
  const char *from = strstr(page, open), *to = from ? strstr(from, "</script>") : NULL;
  EXPECT(to != NULL);
  return to ? json_loadb(from + strlen(open), (size_t)(to - from) - strlen(open), 0, NULL) : NULL;
}

static unsigned digit_of(char c) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const char *at = c && c != '=' ? strchr(digits, c) : NULL;
  return at ? (unsigned)(at - digits) : 0;
}

/* As scripts do it: column k of packed numbers, [n], the caller's. */
static double *unpack(const json_t *planes, size_t k) {
  const size_t n = (size_t)json_integer_value(json_object_get(planes, "n")),
               all = json_array_size(json_object_get(planes, "lo")), size = 2 * n * all;
  const char *text = json_string_value(json_object_get(planes, "data"));
  const double lo = json_number_value(json_array_get(json_object_get(planes, "lo"), k)),
               hi = json_number_value(json_array_get(json_object_get(planes, "hi"), k)),
               steps = json_number_value(json_array_get(json_object_get(planes, "steps"), k));
  const size_t digits = strlen(text);
  unsigned char *packed = calloc(digits + 4, 1), *raw = calloc(size + 1, 1);
  double *column = calloc(n + 1, sizeof *column);
  struct libdeflate_decompressor *inflate = libdeflate_alloc_decompressor();
  if (!packed || !raw || !column || !inflate) abort();
  for (size_t i = 0; i < digits; i += 4) {
    unsigned bits = 0;
    for (size_t j = 0; j < 4; j++) bits = bits << 6 | digit_of(text[i + j]);
    for (size_t j = 0; j < 3; j++) packed[i / 4 * 3 + j] = (unsigned char)(bits >> (16 - 8 * j));
  }
  const size_t padded =
      digits && text[digits - 1] == '=' ? digits > 1 && text[digits - 2] == '=' ? 2 : 1 : 0;
  size_t got = 0;
  EXPECT(libdeflate_zlib_decompress(inflate, packed, digits / 4 * 3 - padded, raw, size, &got) ==
         0);
  EXPECT(got == size);
  unsigned value = 0;
  for (size_t i = 0; i < n; i++) {
    const unsigned folded = raw[2 * n * k + i] | (unsigned)raw[2 * n * k + n + i] << 8;
    value = (value + (folded & 1 ? ~(folded >> 1) : folded >> 1)) & 0xffff;
    column[i] = value == 0xffff ? NAN : lo + (hi - lo) / steps * value;
  }
  libdeflate_free_decompressor(inflate);
  free(packed);
  free(raw);
  return column;
}

/* Numbers of any size, gaps among them, come back to half a step of their range. */
static void test_planes_come_back(void) {
  enum { N = 1000 };
  double a[N], b[N];
  for (int i = 0; i < N; i++) {
    a[i] = i % 97 == 0 ? NAN : sin(0.37 * i) * 2.385;
    b[i] = -7.5;
  }
  struct cmp_packer *p = cmp_packer_create();
  json_t *planes = NULL;
  EXPECT_OK(cmp_planes_pack(p, N, 2, (const double *const[]){a, b}, (const uint16_t[]){1023, 65534},
                            &planes));
  double *back = unpack(planes, 0), *constant = unpack(planes, 1);
  for (int i = 0; i < N; i++) {
    EXPECT(isnan(a[i]) == isnan(back[i]));
    if (!isnan(a[i])) EXPECT_NEAR(back[i], a[i], 2.385 / 1023 + 1e-12);
    EXPECT_NEAR(constant[i], -7.5, 1e-12);
  }
  free(back);
  free(constant);
  json_decref(planes);
  cmp_packer_destroy(p);
}

/* The surfaces of the level 1 + 0.1 cos(pi x) cos(2 t), raised by d. */
static void check_surfaces(const json_t *run, double raised) {
  const json_t *surfaces = json_object_get(run, "surfaces"), *surface;
  size_t i;
  EXPECT(json_array_size(surfaces) == OUTPUTS);
  json_array_foreach(surfaces, i, surface) {
    const double t = json_number_value(json_object_get(surface, "t"));
    double *x = unpack(json_object_get(surface, "planes"), 0),
           *y = unpack(json_object_get(surface, "planes"), 1);
    EXPECT_NEAR(t, end * (double)i / (OUTPUTS - 1), 1e-9);
    for (int k = 0; k <= 100; k++) {
      EXPECT_NEAR(x[k], 0.02 * k, 2. / 65534);
      EXPECT_NEAR(y[k], 1 + raised + 0.1 * cos(M_PI * x[k]) * cos(2 * t), 1e-4);
    }
    free(x);
    free(y);
  }
}

static const json_t *chart_of(const json_t *pack, const char *title) {
  size_t i;
  const json_t *chart;
  json_array_foreach(json_object_get(pack, "charts"), i, chart) {
    if (!strcmp(json_string_value(json_object_get(chart, "title")), title)) return chart;
  }
  TEST_FAIL("no chart of %s", title);
  return NULL;
}

static void test_page_holds_report_and_numbers(void) {
  struct case_file c;
  settings_make(&c);
  const double decay = 0.01, raised = 0.0137;
  struct result_file *a = made_up("a", "</script><b>", (struct flaws){.until = end});
  struct result_file *b =
      made_up("b <i>", "t", (struct flaws){.raised = raised, .decay = decay, .until = end});
  compare(&c, a, 1, &b);
  char *page = read_whole("report.html");
  json_t *inside = script_of(page, "report-data"), *pack = script_of(page, "pack-data");
  EXPECT(json_equal(inside, report));
  const json_t *runs = json_object_get(pack, "runs");
  EXPECT(json_array_size(runs) == 2);
  EXPECT_STR(json_string_value(json_object_get(json_array_get(runs, 1), "label")), "b <i>");
  check_surfaces(json_array_get(runs, 0), 0);
  check_surfaces(json_array_get(runs, 1), raised);
  const json_t *curves = json_object_get(chart_of(pack, "mechanical"), "curves"),
               *planes = json_object_get(json_array_get(curves, 1), "planes");
  double *t = unpack(planes, 0), *energy = unpack(planes, 1);
  for (int i = 0; i < ROWS; i++) EXPECT_NEAR(energy[i], 1 - decay * t[i], 1e-5);
  free(t);
  free(energy);
  free(page);
  json_decref(inside);
  json_decref(pack);
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

int main(void) {
  if (!mkdtemp(folder)) return 1;
  gnuplot_pretend();
  RUN(test_planes_come_back);
  RUN(test_page_holds_report_and_numbers);
  json_decref(report);
  folder_remove(folder);
  return TEST_RESULT;
}
