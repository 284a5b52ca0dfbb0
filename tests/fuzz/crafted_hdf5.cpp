#include "fuzz/crafted_hdf5.hpp"

#include "app/store/hdf5/hdf5_file.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace crafted {

namespace {

namespace fs = std::filesystem;
using app::hdf5::Handle;

hid_t good(hid_t id)
{
    if (id < 0) throw std::runtime_error("HDF5 refuses to craft this");
    return id;
}

Handle text_of(std::size_t bytes)
{
    Handle type(good(H5Tcopy(H5T_C_S1)), H5Tclose);
    H5Tset_size(type.get(), bytes);
    H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
    H5Tset_cset(type.get(), H5T_CSET_UTF8);
    return type;
}

Handle space_of(const std::vector<hsize_t>& sizes, bool growing = false)
{
    if (sizes.empty()) return {good(H5Screate(H5S_SCALAR)), H5Sclose};
    const std::vector<hsize_t> most(sizes.size(), H5S_UNLIMITED);
    return {good(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(),
                                  growing ? most.data() : nullptr)),
            H5Sclose};
}

/// A dataset as it lies in the file.
struct Stored {
    std::vector<hsize_t> sizes;
    Handle type;
    std::vector<char> bytes;
};

Stored stored(hid_t file, const std::string& name)
{
    const Handle data(good(H5Dopen2(file, name.c_str(), H5P_DEFAULT)), H5Dclose);
    const Handle space(good(H5Dget_space(data.get())), H5Sclose);
    Stored s{{}, Handle(good(H5Dget_type(data.get())), H5Tclose), {}};
    s.sizes.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space.get())));
    H5Sget_simple_extent_dims(space.get(), s.sizes.data(), nullptr);
    constexpr std::size_t kMostBytes = 64 << 20; // an earlier change may have declared more
    const auto points = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
    const std::size_t bytes = H5Tget_size(s.type.get());
    if (points <= kMostBytes / bytes) s.bytes.resize(points * bytes);
    if (!s.bytes.empty())
        good(H5Dread(data.get(), s.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, s.bytes.data()));
    return s;
}

struct Text {
    std::string name, value;
};

std::vector<Text> texts_of(hid_t file, const std::string& name)
{
    std::vector<Text> texts;
    for (const char* const key : {"unit", "meaning"}) {
        if (H5Aexists_by_name(file, name.c_str(), key, H5P_DEFAULT) <= 0) continue;
        const Handle a(good(H5Aopen_by_name(file, name.c_str(), key, H5P_DEFAULT, H5P_DEFAULT)),
                       H5Aclose);
        const Handle type(good(H5Aget_type(a.get())), H5Tclose);
        const Handle space(good(H5Aget_space(a.get())), H5Sclose);
        if (H5Sget_simple_extent_npoints(space.get()) != 1) continue; // of an earlier change
        std::string value(H5Tget_size(type.get()), '\0');
        good(H5Aread(a.get(), type.get(), value.data()));
        texts.push_back({key, value});
    }
    return texts;
}

void write_attribute(hid_t object, const std::string& name, hid_t type, hid_t space,
                     const std::vector<char>& values)
{
    const Handle made(
        good(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT)),
        H5Aclose);
    if (!values.empty()) good(H5Awrite(made.get(), type, values.data()));
}

/// Names of the datasets and of the attributes that the program reads.
struct Places {
    std::vector<std::string> datasets;
    std::vector<Text> attributes; ///< object and name
};

herr_t note_object(hid_t group, const char* name, const H5O_info_t* about, void* to)
{
    constexpr const char* kRead[] = {"layout",  "seed", "shard",  "shards",
                                     "columns", "unit", "meaning"};
    auto& places = *static_cast<Places*>(to);
    const std::string object = std::strcmp(name, ".") == 0 ? "/" : "/" + std::string(name);
    const bool of_study = object.find('/', 1) != std::string::npos ||
                          object == "/configuration" || object == "/identity" ||
                          object == "/design_sizes";
    if (about->type == H5O_TYPE_DATASET && of_study) places.datasets.push_back(object);
    for (const char* const key : kRead)
        if (H5Aexists_by_name(group, name, key, H5P_DEFAULT) > 0)
            places.attributes.push_back({object, key});
    return 0;
}

