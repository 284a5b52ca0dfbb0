#include "app/output/atomic_output.hpp"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace app {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const fs::path& path, const std::string& reason)
{
    throw std::runtime_error("cannot " + what + " '" + path.string() + "': " + reason);
}

std::string reason_of(int error) { return std::generic_category().message(error); }

/// A name no other writer uses: processes differ by id, threads by the counter.
fs::path temporary_beside(const fs::path& path)
{
    static std::atomic<unsigned> counter{0};
    fs::path name = path;
    name.replace_filename("." + path.filename().string() + "." + std::to_string(::getpid()) +
                          "-" + std::to_string(counter++) + ".tmp");
    return name;
}

/// 0, or the errno of what went wrong.
int write_all(int file, std::string_view content)
{
    while (!content.empty()) {
        const ssize_t written = ::write(file, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        content.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

} // namespace

void make_folder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) fail("create folder", folder, error.message());
}

NewFile::NewFile(fs::path path) : path_(std::move(path)), temporary_(temporary_beside(path_))
{
    std::error_code ignored;
    // renaming over a device would replace it: /dev/null, for root
    if (fs::exists(path_, ignored) && !fs::is_regular_file(path_, ignored))
        fail("write", path_, "it exists and is not a regular file");
    file_ = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file_ < 0) fail("write", path_, reason_of(errno));
}

NewFile::~NewFile()
{
    if (temporary_.empty()) return;
    if (file_ >= 0) ::close(file_);
    ::unlink(temporary_.c_str());
}

void NewFile::add(std::string_view content)
{
    if (const int error = write_all(file_, content); error != 0)
        fail("write", path_, reason_of(error));
}

void NewFile::finish()
{
    // network disks report a full disk here
    if (::close(std::exchange(file_, -1)) != 0 ||
        ::rename(temporary_.c_str(), path_.c_str()) != 0)
        fail("write", path_, reason_of(errno));
    temporary_.clear();
}

void write_file(const fs::path& path, std::string_view content)
{
    NewFile file(path);
    file.add(content);
    file.finish();
}

} // namespace app
