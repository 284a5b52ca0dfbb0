#include "app/store/hdf5/file_lock.hpp"

#include "app/store/hdf5/store_error.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace app {

namespace {

namespace fs = std::filesystem;

std::string this_process()
{
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    return "process " + std::to_string(::getpid()) + " on " + host.data();
}

std::string holder(const OpenFile& file)
{
    std::array<char, 300> text{};
    if (::pread(file.get(), text.data(), text.size() - 1, 0) <= 0) return "another process";
    const std::string name = text.data();
    return name.substr(0, name.find('\n'));
}

/// Whether `path` still is the file that was locked: its last holder may have removed it.
bool still_there(const OpenFile& file, const fs::path& path)
{
    struct stat locked {
    }, named{};
    return ::fstat(file.get(), &locked) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           locked.st_dev == named.st_dev && locked.st_ino == named.st_ino;
}

} // namespace

FileLock::FileLock(fs::path path) : path_(std::move(path))
{
    do {
        file_ =
            OpenFile(::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
        if (!file_.is_open()) disk_error("write", path_, errno);
        while (::flock(file_.get(), LOCK_EX | LOCK_NB) != 0) {
            if (errno == EINTR) continue;
            if (errno != EWOULDBLOCK) disk_error("lock", path_, errno);
            throw StoreError("'" + path_.string() + "' is held by " + holder(file_) +
                             ": it works on the same file; wait for it or stop it");
        }
    } while (!still_there(file_, path_));
    const std::string name = this_process() + "\n";
    // the name only informs others: a full disk is no reason not to start
    if (::ftruncate(file_.get(), 0) == 0) {
        [[maybe_unused]] const ssize_t n = ::pwrite(file_.get(), name.data(), name.size(), 0);
    }
}

FileLock::~FileLock()
{
    if (file_.is_open()) ::unlink(path_.c_str()); // before the lock is dropped: see still_there
}

} // namespace app