Places places_in(hid_t file)
{
    Places places;
    good(H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, note_object, &places));
    return places;
}

template <class T> const T& any_of(const std::vector<T>& all, uq::Stream& random)
{
    return all.at(random.below(all.size()));
}

/// A type that nobody expects.
Handle odd_type(uq::Stream& random)
{
    const hid_t plain[] = {H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_STD_I32LE, H5T_STD_I64LE,
                           H5T_STD_U8LE,   H5T_STD_U32BE,  H5T_STD_U64LE, H5T_IEEE_F64BE};
    const hsize_t four = 4;
    switch (random.below(6)) {
    case 0:
        return text_of(1 + random.below(5000));
    case 1: {
        Handle type = text_of(1);
        H5Tset_size(type.get(), H5T_VARIABLE);
        return type;
    }
    case 2:
        return {good(H5Tarray_create2(H5T_IEEE_F64LE, 1, &four)), H5Tclose};
    case 3: {
        Handle type(good(H5Tcreate(H5T_COMPOUND, 16)), H5Tclose);
        H5Tinsert(type.get(), "a", 0, H5T_IEEE_F64LE);
        return type;
    }
    case 4:
        return {good(H5Tcreate(H5T_OPAQUE, 1 + random.below(100))), H5Tclose};
    default:
        return {good(H5Tcopy(plain[random.below(std::size(plain))])), H5Tclose};
    }
}

/// Bytes of a few values changed: to random bits, NaN, the largest number, zero, or those of
/// another.
void change_values(Stored& s, uq::Stream& random)
{
    const std::size_t size = H5Tget_size(s.type.get());
    if (s.bytes.size() < size) return;
    for (std::uint64_t k = 0, n = 1 + random.below(4); k < n; ++k) {
        char* const at = s.bytes.data() + size * random.below(s.bytes.size() / size);
        const double odd[] = {std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity(), 1e308, -1.0, 0.0};
        switch (random.below(4)) {
        case 0:
            at[random.below(size)] ^= static_cast<char>(1u << random.below(8));
            break;
        case 1:
            std::memset(at, random.below(2) == 0 ? 0 : 0xff, size);
            break;
        case 2:
            std::memcpy(at, s.bytes.data() + size * random.below(s.bytes.size() / size), size);
            break;
        default:
            std::memcpy(at, &odd[random.below(std::size(odd))], std::min(size, sizeof(double)));
        }
    }
}

std::vector<hsize_t> odd_sizes(const Stored& s, uq::Stream& random)
{
    const hsize_t rows = s.sizes.empty() ? 1 : s.sizes[0];
    const std::vector<std::vector<hsize_t>> all = {
        {},           {0},       {1},        {rows + 1},  {rows > 0 ? rows - 1 : 5},
        {2 * rows},   {rows, 1}, {1, rows},  {rows, 0},   {0, 7},
        {rows, 1, 1}, {rows, 2}, {rows + 7}, {rows, 5000}};
    return any_of(all, random);
}

/// Rows that are declared and not there, or chunks of any size.
NewDataset huge(uq::Stream& random)
{
    const hsize_t rows = hsize_t{1} << (16 + random.below(44));
    if (random.below(3) == 0) return {.sizes = {rows}};
    const hsize_t chunk = hsize_t{1} << (10 + random.below(18));
    return {.sizes = {random.below(2) == 0 ? rows : 30},
            .chunk = {chunk},
            .creation = [](hid_t list) { H5Pset_deflate(list, 1); }};
}

