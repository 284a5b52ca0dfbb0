#include "app/store/store.hpp"

#include "tests/app/store/memory_folder.hpp"
#include "tests/app/store/store_scene.hpp"
#include "tests/scenes/same_results.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace fs = std::filesystem;
using app::Store;
using app::StoreReader;
using Catch::Matchers::Contains;
using scenes::check_rows;
using scenes::store_head;
using scenes::store_row;
using scenes::store_rows;

TEST_CASE("store: walls come back bit for bit from the parts, from the file, and from both",
          "[app][store]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    Store store(file, store_head(50));
    CHECK(check_rows(file) == 0);
    store.append(store_rows(0, 20));
    CHECK(check_rows(file) == 60);
    store.compact();
    CHECK(!fs::exists(app::parts_of(file)));
    CHECK(check_rows(file) == 60);
    store.append(store_rows(20, 50));
    CHECK(check_rows(file) == 150);
    store.compact();
    CHECK(check_rows(file) == 150);
    CHECK(store.size() == 150);
    CHECK(fs::exists(app::lock_of(file)));
}

TEST_CASE("store: a row is found by its key, a wall that is not there is none", "[app][store]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    Store store(file, store_head(5));
    store.append(store_rows(1, 4));
    store.compact();
    StoreReader reader(file);
    REQUIRE(reader.row(app::WallKey{2, 3}));
    CHECK(scenes::same_results(*reader.row(app::WallKey{2, 3}), store_row({2, 3})));
    CHECK(!reader.row(app::WallKey{2, 0}));
    CHECK(!reader.row(app::WallKey{2, 4}));
    CHECK(store.status({0, 3}) == 5); // failed: 3 % 7
    CHECK(store.status({0, 2}) == app::kWallOk);
    CHECK(!store.status({0, 4}));
    CHECK(app::missing_walls(reader.head(), reader.statuses()) ==
          std::vector<app::WallKey>{{0, 0}, {0, 4}, {1, 0}, {1, 4}, {2, 0}, {2, 4}});
}

TEST_CASE("store: the head comes back whole, from the file and from a part", "[app][store]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    app::StoreHead head = store_head(5);
    head.shard = 1;
    head.shards = 3;
    head.single_precision_curves = GENERATE(false, true);
    head.configuration = GENERATE("a = 1\n\n", "", "one line");
    head.counts.clear();
    const auto check = [&](const app::StoreHead& read) { CHECK(read == head); };
    Store store(file, head);
    check(app::read_head(file));
    app::WallRow row = store_row({0, 0});
    row.counts.clear();
    store.append({&row, 1});
    check(app::read_head(file));
}

TEST_CASE("store: a study without curves, columns, levels or walls is stored too",
          "[app][store]")
{
    const scenes::MemoryFolder folder;
    Store(folder.path / "none.h5", {}).compact();
    CHECK(StoreReader(folder.path / "none.h5").statuses().empty());

    app::StoreHead head;
    head.levels = {{0.0, 2}};
    Store store(folder.path / "bare.h5", head);
    store.append(std::vector<app::WallRow>(1));
    store.compact();
    StoreReader reader(folder.path / "bare.h5");
    REQUIRE(reader.statuses().size() == 1);
    CHECK(scenes::same_results(reader.row(std::size_t{0}), app::WallRow{}));
}

TEST_CASE("store: curves in single precision are the same before and after compaction",
          "[app][store]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    app::StoreHead head = store_head(2);
    head.single_precision_curves = true;
    Store store(file, head);
    store.append(store_rows(0, 1));
    const app::WallRow before = *StoreReader(file).row(app::WallKey{1, 0});
    store.compact();
    const app::WallRow after = *StoreReader(file).row(app::WallKey{1, 0});
    CHECK(scenes::same_results(before, after));
    const app::WallRow given = store_row({1, 0});
    CHECK(before.curve.force.size() == given.curve.force.size());
    CHECK(before.curve.force[0] ==
          static_cast<double>(static_cast<float>(given.curve.force[0])));
    CHECK(before.inputs == given.inputs);
}

TEST_CASE("store: single precision refuses what would become infinite", "[app][store]")
{
    const scenes::MemoryFolder folder;
    app::StoreHead head = store_head(2);
    head.single_precision_curves = true;
    Store store(folder.path / "a.h5", head);
    app::WallRow row = store_row({0, 0});
    row.curve.force[0] = 1e39;
    CHECK_THROWS_AS(store.append({&row, 1}), std::invalid_argument);
}

