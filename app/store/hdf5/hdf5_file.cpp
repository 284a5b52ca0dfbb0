#include "app/store/hdf5/hdf5_file.hpp"

#include "app/store/hdf5/store_disk.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace app::hdf5 {

namespace {

namespace fs = std::filesystem;

/// Once per process, before HDF5 is used.
bool set_up_library()
{
    // After a full disk H5Fclose fails and leaves the file open inside the library, which then
    // crashes when it cleans up at exit (HDFGroup/hdf5 pull request 2291). There is nothing to
    // clean up.
    H5dont_atexit();
    H5open();
    return true;
}

Handle access_of(const File& file)
{
    static const bool ready = set_up_library();
    static_cast<void>(ready);
    // HDF5 prints errors by a setting of each thread. StoreError says them already.
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    Handle access = file.owned(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "set up");
    file.checked(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110),
                 "set the format of");
    // app/store/hdf5/file_lock.hpp locks; HDF5's own locks fail on disks that have none
    file.checked(H5Pset_file_locking(access.get(), false, true), "set up");
    // of each dataset, room for the chunk in use and the next
    file.checked(H5Pset_cache(access.get(), 0, 7, std::size_t{128} << 10, 1.0), "set up");
    return access;
}

/// Description of the innermost entry of the error stack.
herr_t innermost(unsigned n, const H5E_error2_t* error, void* text)
{
    if (n == 0 && error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
    return 0;
}

/// The errno in a description of HDF5's file driver, 0 if it has none.
int errno_in(const std::string& reason)
{
    constexpr std::string_view name = "errno = ";
    const std::size_t at = reason.find(name);
    return at == std::string::npos ? 0 : std::atoi(reason.c_str() + at + name.size());
}

} // namespace

Handle& Handle::operator=(Handle&& other) noexcept
{
    if (this != &other) {
        close();
        id_ = std::exchange(other.id_, -1);
        close_ = other.close_;
    }
    return *this;
}

void File::fail(const std::string& what) const
{
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, innermost, &reason);
    if (const int error = errno_in(reason); error != 0)
        disk_error(is_new ? "write" : "read", path, error);
    if (reason.empty()) reason = "not as it should be";
    if (!is_new) damaged(path, "cannot " + what + " it: " + reason);
    throw StoreError("cannot " + what + " '" + path.string() + "': " + reason);
}

Handle File::owned(hid_t opened, herr_t (*close)(hid_t), const std::string& what) const
{
    if (opened < 0) fail(what);
    return {opened, close};
}

File open_file(const fs::path& path)
{
    File file{path, false, {}};
    const Handle access = access_of(file);
    file.id = file.owned(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose, "open");
    return file;
}

File create_file(const fs::path& path)
{
    File file{path, true, {}};
    const Handle access = access_of(file);
    const Handle creation = file.owned(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "set up");
    file.checked(H5Pset_obj_track_times(creation.get(), false), "set up");
    file.id = file.owned(H5Fcreate(path.c_str(), H5F_ACC_EXCL, creation.get(), access.get()),
                         H5Fclose, "create");
    return file;
}

void close_file(File file)
{
    file.checked(H5Fflush(file.id.get(), H5F_SCOPE_GLOBAL), "write");
    file.checked(file.id.close(), "close");
}

Handle text_type(const File& file, std::size_t bytes)
{
    Handle type = file.owned(H5Tcopy(H5T_C_S1), H5Tclose, "make a text for");
    file.checked(H5Tset_size(type.get(), std::max<std::size_t>(1, bytes)), "make a text for");
    file.checked(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "make a text for");
    file.checked(H5Tset_cset(type.get(), H5T_CSET_UTF8), "make a text for");
    return type;
}

bool is_fixed_text(hid_t type)
{
    return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
}

