#pragma once
/// The HDF5 C library behind handles that close themselves. Failures are StoreError; HDF5
/// prints nothing.
///
/// Files are written in the format of HDF5 1.10, in which all metadata carry checksums.

#include "app/store/hdf5/store_error.hpp"

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

namespace app::hdf5 {

class Handle {
  public:
    Handle() = default;
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Handle() { close(); }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Handle& operator=(Handle&& other) noexcept;
    [[nodiscard]] hid_t get() const { return id_; }
    herr_t close() { return id_ >= 0 ? close_(std::exchange(id_, -1)) : 0; }

  private:
    hid_t id_ = -1;
    herr_t (*close_)(hid_t) = nullptr;
};

struct File {
    std::filesystem::path path; ///< for messages
    bool is_new = false;        ///< being written; else only read
    Handle id;

    /// Throws StoreError: `what` cannot be done, the reason of the disk or of HDF5, and what to
    /// do.
    [[noreturn]] void fail(const std::string& what) const;
    /// Handle of what HDF5 just returned; throws if it is none.
    [[nodiscard]] Handle owned(hid_t id, herr_t (*close)(hid_t), const std::string& what) const;
    /// Throws if `result` is negative, else returns it.
    template <class T> T checked(T result, const std::string& what) const
    {
        if (result < 0) fail(what);
        return result;
    }
};

/// For reading. Throws StoreError if it is not an HDF5 file, or a damaged one.
[[nodiscard]] File open_file(const std::filesystem::path& path);
/// There must be no file of this name.
[[nodiscard]] File create_file(const std::filesystem::path& path);
/// Throws StoreError if anything could not be written.
void close_file(File file);

/// UTF-8 of this length, padded with NUL.
[[nodiscard]] Handle text_type(const File& file, std::size_t bytes);
/// Whether it is a text whose bytes stand where the value stands.
[[nodiscard]] bool is_fixed_text(hid_t type);

void make_group(const File& file, const std::string& name);

/// The object of this absolute name. Files come from strangers: a name that leads over a soft
/// or external link, which can name any file of the reader, is refused. Throws StoreError.
[[nodiscard]] Handle opened_object(const File& file, const std::string& name);

/// Attributes of groups and datasets. Throw StoreError.
void put_attribute(const File& file, const std::string& object, const std::string& name,
                   const std::string& text);
void put_attribute(const File& file, const std::string& object, const std::string& name,
                   std::uint64_t number);
/// One text of fixed length, at most 64 KiB; one unsigned number of 64 bits, at most `most`.
/// Whatever else the file has there is refused before it is read.
[[nodiscard]] std::string text_attribute(const File& file, const std::string& object,
                                         const std::string& name);
[[nodiscard]] std::uint64_t number_attribute(const File& file, const std::string& object,
                                             const std::string& name,
                                             std::uint64_t most = UINT64_MAX);

} // namespace app::hdf5
