#pragma once
/// One writer per file.

#include "app/store/hdf5/store_disk.hpp"

#include <filesystem>

namespace app {

/// Holds `path` (a small file that names the process) locked until destroyed, then removes it.
/// The system drops the lock when the process ends, kill -9 included: there are no stale locks.
/// flock(2): on NFS it reaches other machines only where the lock daemon runs.
class FileLock {
  public:
    /// Throws StoreError: held by another process, which is named, or by another lock of this
    /// one; or cannot be written.
    explicit FileLock(std::filesystem::path path);
    ~FileLock();
    FileLock(FileLock&&) noexcept = default;
    FileLock& operator=(FileLock&&) = delete;

  private:
    std::filesystem::path path_;
    OpenFile file_;
};

} // namespace app
