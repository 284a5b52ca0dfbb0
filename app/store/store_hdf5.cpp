#include "app/store/store_hdf5.hpp"

#include "app/store/store_error.hpp"
#include "app/store/store_seal.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace app::hdf5 {

namespace {

Handle access_of(File& file)
{
    // nothing that goes wrong is printed: it is in what() of the error
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    Handle access = file.owned(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make an access list for");
    use_quiet_file(access.get(), *file.quiet);
    // whole chunks are read and written: a cache of chunks would only take memory
    file.checked(H5Pset_cache(access.get(), 0, 1, 0, 0.75), "set the cache of");
    return access;
}

/// Description of the innermost entry of the error stack.
herr_t innermost(unsigned n, const H5E_error2_t* error, void* text)
{
    if (n == 0 && error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
    return 0;
}

} // namespace

Handle::Handle(Handle&& other) noexcept
    : id_(std::exchange(other.id_, -1)), close_(other.close_)
{
}

Handle& Handle::operator=(Handle&& other) noexcept
{
    if (this != &other) {
        close();
        id_ = std::exchange(other.id_, -1);
        close_ = other.close_;
    }
    return *this;
}

void Handle::close()
{
    if (id_ >= 0) close_(std::exchange(id_, -1));
}

void File::fail(const std::string& what) const
{
    if (quiet->error != 0) disk_error("write or read", path, quiet->error);
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, innermost, &reason);
    throw StoreError("cannot " + what + " '" + path.string() +
                     "': " + (reason.empty() ? "not as it should be" : reason));
}

Handle File::owned(hid_t opened, herr_t (*close)(hid_t), const char* what) const
{
    if (opened < 0) fail(what);
    return {opened, close};
}

File open_file(const std::filesystem::path& path, OpenFile disk)
{
    File file{path, std::move(disk), std::make_unique<QuietFile>(), {}};
    file.quiet->descriptor = file.disk.get();
    const Handle access = access_of(file);
    file.id = file.owned(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose,
                         "open as HDF5");
    return file;
}

File create_file(const std::filesystem::path& path, OpenFile disk)
{
    File file{path, std::move(disk), std::make_unique<QuietFile>(), {}};
    file.quiet->descriptor = file.disk.get();
    const Handle access = access_of(file);
    const Handle creation =
        file.owned(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "make a creation list for");
    file.checked(H5Pset_userblock(creation.get(), kSealBytes), "set up");
    file.checked(H5Pset_obj_track_times(creation.get(), false), "set up");
    file.id = file.owned(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()),
                         H5Fclose, "create");
    return file;
}

OpenFile close_file(File file)
{
    file.id.close();
    if (file.quiet->error != 0) file.fail("write");
    return std::move(file.disk);
}

Handle space_of(const File& file, const std::vector<hsize_t>& sizes)
{
    const hid_t id = H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
    return file.owned(id, H5Sclose, "make a data space in");
}

Handle text_type(std::size_t bytes)
{
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    if (type.get() < 0 || H5Tset_size(type.get(), std::max<std::size_t>(1, bytes)) < 0 ||
        H5Tset_strpad(type.get(), H5T_STR_NULLPAD) < 0 ||
        H5Tset_cset(type.get(), H5T_CSET_UTF8) < 0)
        throw StoreError("HDF5: no text type of " + std::to_string(bytes) + " bytes");
    return type;
}

void make_group(const File& file, const std::string& name)
{
    static_cast<void>(file.owned(
        H5Gcreate2(file.id.get(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Gclose, "add a group to"));
}

void put_attribute(const File& file, const std::string& object, const char* name, hid_t type,
                   const void* value)
{
    const Handle space = file.owned(H5Screate(H5S_SCALAR), H5Sclose, "make a data space in");
    const Handle attribute =
        file.owned(H5Acreate_by_name(file.id.get(), object.c_str(), name, type, space.get(),
                                     H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose, "add an attribute to");
    file.checked(H5Awrite(attribute.get(), type, value), "write");
}

void put_attribute(const File& file, const std::string& object, const char* name,
                   const std::string& text)
{
    constexpr std::size_t most = 32768; // an attribute may take up to 64 KiB
    const std::string shown = text.substr(0, most);
    put_attribute(file, object, name, text_type(shown.size()).get(), shown.c_str());
}

void put_attribute(const File& file, const std::string& object, const char* name,
                   std::uint64_t number)
{
    put_attribute(file, object, name, H5T_STD_U64LE, &number);
}

void put_text(const File& file, const std::string& name, const std::string& text)
{
    const Handle space = file.owned(H5Screate(H5S_SCALAR), H5Sclose, "make a data space in");
    const Handle type = text_type(text.size());
    const Handle dataset =
        file.owned(H5Dcreate2(file.id.get(), name.c_str(), type.get(), space.get(), H5P_DEFAULT,
                              H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose, "add a dataset to");
    file.checked(
        H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()),
        "write");
}

void put_texts(const File& file, const std::string& name, const std::vector<std::string>& texts)
{
    std::size_t longest = 1;
    for (const std::string& text : texts) longest = std::max(longest, text.size());
    std::string padded;
    for (const std::string& text : texts) {
        padded += text;
        padded.append(longest - text.size(), '\0');
    }
    const Handle space = space_of(file, {texts.size()});
    const Handle type = text_type(longest);
    const Handle dataset =
        file.owned(H5Dcreate2(file.id.get(), name.c_str(), type.get(), space.get(), H5P_DEFAULT,
                              H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose, "add a dataset to");
    file.checked(
        H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.c_str()),
        "write");
}

} // namespace app::hdf5
