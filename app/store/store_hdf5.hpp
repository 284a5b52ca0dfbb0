#pragma once
/// The HDF5 C library behind handles that close themselves. Failures are StoreError; HDF5 prints
/// nothing.

#include "app/store/store_driver.hpp"

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace app::hdf5 {

class Handle {
  public:
    Handle() = default;
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Handle() { close(); }
    Handle(Handle&& other) noexcept;
    Handle& operator=(Handle&& other) noexcept;
    [[nodiscard]] hid_t get() const { return id_; }
    void close();

  private:
    hid_t id_ = -1;
    herr_t (*close_)(hid_t) = nullptr;
};

/// An HDF5 file on an open descriptor.
struct File {
    std::filesystem::path path; ///< for messages
    OpenFile disk;
    std::unique_ptr<QuietFile> quiet;
    Handle id; ///< closed before `disk`

    /// Throws StoreError: `what` cannot be done; reason of the disk, else of HDF5.
    [[noreturn]] void fail(const std::string& what) const;
    /// Handle of what HDF5 just returned; throws if it is none.
    [[nodiscard]] Handle owned(hid_t id, herr_t (*close)(hid_t), const char* what) const;
    /// Throws if `result` is negative or the disk has failed meanwhile; else returns it.
    template <class T> T checked(T result, const char* what) const
    {
        if (result < 0 || quiet->error != 0) fail(what);
        return result;
    }
};

/// `disk` must hold a sealed file.
[[nodiscard]] File open_file(const std::filesystem::path& path, OpenFile disk);
/// `disk` must be empty and open for reading and writing; the seal is left free.
[[nodiscard]] File create_file(const std::filesystem::path& path, OpenFile disk);
/// Closes the HDF5 file and hands its descriptor back. Throws if anything failed since it was created.
[[nodiscard]] OpenFile close_file(File file);

/// A data space of these sizes.
[[nodiscard]] Handle space_of(const File& file, const std::vector<hsize_t>& sizes);

[[nodiscard]] Handle text_type(std::size_t bytes); ///< UTF-8 of this length, padded with NUL

void make_group(const File& file, const std::string& name);
/// Adds a value, a text or a number to a dataset or group; text of at most 32 KiB.
void put_attribute(const File& file, const std::string& object, const char* name, hid_t type,
                   const void* value);
void put_attribute(const File& file, const std::string& object, const char* name,
                   const std::string& text);
void put_attribute(const File& file, const std::string& object, const char* name,
                   std::uint64_t number);
/// A dataset of one text.
void put_text(const File& file, const std::string& name, const std::string& text);
/// A dataset of several texts, padded to the longest.
void put_texts(const File& file, const std::string& name,
               const std::vector<std::string>& texts);

} // namespace app::hdf5