Handle opened_object(const File& file, const std::string& name)
{
    for (std::size_t end = name.find('/', 1); name.size() > 1; end = name.find('/', end + 1)) {
        const std::string part = name.substr(0, end);
        H5L_info_t link;
        file.checked(H5Lget_info(file.id.get(), part.c_str(), &link, H5P_DEFAULT),
                     "find " + name + " in");
        if (link.type != H5L_TYPE_HARD)
            damaged(file.path, part + " is a link to somewhere else");
        if (end == std::string::npos) break;
    }
    return file.owned(H5Oopen(file.id.get(), name.c_str(), H5P_DEFAULT), H5Oclose,
                      "find " + name + " in");
}

void make_group(const File& file, const std::string& name)
{
    // Without times: the same walls make the same bytes whenever they are written.
    const Handle creation = file.owned(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "set up");
    file.checked(H5Pset_obj_track_times(creation.get(), false), "set up");
    static_cast<void>(file.owned(
        H5Gcreate2(file.id.get(), name.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
        H5Gclose, "add a group to"));
}

namespace {

void put_value(const File& file, const std::string& object, const std::string& name, hid_t type,
               const void* value)
{
    const Handle space = file.owned(H5Screate(H5S_SCALAR), H5Sclose, "add an attribute to");
    const Handle attribute =
        file.owned(H5Acreate_by_name(file.id.get(), object.c_str(), name.c_str(), type,
                                     space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose, "add an attribute to");
    file.checked(H5Awrite(attribute.get(), type, value), "write");
}

constexpr std::size_t kMostAttributeBytes = 64 << 10; ///< of a text

/// An attribute that holds one value, and how messages name it.
struct OneValue {
    Handle attribute, type;
    std::string name;
};

/// H5Aread writes as many values as the file has: nothing is read before their number is known
/// to be one.
OneValue one_value(const File& file, const std::string& object, const std::string& name)
{
    const std::string what = "the attribute " + name + " of " + object;
    const Handle owner = opened_object(file, object);
    OneValue v{file.owned(H5Aopen(owner.get(), name.c_str(), H5P_DEFAULT), H5Aclose,
                          "find " + what + " in"),
               {},
               what};
    v.type = file.owned(H5Aget_type(v.attribute.get()), H5Tclose, "read " + what + " of");
    const Handle space =
        file.owned(H5Aget_space(v.attribute.get()), H5Sclose, "read " + what + " of");
    if (H5Sget_simple_extent_type(space.get()) != H5S_SCALAR)
        damaged(file.path, what + " is not one value");
    return v;
}

} // namespace

void put_attribute(const File& file, const std::string& object, const std::string& name,
                   const std::string& text)
{
    put_value(file, object, name, text_type(file, text.size()).get(), text.c_str());
}

void put_attribute(const File& file, const std::string& object, const std::string& name,
                   std::uint64_t number)
{
    put_value(file, object, name, H5T_STD_U64LE, &number);
}

std::string text_attribute(const File& file, const std::string& object, const std::string& name)
{
    const OneValue v = one_value(file, object, name);
    if (!is_fixed_text(v.type.get())) damaged(file.path, v.name + " is not a text");
    std::string text(H5Tget_size(v.type.get()), '\0');
    if (text.size() > kMostAttributeBytes)
        damaged(file.path, v.name + " is longer than 64 KiB");
    const Handle type = text_type(file, text.size());
    file.checked(H5Aread(v.attribute.get(), type.get(), text.data()), "read " + v.name + " in");
    text.resize(std::min(text.find('\0'), text.size()));
    return text;
}

std::uint64_t number_attribute(const File& file, const std::string& object,
                               const std::string& name, std::uint64_t most)
{
    const OneValue v = one_value(file, object, name);
    if (H5Tequal(v.type.get(), H5T_STD_U64LE) <= 0)
        damaged(file.path, v.name + " is not an unsigned number of 64 bits");
    std::uint64_t number = 0;
    file.checked(H5Aread(v.attribute.get(), H5T_NATIVE_UINT64, &number),
                 "read " + v.name + " in");
    if (number > most)
        damaged(file.path, v.name + " is " + std::to_string(number) + ", more than " +
                               std::to_string(most));
    return number;
}

} // namespace app::hdf5
