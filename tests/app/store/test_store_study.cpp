#include "app/store/store.hpp"

#include "tests/app/store/memory_folder.hpp"
#include "tests/app/store/store_scene.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <hdf5.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace fs = std::filesystem;
using app::Store;
using app::StoreError;
using Catch::Matchers::Contains;
using scenes::check_rows;
using scenes::store_head;
using scenes::store_rows;

namespace {

std::string refusal(const fs::path& file, const app::StoreHead& wanted)
{
    try {
        const Store store(file, wanted);
    } catch (const StoreError& error) {
        return error.what();
    }
    return "not refused";
}

} // namespace

TEST_CASE("store: the same study goes on, larger too, and keeps its history",
          "[app][store_study]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    {
        Store store(file, store_head(4));
        store.append(store_rows(0, 4));
        if (GENERATE(false, true)) store.compact();
    }
    const auto untouched = fs::last_write_time(file);
    app::StoreHead wanted = store_head(9);
    wanted.configuration += "samples = 9\n";
    wanted.sessions[0].machine = "another";
    wanted.levels.push_back({2e6, 1});
    Store store(file, wanted);
    CHECK(store.size() == 12);
    CHECK(fs::last_write_time(file) == untouched);
    CHECK(app::read_head(file).levels == wanted.levels); // at once, not with the first wall
    store.append(store_rows(4, 9));
    store.compact();
    CHECK(check_rows(file) == 27);
    const app::StoreHead head = app::read_head(file);
    CHECK(head.design_sizes == std::vector<std::uint32_t>{4, 9});
    CHECK(head.configuration == wanted.configuration);
    REQUIRE(head.sessions.size() == 2);
    CHECK(head.sessions[1].machine == "another");
}

TEST_CASE("store: a finished study that is run again leaves its file as it is",
          "[app][store_study]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    {
        Store store(file, store_head(2));
        store.append(store_rows(0, 2));
        store.compact();
    }
    const std::string before = scenes::read_text(file);
    {
        Store store(file, store_head(2));
        store.compact();
    }
    CHECK(scenes::read_text(file) == before);
    CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
}

TEST_CASE("store: another study is refused and the difference is shown", "[app][store_study]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    {
        Store store(file, store_head(4));
        store.append(store_rows(0, 2));
        if (GENERATE(false, true)) store.compact();
    }
    const std::string before = scenes::read_text(file);
    app::StoreHead other = store_head(4);
    other.identity = "length = 1\nfriction = normal(0.7, 0.2)\n";
    CHECK_THAT(refusal(file, other), Contains("- friction = normal(0.6, 0.2)\n+ friction = "
                                              "normal(0.7, 0.2)"));
    CHECK_THAT(refusal(file, other), !Contains("length"));
    CHECK_THAT(refusal(file, store_head(3)), Contains("has 4 samples at 0.15 MPa, only 3"));
    other = store_head(4);
    other.seed = 1;
    CHECK_THAT(refusal(file, other), Contains("- seed = 18446744073709551615\n+ seed = 1\n"));
    other = store_head(4);
    other.shards = 2;
    CHECK_THAT(refusal(file, other), Contains("- shard = 1 of 1\n+ shard = 1 of 2\n"));
    other = store_head(4);
    other.responses[1].unit = "mm";
    CHECK_THAT(refusal(file, other),
               Contains("+ response ultimate_displacement [mm] at 80 % of it"));
    other = store_head(4);
    other.levels[1].vertical_stress = std::nextafter(0.5e6, 1e6);
    CHECK_THAT(refusal(file, other),
               Contains("has walls at 0.5 MPa, and another vertical stress is wanted"));
    CHECK(scenes::read_text(file) == before);
    CHECK(refusal(file, store_head(4)) == "not refused");
}