TEST_CASE("store: rows that do not fit are refused and nothing of their batch is stored",
          "[app][store]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    Store store(file, store_head(9));
    std::vector<app::WallRow> rows = store_rows(0, 1);
    app::WallRow& bad = rows.back();
    SECTION("inputs") { bad.inputs.pop_back(); }
    SECTION("responses") { bad.responses.push_back(0.0); }
    SECTION("counts") { bad.counts.clear(); }
    SECTION("cost") { bad.cost.clear(); }
    SECTION("length of a column") { bad.curve.force.pop_back(); }
    SECTION("level") { bad.key.level = 3; }
    SECTION("sample") { bad.key.sample = 9; }
    SECTION("twice in a batch") { bad.key = rows.front().key; }
    SECTION("NUL in the reason") { bad.reason = std::string("a\0b", 3); }
    CHECK_THROWS_AS(store.append(rows), std::invalid_argument);
    CHECK(store.size() == 0);
    CHECK(check_rows(file) == 0);
}

TEST_CASE("store: a wall that is ok is not replaced, a failed one is", "[app][store]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    Store store(file, store_head(9));
    store.append(store_rows(0, 9));
    if (GENERATE(false, true)) store.compact();
    app::WallRow ok = store_row({1, 2});
    CHECK_THROWS_WITH(store.append({&ok, 1}), Contains("stored already"));
    app::WallRow again = store_row({0, 2});
    again.key = {0, 3}; // had failed
    store.append({&again, 1});
    CHECK(store.status({0, 3}) == app::kWallOk);
    for (int pass = 0; pass < 2; ++pass, store.compact()) {
        StoreReader reader(file);
        CHECK(reader.statuses().size() == 27);
        CHECK(scenes::same_results(*reader.row(app::WallKey{0, 3}), again));
    }
}

TEST_CASE("store: a long reason is cut between characters", "[app][store]")
{
    const scenes::MemoryFolder folder;
    Store store(folder.path / "a.h5", store_head(1));
    app::WallRow row = store_row({0, 0});
    row.reason = "x";
    while (row.reason.size() < 600) row.reason += "\xc3\xa9";
    store.append({&row, 1});
    const std::string reason = StoreReader(folder.path / "a.h5").row(std::size_t{0}).reason;
    CHECK(reason == row.reason.substr(0, 499));
}

TEST_CASE("store: many parts are merged by append() itself, each wall a few times only",
          "[app][store]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    app::StoreOptions options;
    options.most_parts = 5;
    int compactions = 0;
    options.reached = [&](app::StoreStage stage) {
        compactions += stage == app::StoreStage::parts_removed ? 1 : 0;
    };
    Store store(file, store_head(200), options);
    for (std::uint32_t i = 0; i < 200; ++i) {
        store.append(store_rows(i, i + 1));
        REQUIRE(app::part_numbers(file).size() < 5);
    }
    CHECK(check_rows(file) == 600);
    // 50 times 5 parts were merged: into one part unless they were a quarter of the file
    CHECK(compactions >= 5);
    CHECK(compactions <= 25);
}

TEST_CASE("store: a file that another program repacked or added to is read and gone on with",
          "[app][store]")
{
    if (std::system("/usr/bin/python3 -c 'import h5py' 2>/dev/null") != 0) {
        WARN("skipped: python3-h5py is not installed");
        return;
    }
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    {
        Store store(file, store_head(9));
        store.append(store_rows(0, 6));
        store.compact();
    }
    const std::string change = GENERATE(
        "f = h5py.File('a.h5', 'r+'); f.attrs['note'] = 'seen'; f['walls'].attrs['x'] = 1.5",
        "f = h5py.File('a.h5', 'r+'); f['notes'] = [1, 2, 3]",
        // as h5repack: all objects anew, in the format of any version, chunks or none
        "g = h5py.File('a.h5', 'r'); f = h5py.File('b.h5', 'w'); f.attrs.update(g.attrs); "
        "[g.copy(k, f) for k in g]; f.close(); import os; os.rename('b.h5', 'a.h5')");
    const std::string command = "cd '" + folder.path.string() +
                                "' && /usr/bin/python3 -c \"import h5py; " + change + "\"";
    INFO(command);
    REQUIRE(std::system(command.c_str()) == 0);
    CHECK(app::read_head(file) == store_head(9));
    CHECK(check_rows(file) == 18);
    Store store(file, store_head(9));
    store.append(store_rows(6, 9));
    store.compact();
    CHECK(check_rows(file) == 27);
}

TEST_CASE("store: a study for h5py, and the curve of its row 17", "[app][store][h5py]")
{
    const scenes::TemporaryFolder own;
    const char* given = std::getenv("DRYSTONE_STORE_FOLDER");
    const fs::path folder = given != nullptr ? fs::path(given) : own.path;
    {
        Store store(folder / "paper.h5", store_head(30));
        store.append(store_rows(1, 30));
        store.compact();
    }
    const app::WallRow row = StoreReader(folder / "paper.h5").row(std::size_t{17});
    REQUIRE(row.curve.force.size() > 10);
    std::ofstream out(folder / "row17.txt");
    out.precision(17);
    for (std::size_t k = 0; k < row.curve.force.size(); ++k)
        out << row.curve.displacement[k] << ' ' << row.curve.force[k] << '\n';
    CHECK(out.good());
}