NewDataset elsewhere(const Stored& s, const fs::path& file, uq::Stream& random)
{
    hsize_t bytes = s.bytes.size() + 8;
    const std::vector<hsize_t> sizes = s.sizes;
    if (random.below(2) == 0)
        return {.sizes = sizes, .creation = [file, bytes](hid_t list) {
                    H5Pset_external(list, file.c_str(), 0, bytes);
                }};
    return {.sizes = sizes, .creation = [file, sizes](hid_t list) {
                const Handle space = space_of(sizes);
                H5Pset_virtual(list, space.get(), file.c_str(), "/walls/status", space.get());
            }};
}

/// A filter of HDF5 that the program does not use, or one that nobody has.
NewDataset filtered(const Stored& s, uq::Stream& random)
{
    const std::uint64_t kind = random.below(3);
    return {.sizes = s.sizes,
            .chunk = {std::max<hsize_t>(1, s.sizes.empty() ? 1 : s.sizes[0])},
            .values = s.bytes,
            .creation = [kind](hid_t list) {
                if (kind == 0) H5Pset_scaleoffset(list, H5Z_SO_INT, 0);
                if (kind == 1) H5Pset_nbit(list);
                if (kind == 2) H5Pset_filter(list, 32015, H5Z_FLAG_OPTIONAL, 0, nullptr);
            }};
}

std::string change_dataset(hid_t file, const fs::path& path, const Places& places,
                           uq::Stream& random)
{
    const std::string name = any_of(places.datasets, random);
    Stored s = stored(file, name);
    switch (random.below(12)) {
    case 0:
    case 1: {
        change_values(s, random);
        const Handle data(good(H5Dopen2(file, name.c_str(), H5P_DEFAULT)), H5Dclose);
        if (!s.bytes.empty())
            good(H5Dwrite(data.get(), s.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                          s.bytes.data()));
        return "values of " + name;
    }
    case 2:
    case 3:
        replace(file, name, {.sizes = odd_sizes(s, random), .values = s.bytes});
        return "shape of " + name;
    case 4: {
        const Handle type = odd_type(random);
        replace(file, name, {.sizes = s.sizes, .type = type.get()});
        return "type of " + name;
    }
    case 5:
        replace(file, name, huge(random));
        return "size of " + name;
    case 6:
        replace(file, name, elsewhere(s, path, random));
        return "storage of " + name;
    case 7:
        replace(file, name, filtered(s, random));
        return "filter of " + name;
    case 8: {
        const std::string targets[] = {name, "/nowhere", "/configuration", "/walls"};
        link_to(file, name, targets[random.below(4)]);
        return "soft link " + name;
    }
    case 9:
        link_to(file, name, random.below(2) == 0 ? name : "/walls/status",
                random.below(2) == 0 ? path.string() : "/etc/passwd");
        return "external link " + name;
    case 10: {
        const std::string& other = any_of(places.datasets, random);
        if (other != name) {
            H5Ldelete(file, name.c_str(), H5P_DEFAULT);
            H5Lcreate_hard(file, other.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
        }
        return name + " as " + other;
    }
    default:
        H5Ldelete(file, name.c_str(), H5P_DEFAULT);
        if (random.below(2) == 0)
            Handle(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Gclose);
        return "no " + name;
    }
}

std::string change_attribute(hid_t file, const Places& places, uq::Stream& random)
{
    const Text place = any_of(places.attributes, random);
    const std::string what = place.value + " of " + place.name;
    const Handle before(good(H5Aopen_by_name(file, place.name.c_str(), place.value.c_str(),
                                             H5P_DEFAULT, H5P_DEFAULT)),
                        H5Aclose);
    const Handle same(good(H5Aget_type(before.get())), H5Tclose);
    const auto byte = static_cast<char>(random.below(256));
    switch (random.below(5)) {
    case 0: {
        constexpr int kMany[] = {0, 1, 2, 100, 3900};
        replace_attribute(file, place.name, place.value, same.get(),
                          kMany[random.below(std::size(kMany))], byte);
        return "number of " + what;
    }
    case 1: {
        const Handle type = odd_type(random);
        const bool pointers = H5Tis_variable_str(type.get()) > 0;
        replace_attribute(file, place.name, place.value, type.get(), -1,
                          pointers ? '\0' : byte);
        return "type of " + what;
    }
    case 2: {
        const Handle type = text_of(1 + random.below(200'000));
        replace_attribute(file, place.name, place.value, type.get(), -1, byte);
        return "text of " + what;
    }
    case 3:
        H5Adelete_by_name(file, place.name.c_str(), place.value.c_str(), H5P_DEFAULT);
        return "no " + what;
    default:
        replace_attribute(file, place.name, place.value, same.get(), -1, byte);
        return "value of " + what;
    }
}

} // namespace

void change(const fs::path& path, const std::function<void(hid_t)>& work)
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const Handle access(good(H5Pcreate(H5P_FILE_ACCESS)), H5Pclose);
    H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);
    const Handle file(good(H5Fopen(path.c_str(), H5F_ACC_RDWR, access.get())), H5Fclose);
    work(file.get());
}

