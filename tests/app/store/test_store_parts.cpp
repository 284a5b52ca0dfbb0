#include "app/store/store.hpp"

#include "tests/app/store/memory_folder.hpp"
#include "tests/app/store/store_scene.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;
using app::Store;
using app::StoreError;
using app::StoreReader;
using Catch::Matchers::Contains;
using scenes::check_rows;
using scenes::read_text;
using scenes::store_head;
using scenes::store_rows;

namespace {

void write_text(const fs::path& path, const std::string& text)
{
    std::ofstream(path, std::ios::binary) << text;
}

/// A store with one sample in its file and one in each of two parts (of 3 walls each).
void make_study(const fs::path& file)
{
    Store store(file, store_head(20));
    store.append(store_rows(0, 1, 2));
    store.compact();
    store.append(store_rows(1, 2, 2));
    store.append(store_rows(2, 3, 2));
}

std::string refusal(const fs::path& file)
{
    try {
        StoreReader reader(file);
    } catch (const StoreError& error) {
        return error.what();
    }
    return "not refused";
}

} // namespace

TEST_CASE("parts: one that is damaged is named; without it the study goes on",
          "[app][store_parts]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    make_study(file);
    const fs::path part = app::part_of(file, 1);
    std::string bytes = read_text(part);
    SECTION("flipped in the head") { bytes[100] ^= 1; }
    SECTION("cut") { bytes.resize(bytes.size() / 2); }
    SECTION("empty") { bytes.clear(); }
    SECTION("text") { bytes = "some text"; }
    write_text(part, bytes);
    CHECK_THAT(refusal(file),
               Contains(part.string()) && Contains("remove it and run the same command again"));
    CHECK_THROWS_AS(Store(file, store_head(20)), StoreError);
    CHECK(read_text(part) == bytes);
    fs::remove(part);
    CHECK(check_rows(file, 2) == 6);
    Store store(file, store_head(20));
    store.append(store_rows(1, 2, 2));
    store.compact();
    CHECK(check_rows(file, 2) == 9);
}

TEST_CASE("parts: a new file that a kill left half written is passed over and removed",
          "[app][store_parts]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    make_study(file);
    const fs::path left = app::part_of(file, 3).string() + ".tmp";
    write_text(left, read_text(app::part_of(file, 2)).substr(0, 2000));
    CHECK(check_rows(file, 2) == 9);
    CHECK(fs::exists(left)); // a reader changes nothing
    Store store(file, store_head(20));
    CHECK(!fs::exists(left));
    store.compact();
    CHECK(!fs::exists(app::parts_of(file)));
    CHECK(check_rows(file, 2) == 9);
}

TEST_CASE("parts: those of another study, and parts without their file, are refused",
          "[app][store_parts]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    make_study(file);
    SECTION("of another study")
    {
        app::StoreHead other = store_head(20);
        other.identity = "length = 2\n";
        Store store(folder.path / "b.h5", other);
        store.append(store_rows(0, 1));
        fs::copy_file(app::part_of(folder.path / "b.h5", 1), app::part_of(file, 7));
        CHECK_THAT(refusal(file),
                   Contains("is not of the study beside it") && Contains("+ length = 2"));
    }
    SECTION("without its file")
    {
        fs::remove(file);
        CHECK_THAT(refusal(file), Contains("no such file; restore it"));
        CHECK_THROWS_WITH(Store(file, store_head(20)), Contains("without its"));
    }
    CHECK_THROWS_AS(Store(file, store_head(20)), StoreError);
}

TEST_CASE("parts: what others put into their folder is left there", "[app][store_parts]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    make_study(file);
    const fs::path note = app::parts_of(file) / "notes.txt";
    write_text(note, "mine");
    Store store(file, store_head(20));
    store.compact();
    CHECK(read_text(note) == "mine");
    store.append(store_rows(3, 4, 2));
    CHECK(check_rows(file, 2) == 12);
}

TEST_CASE("parts: the last of several that have one wall counts", "[app][store_parts]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    app::StoreOptions options;
    options.most_parts = GENERATE(2u, 3u, 100u);
    Store store(file, store_head(20), options);
    app::WallRow row = scenes::store_row({0, 1});
    for (const std::int32_t status : {3, 2, 1}) {
        row.status = status;
        store.append({&row, 1});
    }
    CHECK(StoreReader(file).statuses().size() == 1);
    CHECK(StoreReader(file).row(std::size_t{0}).status == 1);
}
