/* HDF5 reading from an open descriptor, whatever name the file has meanwhile, or none. */
#pragma once
#include <hdf5.h>

/* -1 with HDF5's reasons when the file cannot be opened; the descriptor stays the caller's. It is
 * for a process that ends with the file: the driver and its properties stay, as HDF5's reasons
 * would go with them. */
hid_t result_fd_open(int fd);
