#pragma once
/// The system calls of the store, with messages that name the file and what to do.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
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

/// Length [bytes]. Throws StoreError.
[[nodiscard]] std::uint64_t file_length(const OpenFile& file,
                                        const std::filesystem::path& path);

/// Reads up to `size` bytes from `offset`; fewer only at the end of the file. Throws StoreError.
std::size_t read_at(const OpenFile& file, const std::filesystem::path& path, void* data,
                    std::size_t size, std::uint64_t offset);

/// Writes all at `offset`. 0, or the errno of what went wrong.
[[nodiscard]] int write_at(int descriptor, const void* data, std::size_t size,
                           std::uint64_t offset);

/// Makes a rename or a removal in the folder of `path` last. Throws StoreError.
void sync_folder_of(const std::filesystem::path& path);

/// CRC-32 of zlib, that of Python's zlib.crc32; `sum` continues an earlier one.
[[nodiscard]] std::uint32_t crc32_of(std::string_view bytes, std::uint32_t sum = 0);

} // namespace app
