#pragma once
/// The system calls of the store, with messages that name the file and what to do.

#include <filesystem>
#include <string_view>

namespace app {

/// A file descriptor, closed with its owner.
class OpenFile {
  public:
    OpenFile() = default;
    explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
    ~OpenFile() { close(); }
    OpenFile(OpenFile&& other) noexcept;
    OpenFile& operator=(OpenFile&& other) noexcept;
    [[nodiscard]] int get() const { return descriptor_; }
    [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
    void close();

  private:
    int descriptor_ = -1;
};

/// Throws StoreError: "cannot <what> '<path>': <reason>; <what to do>".
[[noreturn]] void disk_error(std::string_view what, const std::filesystem::path& path,
                             int error);

/// Opens for reading; not open if there is no such file. Throws StoreError for any other reason
/// and if it is not a regular file.
[[nodiscard]] OpenFile open_to_read(const std::filesystem::path& path);

/// Waits until the disk has the content of the file. Throws StoreError.
void sync_file(const std::filesystem::path& path);

/// Waits until the disk has the names in the folder of `path`, so that a rename or a removal
/// there outlives a power cut. Throws StoreError.
void sync_folder_of(const std::filesystem::path& path);

} // namespace app
