#include "common/result/result_driver.h"

#include <stdint.h>
#include <stdlib.h>

struct handle {
  H5FD_t pub; /* HDF5's part, first */
  struct result_driver driver;
};

static const struct result_driver *of(const H5FD_t *file) {
  return &((const struct handle *)file)->driver;
}

static H5FD_t *driver_open(const char *name, unsigned flags, hid_t fapl, haddr_t maxaddr) {
  (void)name, (void)flags, (void)maxaddr;
  const struct result_driver *driver = H5Pget_driver_info(fapl);
  struct handle *h = driver ? calloc(1, sizeof *h) : NULL;
  if (!h) return NULL;
  h->driver = *driver;
  return &h->pub;
}

static herr_t driver_close(H5FD_t *file) {
  free(file);
  return 0;
}

static herr_t driver_query(const H5FD_t *file, unsigned long *flags) {
  (void)file;
  *flags = H5FD_FEAT_DATA_SIEVE;
  return 0;
}

static haddr_t driver_get_eoa(const H5FD_t *file, H5FD_mem_t type) {
  (void)type;
  return *of(file)->eoa;
}

static herr_t driver_set_eoa(H5FD_t *file, H5FD_mem_t type, haddr_t addr) {
  (void)type;
  *of(file)->eoa = addr;
  return 0;
}

static haddr_t driver_get_eof(const H5FD_t *file, H5FD_mem_t type) {
  (void)type;
  return *of(file)->eof;
}

static herr_t driver_read(H5FD_t *file, H5FD_mem_t type, hid_t dxpl, haddr_t addr, size_t size,
                          void *buffer) {
  (void)type, (void)dxpl;
  return of(file)->read(of(file)->data, addr, size, buffer) == OK ? 0 : -1;
}

static herr_t driver_write(H5FD_t *file, H5FD_mem_t type, hid_t dxpl, haddr_t addr, size_t size,
                           const void *buffer) {
  (void)type, (void)dxpl;
  return of(file)->write(of(file)->data, addr, size, buffer) == OK ? 0 : -1;
}

static const H5FD_class_t class = {
    .name = "plunge",
    .maxaddr = (haddr_t)INT64_MAX,
    .fc_degree = H5F_CLOSE_STRONG,
    .fapl_size = sizeof(struct result_driver),
    .open = driver_open,
    .close = driver_close,
    .query = driver_query,
    .get_eoa = driver_get_eoa,
    .set_eoa = driver_set_eoa,
    .get_eof = driver_get_eof,
    .read = driver_read,
    .write = driver_write,
    .fl_map = H5FD_FLMAP_DICHOTOMY,
};

hid_t result_driver_set(hid_t fapl, const struct result_driver *driver) {
  hid_t id = H5FDregister(&class);
  if (id < 0 || H5Pset_driver(fapl, id, driver) >= 0) return id;
  H5FDunregister(id);
  return -1;
}
