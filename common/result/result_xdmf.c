#include "common/result/result_xdmf.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/base/file.h"
#include "common/result/result_store.h"

struct xdmf {
  char *path, *next; /* the file, and the one that is about to become it; owned */
  char *h5_name;     /* of the result file in the same folder, escaped for XML; owned */
  char *text;        /* of all steps, grown by the stream; owned */
  size_t size;
  FILE *steps;
  size_t n, n_written; /* steps so far, and on disk */
};

static char *xml_escape(const char *text) {
  char *out = malloc(6 * strlen(text) + 1), *p = out;
  if (!out) return NULL;
  for (; *text; text++) {
    const char *code = *text == '&'   ? "&amp;"
                       : *text == '<' ? "&lt;"
                       : *text == '"' ? "&quot;"
                                      : NULL;
    if (code)
      p = stpcpy(p, code);
    else
      *p++ = *text;
  }
  *p = 0;
  return out;
}

enum status xdmf_create(const char *h5_path, struct xdmf **out) {
  struct xdmf *x = *out = calloc(1, sizeof *x);
  CHECK(x, ERR_MEMORY, "no memory to write %s", h5_path);
  const char *slash = strrchr(h5_path, '/'), *base = slash ? slash + 1 : h5_path;
  const char *dot = strrchr(base, '.');
  int folder = (int)(base - h5_path),
      stem = dot && dot > base ? (int)(dot - base) : (int)strlen(base);
  if (asprintf(&x->path, "%.*s%.*s.xdmf", folder, h5_path, stem, base) < 0) x->path = NULL;
  if (asprintf(&x->next, "%.*s.%.*s.xdmf.next", folder, h5_path, stem, base) < 0) x->next = NULL;
  x->h5_name = xml_escape(base);
  x->steps = open_memstream(&x->text, &x->size);
  if (!x->path || !x->next || !x->h5_name || !x->steps) {
    xdmf_destroy(x);
    *out = NULL;
    return status_raise(ERR_MEMORY, "no memory to write %s", h5_path);
  }
  unlink(x->path);
  return OK;
}

/* Rows [first, first + n) of a dataset with rows of `width` numbers (1: a vector). */
static void rows(struct xdmf *x, const char *set, size_t first, size_t n, int width) {
  if (width == 1)
    fprintf(x->steps,
            "<DataItem ItemType=\"HyperSlab\" Dimensions=\"%zu\" Type=\"HyperSlab\">"
            "<DataItem Dimensions=\"3 1\" Format=\"XML\">%zu 1 %zu</DataItem>"
            "<DataItem Dimensions=\"%zu\"",
            n, first, n, first + n);
  else
    fprintf(x->steps,
            "<DataItem ItemType=\"HyperSlab\" Dimensions=\"%zu %d\" Type=\"HyperSlab\">"
            "<DataItem Dimensions=\"3 2\" Format=\"XML\">%zu 0 1 1 %zu %d</DataItem>"
            "<DataItem Dimensions=\"%zu %d\"",
            n, width, first, n, width, first + n, width);
  fprintf(x->steps,
          " NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">%s:%s</DataItem></DataItem>",
          x->h5_name, set);
}

enum status xdmf_step(struct xdmf *x, double time, size_t first, size_t n, enum result_cells cells,
                      size_t n_fields, const struct result_field *fields) {
  fprintf(x->steps, "<Grid Name=\"output %zu\"><Time Value=\"%.17g\"/>\n", x->n, time);
  if (cells == RESULT_LINE)
    fprintf(
        x->steps,
        "<Topology TopologyType=\"Polyline\" NumberOfElements=\"1\" NodesPerElement=\"%zu\"/>\n",
        n);
  else
    fprintf(
        x->steps,
        "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"%zu\" NodesPerElement=\"1\"/>\n",
        n);
  fputs("<Geometry GeometryType=\"XYZ\">", x->steps);
  rows(x, "/VTKHDF/Points", first, n, 3);
  fputs("</Geometry>\n", x->steps);
  for (size_t i = 0; i < n_fields; i++) {
    char set[256];
    snprintf(set, sizeof set, "/VTKHDF/PointData/%s", fields[i].name);
    fprintf(x->steps, "<Attribute Name=\"%s\" AttributeType=\"%s\" Center=\"Node\">",
            fields[i].name, fields[i].b ? "Vector" : "Scalar");
    rows(x, set, first, n, fields[i].b ? 3 : 1);
    fputs("</Attribute>\n", x->steps);
  }
  fputs("</Grid>\n", x->steps);
  x->n++;
  CHECK(!ferror(x->steps), ERR_MEMORY, "no memory for %s", x->path);
  return OK;
}

static const char head[] =
    "<?xml version=\"1.0\" ?>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
    "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
static const char tail[] = "</Grid>\n</Domain>\n</Xdmf>\n";

enum status xdmf_write(struct xdmf *x, bool last) {
  /* The whole file is written each time, so a run of very many outputs writes it less often: the
   * work stays proportional to the number of outputs. */
  size_t news = x->n - x->n_written;
  if (!news || (!last && news < x->n / 256)) return OK;
  fflush(x->steps);
  TRY(result_store_room(x->path, x->size + 4096, x->size + 4096));
  FILE *f = file_create(x->next);
  CHECK(f, ERR_IO, "cannot write beside %s: %s", x->path, strerror(errno));
  bool good =
      fputs(head, f) >= 0 && fwrite(x->text, 1, x->size, f) == x->size && fputs(tail, f) >= 0;
  good = !fclose(f) && good && !rename(x->next, x->path);
  int reason = errno;
  if (!good) unlink(x->next);
  CHECK(good, ERR_IO, "cannot write %s: %s", x->path, strerror(reason));
  x->n_written = x->n;
  return OK;
}

void xdmf_remove(struct xdmf *x) {
  if (x) unlink(x->path);
}

void xdmf_destroy(struct xdmf *x) {
  if (!x) return;
  if (x->steps) fclose(x->steps);
  free(x->text);
  free(x->path);
  free(x->next);
  free(x->h5_name);
  free(x);
}
