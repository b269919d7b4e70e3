/* HDF5's bytes wherever they are kept: a file driver made of a few functions. */
#pragma once
#include <hdf5.h>

#include "common/base/status.h"

struct result_driver {
  void *data;
  haddr_t *eoa;       /* end of what HDF5 has allocated: it says so here */
  const haddr_t *eof; /* end of what is there; beyond it are zeros */
  enum status (*read)(void *data, haddr_t at, size_t n, unsigned char *to);
  enum status (*write)(void *data, haddr_t at, size_t n, const unsigned char *from);
};

/* Makes files that are opened with `fapl` use the driver; what it points to must outlive them. Its
 * id, to be unregistered when they are closed; -1 with HDF5's reasons. */
hid_t result_driver_set(hid_t fapl, const struct result_driver *driver);
