#pragma once
/// How HDF5 reads and writes the store: through a file that is open already.
///
/// HDF5 does not survive a failed write: after a full disk, H5Fclose fails, the file stays open inside
/// the library, and the program crashes at exit (1.10.8; HDFGroup/hdf5 pull request 2291). So this
/// driver takes note of the first error, says that all is well, and the caller asks for the error
/// before it uses the file. It takes no locks either (HDF5_USE_FILE_LOCKING has no effect).

#include "app/store/store_disk.hpp"

#include <hdf5.h>

namespace app {

/// Must outlive the HDF5 file that uses it.
struct QuietFile {
    int descriptor = -1;
    int error = 0; ///< errno of the first failed read, write or truncation; 0: none
};

/// Lets files opened with `access`, a file access property list, use `file`; the name given to
/// H5Fopen or H5Fcreate then only appears in messages. Throws StoreError.
void use_quiet_file(hid_t access, QuietFile& file);

} // namespace app
