#include "app/store/hdf5/store_disk.hpp"

#include "app/store/hdf5/store_error.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace app {

namespace {

namespace fs = std::filesystem;

const char* remedy(int error)
{
    switch (error) {
    case ENOSPC:
    case EDQUOT:
        return "; make space there and run the same command again; a study continues "
               "with the walls it has";
    case EFBIG:
        return "; raise the limit of file sizes (ulimit -f) and run the same command again";
    case EROFS:
    case EACCES:
    case EPERM:
        return "; choose a folder that can be written, or change its permissions";
    case ENOENT:
        return "; its folder is not there (it may have been removed or moved meanwhile): make "
               "it "
               "and run the same command again";
    case ELOOP:
        return "; it is a symbolic link: remove it";
    case EIO:
        return "; the disk reports a fault: copy the file elsewhere and continue there";
    case EMFILE:
    case ENFILE:
        return "; raise the number of open files (ulimit -n)";
    default:
        return "";
    }
}

} // namespace

OpenFile::OpenFile(OpenFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1))
{
}

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept
{
    if (this != &other) {
        close();
        descriptor_ = std::exchange(other.descriptor_, -1);
    }
    return *this;
}

void OpenFile::close()
{
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

void disk_error(std::string_view what, const fs::path& path, int error)
{
    throw StoreError("cannot " + std::string(what) + " '" + path.string() +
                     "': " + std::generic_category().message(error) + remedy(error));
}

OpenFile open_to_read(const fs::path& path)
{
    // O_NONBLOCK: a pipe of this name would wait for its writer
    OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!file.is_open()) {
        if (errno == ENOENT) return file;
        disk_error("open", path, errno);
    }
    struct stat about {};
    if (::fstat(file.get(), &about) != 0) disk_error("read", path, errno);
    if (!S_ISREG(about.st_mode))
        throw StoreError("cannot read '" + path.string() + "': it is not a regular file");
    return file;
}

void sync_file(const fs::path& path)
{
    const OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
    if (!file.is_open() || ::fsync(file.get()) != 0) disk_error("write", path, errno);
}

void sync_folder_of(const fs::path& path)
{
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const OpenFile file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!file.is_open()) disk_error("open folder", folder, errno);
    // some file systems cannot sync a folder and say EINVAL
    if (::fsync(file.get()) != 0 && errno != EINVAL) disk_error("write folder", folder, errno);
}

} // namespace app
