#include "app/store/merge.hpp"
#include "app/store/store.hpp"

#include "fuzz/crafted_hdf5.hpp"
#include "tests/app/store/memory_folder.hpp"
#include "tests/app/store/store_scene.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>

namespace fs = std::filesystem;
using app::BadStoredStudy;
using app::Store;
using app::StoreReader;
using Catch::Matchers::Contains;
using scenes::store_head;
using scenes::store_rows;

namespace {

constexpr std::uint32_t kSamples = 4;

fs::path made_study(const fs::path& folder)
{
    const fs::path file = folder / "stranger.h5";
    Store store(file, store_head(kSamples));
    store.append(store_rows(0, kSamples, 6));
    store.compact();
    return file;
}

struct Craft {
    std::string what, said;
    std::function<void(hid_t)> change;
};

hid_t wide_text() // one type for the whole test program
{
    static const hid_t type = [] {
        const hid_t made = H5Tcopy(H5T_C_S1);
        H5Tset_size(made, 16);
        return made;
    }();
    return type;
}

hid_t text_of_size(std::size_t bytes)
{
    const hid_t made = H5Tcopy(H5T_C_S1);
    H5Tset_size(made, bytes);
    return made;
}

Craft attribute(const std::string& object, const std::string& name, hid_t type, int n,
                const std::string& said)
{
    return {name + " of " + object, said,
            [=](hid_t file) { crafted::replace_attribute(file, object, name, type, n); }};
}

Craft dataset(const std::string& name, const std::string& said, crafted::NewDataset by)
{
    return {name, said, [=](hid_t file) { crafted::replace(file, name, by); }};
}

/// As in the report of the attack on the program: arrays in place of one number or one text.
std::vector<Craft> attributes()
{
    std::vector<Craft> all;
    for (const char* const name : {"layout", "seed", "shard", "shards"}) {
        all.push_back(attribute("/", name, H5T_STD_U64LE, 1000, "is not one value"));
        all.push_back(attribute("/", name, H5T_STD_U64LE, 0, "is not one value"));
        all.push_back(attribute("/", name, H5T_STD_I64LE, -1, "is not an unsigned number"));
        all.push_back(attribute("/", name, wide_text(), -1, "is not an unsigned number"));
    }
    all.push_back(attribute("/", "shard", H5T_STD_U64LE, -1, "more than 4294967295"));
    all.push_back(attribute("/responses", "columns", wide_text(), 3900, "is not one value"));
    all.push_back(
        attribute("/responses/peak_force", "unit", wide_text(), 3900, "is not one value"));
    all.push_back(
        attribute("/responses/peak_force", "meaning", H5T_STD_U64LE, -1, "is not a text"));
    all.push_back(
        attribute("/counts", "columns", text_of_size(65 << 10), -1, "longer than 64 KiB"));
    return all;
}

std::vector<Craft> datasets()
{
    const auto deflated = [](hid_t list) { H5Pset_deflate(list, 1); };
    return {
        dataset("/design_sizes", "design_sizes does not end with", {.sizes = {0}}),
        dataset("/design_sizes", "design_sizes does not end with",
                {.sizes = {1}, .values = {'\xff', '\xff', '\xff', '\xff'}}),
        dataset("/levels/samples", "100000000 are possible",
                {.sizes = {3}, .values = std::vector<char>(12, '\xff')}),
        dataset("/curves/force", "more than the file can hold",
                {.sizes = {hsize_t{1} << 40}, .chunk = {1 << 20}, .creation = deflated}),
        dataset("/walls/status", "more than the file can hold", {.sizes = {hsize_t{1} << 31}}),
        dataset("/levels/samples", "chunks of more than 64 MiB",
                {.sizes = {3}, .chunk = {1 << 26}, .values = {0}, .creation = deflated}),
        dataset("/curves/force", "is not a list", {.sizes = {}}),
        dataset("/curves/force", "is not a list", {.sizes = {100, 0}}),
        dataset("/walls/inputs", "is not a table", {.sizes = {12}}),
        dataset("/curves/force", "its values in another file",
                {.sizes = {100},
                 .creation = [](hid_t list) { H5Pset_external(list, "/etc/passwd", 0, 800); }}),
        dataset("/curves/force", "its values in another file",
                {.sizes = {100},
                 .creation =
                     [](hid_t list) {
                         const hsize_t n = 100;
                         const hid_t space = H5Screate_simple(1, &n, nullptr);
                         H5Pset_virtual(list, space, "/etc/passwd", "/x", space);
                         H5Sclose(space);
                     }}),
        dataset(
            "/walls/level", "has a filter that this program does not use (5)",
            {.sizes = {12}, .chunk = {12}, .creation = [](hid_t list) { H5Pset_nbit(list); }}),
        dataset("/walls/level", "values of another type",
                {.sizes = {12}, .type = H5T_STD_I64LE, .values = {0}}),
        dataset("/configuration", "values of another type",
                {.sizes = {1}, .type = H5T_STD_I64LE, .values = {0}}),
        dataset("/walls/input_unit", "texts of more than 4096 bytes",
                {.sizes = {4}, .type = text_of_size(4097), .values = {'m'}}),
        {"soft link", "is a link to somewhere else",
         [](hid_t file) { crafted::link_to(file, "/curves/force", "/curves/displacement"); }},
        {"soft link of a group", "/curves is a link to somewhere else",
         [](hid_t file) { crafted::link_to(file, "/curves", "/curves"); }},
        {"external link", "is a link to somewhere else",
         [](hid_t file) { crafted::link_to(file, "/curves/force", "/x", "/etc/passwd"); }},
        {"a group", "is no dataset", [](hid_t file) {
             H5Ldelete(file, "/identity", H5P_DEFAULT);
             H5Gclose(H5Gcreate2(file, "/identity", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
         }}};
}

/// Puts a number in place of the fifth of a dataset.
std::function<void(hid_t)> with_number(const std::string& name, double value)
{
    return [=](hid_t file) {
        const hid_t data = H5Dopen2(file, name.c_str(), H5P_DEFAULT),
                    space = H5Dget_space(data);
        const hsize_t at[] = {name == "/walls/inputs" ? hsize_t{1} : hsize_t{4}, 0},
                      one[] = {1, 1};
        H5Sselect_hyperslab(space, H5S_SELECT_SET, at, nullptr, one, nullptr);
        const hid_t memory = H5Screate_simple(1, one, nullptr);
        CHECK(H5Dwrite(data, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, &value) >= 0);
        H5Sclose(memory);
        H5Sclose(space);
        H5Dclose(data);
    };
}

} // namespace

TEST_CASE(
    "strangers: whatever stands in place of an attribute or a dataset is refused with the "
    "file's name before it is read",
    "[app][store_strangers]")
{
    const scenes::MemoryFolder folder;
    const fs::path whole = made_study(folder.path), file = folder.path / "crafted.h5";
    std::vector<Craft> all = attributes();
    for (Craft& c : datasets()) all.push_back(std::move(c));
    for (const Craft& c : all) {
        INFO(c.what << ": " << c.said);
        fs::copy_file(whole, file, fs::copy_options::overwrite_existing);
        crafted::change(file, c.change);
        const auto read = [&] {
            StoreReader reader(file);
            reader.for_each_row([](const app::WallRow&) {});
        };
        CHECK_THROWS_AS(read(), BadStoredStudy);
        CHECK_THROWS_WITH(read(), Contains(file.string()) && Contains(c.said));
    }
}

TEST_CASE("strangers: a number of a curve or an input that is none is refused with file, wall "
          "and place",
          "[app][store_strangers]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = made_study(folder.path), out = folder.path / "all.h5";
    const double value = GENERATE(std::numeric_limits<double>::quiet_NaN(),
                                  -std::numeric_limits<double>::infinity(), 1e308);
    const auto [name, said] = GENERATE(table<std::string, std::string>(
        {{"/curves/force", "wall (level 0, sample 0): force 5 is not a finite number"},
         {"/curves/displacement", "wall (level 0, sample 0): displacement 5 is not a finite"},
         {"/walls/inputs", "wall (level 0, sample 1): input 1 is not a finite number"}}));
    crafted::change(file, with_number(name, value));
    CHECK_THROWS_WITH(StoreReader(file).for_each_row([](const app::WallRow&) {}),
                      Contains(file.string()) && Contains(said));
    CHECK_THROWS_AS(app::merge(out, {file}), BadStoredStudy);
    CHECK(!fs::exists(out));
    CHECK(!fs::exists(out.string() + ".tmp"));
}

TEST_CASE("strangers: a wall that is no wall is not stored either", "[app][store_strangers]")
{
    const scenes::MemoryFolder folder;
    Store store(folder.path / "a.h5", store_head(kSamples));
    app::WallRow row = scenes::store_row({0, 0});
    SECTION("input") { row.inputs[2] = std::numeric_limits<double>::quiet_NaN(); }
    SECTION("curve") { row.curve.force[2] = std::numeric_limits<double>::infinity(); }
    CHECK_THROWS_WITH(store.append({&row, 1}), Contains("3 is not a finite number"));
    row.inputs[2] = 0.0;
    row.status = 5; // a wall that failed may have ended with anything
    row.reason = "not finite";
    CHECK_NOTHROW(store.append({&row, 1}));
}