void replace(hid_t file, const std::string& name, const NewDataset& by)
{
    const Stored before = stored(file, name);
    const std::vector<Text> texts = texts_of(file, name);
    const hid_t type = by.type >= 0 ? by.type : before.type.get();
    const Handle space = space_of(by.sizes, !by.chunk.empty());
    const Handle list(good(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
    if (!by.chunk.empty())
        H5Pset_chunk(list.get(), static_cast<int>(by.chunk.size()), by.chunk.data());
    if (by.creation) by.creation(list.get());
    good(H5Ldelete(file, name.c_str(), H5P_DEFAULT));
    const Handle made(good(H5Dcreate2(file, name.c_str(), type, space.get(), H5P_DEFAULT,
                                      list.get(), H5P_DEFAULT)),
                      H5Dclose);
    if (!by.values.empty()) {
        const auto points = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
        std::vector<char> values = by.values;
        values.resize(points * H5Tget_size(type));
        if (!values.empty())
            good(H5Dwrite(made.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    }
    const Handle one = space_of({});
    for (const Text& t : texts)
        write_attribute(made.get(), t.name, text_of(t.value.size()).get(), one.get(),
                        {t.value.begin(), t.value.end()});
}

void replace_attribute(hid_t file, const std::string& object, const std::string& name,
                       hid_t type, int n, char byte)
{
    const Handle owner(good(H5Oopen(file, object.c_str(), H5P_DEFAULT)), H5Oclose);
    H5Adelete(owner.get(), name.c_str());
    const std::vector<hsize_t> sizes =
        n < 0 ? std::vector<hsize_t>{} : std::vector<hsize_t>{static_cast<hsize_t>(n)};
    const Handle space = space_of(sizes);
    const std::size_t values = n < 0 ? 1 : static_cast<std::size_t>(n);
    write_attribute(owner.get(), name, type, space.get(),
                    std::vector<char>(values * H5Tget_size(type), byte));
}

void link_to(hid_t file, const std::string& name, const std::string& target,
             const std::string& other_file)
{
    good(H5Ldelete(file, name.c_str(), H5P_DEFAULT));
    if (other_file.empty())
        good(H5Lcreate_soft(target.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT));
    else
        good(H5Lcreate_external(other_file.c_str(), target.c_str(), file, name.c_str(),
                                H5P_DEFAULT, H5P_DEFAULT));
}

std::string change_anything(const fs::path& path, uq::Stream& random)
{
    std::string what;
    change(path, [&](hid_t file) {
        const Places places = places_in(file);
        try {
            what = random.below(3) == 0 ? change_attribute(file, places, random)
                                        : change_dataset(file, path, places, random);
        } catch (const std::exception& error) {
            what = error.what();
        }
    });
    return what;
}

} // namespace crafted