TEST_CASE("store: walls of another revision of the solver are not gone on with",
          "[app][store_study]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    const std::string before =
        GENERATE("solver_revision = 1\n", "solver_revision = 3\n", "drystone = 0.1.0\n");
    app::StoreHead head = store_head(4);
    head.identity = before + head.identity;
    {
        Store store(file, head);
        store.append(store_rows(0, 2));
        store.compact();
    }
    const std::string bytes = scenes::read_text(file);
    app::StoreHead wanted = store_head(9);
    wanted.identity = "solver_revision = 2\n" + wanted.identity;
    const std::string begun =
        before == "drystone = 0.1.0\n"
            ? "an earlier revision"
            : "revision " + before.substr(before.find_last_of(' ') + 1, 1);
    CHECK_THAT(refusal(file, wanted),
               Contains("was begun by " + begun +
                        " of the solver (version 0.1.0). This program has revision 2") &&
                   Contains("Finish the file with the version that began it, or begin a new"));
    CHECK(scenes::read_text(file) == bytes);
    CHECK(app::read_head(file).sessions == head.sessions); // it is read as before
}

TEST_CASE("store: sessions of files of before 0.2.0 state no revision of the solver",
          "[app][store_study]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    {
        Store store(file, store_head(4));
        store.append(store_rows(0, 2));
        store.compact();
    }
    CHECK(app::read_head(file).sessions.front().solver_revision == "2");
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    REQUIRE(H5Ldelete(id, "/sessions/solver_revision", H5P_DEFAULT) >= 0);
    REQUIRE(H5Fclose(id) >= 0);
    const app::StoreHead head = app::read_head(file);
    CHECK(head.sessions.front().solver_revision.empty());
    CHECK(head.sessions.front().machine == "a machine");
}

TEST_CASE("store: walls of an audit stand beside those of the study, and old files have none",
          "[app][store_study]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    app::StoreHead head = store_head(4);
    for (std::size_t l = 0; l < 3; ++l)
        head.levels.push_back({head.levels[l].vertical_stress, 2, 4});
    {
        Store store(file, head);
        store.append(store_rows(0, 2));
        store.append(std::vector{scenes::store_row({4, 1})});
        store.compact();
    }
    std::vector<app::WallKey> own, audit;
    {
        app::StoreReader reader(file);
        CHECK(reader.head().levels == head.levels);
        reader.for_each_row([&](const app::WallRow& row) { own.push_back(row.key); });
        reader.for_each_audit_row([&](const app::WallRow& row) { audit.push_back(row.key); });
    }
    CHECK(own.size() == 6);
    CHECK(audit == std::vector<app::WallKey>{{4, 1}});
    CHECK(app::own_key(head, audit.front()) == app::WallKey{1, 1});
    head.levels[4].samples = 1;
    CHECK_THAT(refusal(file, head),
               Contains("has 2 walls of each stress pushed again more slowly, only 1 are"));
    CHECK_THAT(refusal(file, store_head(4)), Contains("only 0 are wanted (uq.audit)"));

    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    REQUIRE(H5Ldelete(id, "/levels/slower", H5P_DEFAULT) >= 0);
    REQUIRE(H5Fclose(id) >= 0);
    CHECK(app::own_levels(app::read_head(file)) == 6);
}

TEST_CASE("store: heads that make no sense are refused", "[app][store_study]")
{
    const scenes::MemoryFolder folder;
    app::StoreHead head = store_head(4);
    SECTION("name") { head.inputs[0].name = "a/b"; }
    SECTION("no name") { head.counts[0].name = ""; }
    SECTION("audit of one level") { head.levels.push_back({0.15e6, 2, 4}); }
    SECTION("audit of walls that are not there")
    {
        for (std::size_t l = 0; l < 3; ++l)
            head.levels.push_back({head.levels[l].vertical_stress, 5, 4});
    }
    SECTION("no speed") { head.levels[0].slower = 0; }
    SECTION("dots") { head.cost[0].name = ".."; }
    SECTION("twice") { head.responses[0].name = head.responses[1].name; }
    SECTION("shard") { head.shard = 1; }
    SECTION("stress") { head.levels[0].vertical_stress = std::nan(""); }
    SECTION("design") { head.design_sizes = {4, 4}; }
    CHECK_THROWS_AS(Store(folder.path / "a.h5", head), std::invalid_argument);
    CHECK(fs::is_empty(folder.path));
}
