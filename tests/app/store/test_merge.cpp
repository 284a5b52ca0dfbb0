#include "app/store/continued_head.hpp"
#include "app/store/merge.hpp"
#include "app/store/store.hpp"
#include "app/store/store_reader.hpp"

#include "tests/app/store/memory_folder.hpp"
#include "tests/app/store/store_scene.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <functional>
#include <stdexcept>

namespace fs = std::filesystem;
using app::Store;
using app::StoreError;
using app::StoreReader;
using Catch::Matchers::Contains;
using scenes::check_rows;
using scenes::store_head;
using scenes::store_row;

namespace {

constexpr std::uint32_t kSamples = 20;

/// Samples i, i + n, ... of all levels but what `skip` names; shard 0 is left with parts.
fs::path shard(const fs::path& folder, std::uint32_t i, std::uint32_t n,
               const app::StoreHead& like, const std::function<bool(app::WallKey)>& skip = {})
{
    app::StoreHead head = like;
    head.shard = i;
    head.shards = n;
    head.sessions[0].machine = "node " + std::to_string(i);
    const fs::path file = folder / ("s" + std::to_string(i) + ".h5");
    Store store(file, head);
    for (std::uint32_t sample = i; sample < kSamples; sample += n)
        for (std::uint32_t level = 0; level < 3; ++level) {
            const app::WallRow row = store_row({level, sample});
            if (!skip || !skip(row.key)) store.append({&row, 1});
        }
    if (i > 0) store.compact();
    return file;
}

std::vector<fs::path> shards(const fs::path& folder, std::uint32_t n)
{
    std::vector<fs::path> files;
    for (std::uint32_t i = 0; i < n; ++i)
        files.push_back(shard(folder, i, n, store_head(kSamples)));
    return files;
}

std::string refusal(const fs::path& out, const std::vector<fs::path>& files,
                    bool partial = false)
{
    std::string words = "not refused";
    try {
        app::merge(out, files, partial);
    } catch (const StoreError& error) {
        words = error.what();
        CHECK(!fs::exists(out));
        CHECK(!fs::exists(out.string() + ".tmp"));
        CHECK(!fs::exists(app::lock_of(out)));
    }
    return words;
}

} // namespace

TEST_CASE("merge: 1, 4 and 16 shards in any order give the walls of the whole study",
          "[app][merge]")
{
    const scenes::MemoryFolder folder;
    const auto n = GENERATE(1u, 4u, 16u);
    std::vector<fs::path> files = shards(folder.path, n);
    std::reverse(files.begin(), files.end());
    const fs::path out = folder.path / "all.h5";
    app::merge(out, files);
    CHECK(check_rows(out) == 3 * kSamples);
    const app::StoreHead head = app::read_head(out);
    CHECK(head.shards == 1);
    CHECK(head.levels == store_head(kSamples).levels);
    CHECK(head.sessions.size() == n);
    Store again(out, store_head(kSamples)); // it goes on as a study of its own
    CHECK(again.size() == 3 * kSamples);
}

TEST_CASE("merge: merged in two steps, byte for byte as in one but for the sessions",
          "[app][merge]")
{
    const scenes::MemoryFolder folder;
    const std::vector<fs::path> f = shards(folder.path, 4);
    app::merge(folder.path / "a.h5", {f[0], f[1]}, true);
    app::merge(folder.path / "b.h5", {f[2], f[3]}, true);
    app::merge(folder.path / "two.h5", {folder.path / "a.h5", folder.path / "b.h5"});
    app::merge(folder.path / "one.h5", f);
    CHECK(scenes::read_text(folder.path / "one.h5") ==
          scenes::read_text(folder.path / "two.h5"));
}

TEST_CASE("merge: walls in no shard are listed; a partial merge takes what is there",
          "[app][merge]")
{
    const scenes::MemoryFolder folder;
    const app::WallKey lost{1, 6};
    const std::vector<fs::path> files{shard(folder.path, 0, 2, store_head(kSamples),
                                            [&](app::WallKey key) { return key == lost; }),
                                      shard(folder.path, 1, 2, store_head(kSamples))};
    const fs::path out = folder.path / "all.h5";
    CHECK_THAT(refusal(out, files),
               Contains("1 walls are in no shard") && Contains("wall (level 1, sample 6)"));
    app::merge(out, files, true);
    CHECK(!StoreReader(out).row(lost));
    CHECK(check_rows(out) == 3 * kSamples - 1);
}

TEST_CASE("merge: a shard that is missing is named with its file", "[app][merge]")
{
    const scenes::MemoryFolder folder;
    std::vector<fs::path> files = shards(folder.path, 12);
    const fs::path out = folder.path / "all.h5";
    const fs::path own = folder.path / "wall_02_of_12.h5"; // compacted: it is one file
    fs::rename(files[1], own);
    files.erase(files.begin() + 1, files.begin() + 3);
    files.insert(files.begin(), own);
    CHECK_THAT(refusal(out, files),
               Contains("  shard 3 of 12 is missing: " +
                        (folder.path / "wall_03_of_12.h5").string() + "\n") &&
                   !Contains("wall (level"));
    std::swap(files[0], files[1]); // a file whose name does not tell
    CHECK_THAT(refusal(out, files), Contains("  shard 3 of 12 is missing\n"));
    CHECK_THAT(refusal(out, {own}), Contains("shard 12 of 12 is missing"));
    app::merge(out, files, true);
    CHECK(check_rows(out) == 3 * kSamples - 6);
}

TEST_CASE("merge: what makes two studies differ is shown once", "[app][merge]")
{
    const scenes::MemoryFolder folder;
    app::StoreHead head = store_head(kSamples);
    head.identity += "uq.seed = 1\n";
    head.configuration += "seed = 1\n";
    head.seed = 1;
    const fs::path first = shard(folder.path, 0, 2, head);
    head.identity.replace(head.identity.find("seed = 1"), 8, "seed = 2");
    head.configuration.replace(head.configuration.find("seed = 1"), 8, "seed = 2");
    head.seed = 2;
    const std::string words =
        refusal(folder.path / "all.h5", {first, shard(folder.path, 1, 2, head)});
    CHECK_THAT(words, Contains("- uq.seed = 1\n+ uq.seed = 2\n"));
    CHECK(words.find("seed = 2") == words.rfind("seed = 2"));
    CHECK(app::text_difference("a\n", std::string(1'000'000, 'b')) ==
          "- a\n+ " + std::string(298, 'b') + " ...\n");
}

TEST_CASE("merge: records may stand in another folder on each machine", "[app][merge]")
{
    const scenes::MemoryFolder folder, other;
    app::StoreHead head = store_head(kSamples);
    const std::string before = head.configuration + "[shaking]\n";
    head.configuration = before + "records                 = /one/a.txt\n";
    const fs::path first = shard(folder.path, 0, 2, head);
    head.configuration = before + "records                 = /two/a.txt\n";
    app::merge(folder.path / "all.h5", {first, shard(folder.path, 1, 2, head)});
    CHECK_THAT(app::read_head(folder.path / "all.h5").configuration, Contains("/one/a.txt"));
    head.configuration = before + "scale                   = 2\n";
    CHECK_THAT(refusal(folder.path / "no.h5", {first, shard(other.path, 1, 2, head)}),
               Contains("+ scale                   = 2"));
    // the key of this section alone
    const scenes::MemoryFolder third;
    head.configuration = before + "[output]\nrecords = 2\n";
    CHECK_THAT(refusal(folder.path / "no.h5", {first, shard(third.path, 1, 2, head)}),
               Contains("+ records = 2"));
}

TEST_CASE("merge: a wall in two shards is refused", "[app][merge]")
{
    const scenes::MemoryFolder folder;
    std::vector<fs::path> files = shards(folder.path, 2);
    files.push_back(files[1]);
    CHECK_THAT(refusal(folder.path / "all.h5", files),
               Contains("wall (level 0, sample 1) is in") && Contains("Name each shard once"));
}

TEST_CASE("merge: shards of two revisions of the solver are refused", "[app][merge]")
{
    const scenes::MemoryFolder folder;
    app::StoreHead head = store_head(kSamples);
    head.identity = "solver_revision = 2\n" + head.identity;
    const fs::path first = shard(folder.path, 0, 2, head);
    head.identity.replace(head.identity.find('2'), 1, "3");
    const std::vector<fs::path> files{first, shard(folder.path, 1, 2, head)};
    CHECK_THAT(refusal(folder.path / "all.h5", files),
               Contains("is of revision 3 of the solver, ") &&
                   Contains("of revision 2 of the solver: each gives other numbers") &&
                   Contains("Nothing was written"));
}

TEST_CASE("merge: shards of different studies are refused and the difference is shown",
          "[app][merge]")
{
    const scenes::MemoryFolder folder;
    app::StoreHead head = store_head(kSamples);
    std::string words;
    SECTION("identity") { head.identity += "g = 9.81\n", words = "+ g = 9.81"; }
    SECTION("configuration") { head.configuration += "[x]\n", words = "+ [x]"; }
    SECTION("seed") { head.seed = 7, words = "+ seed = 7"; }
    SECTION("column") { head.counts.pop_back(), words = "- count cracked_units"; }
    SECTION("samples") { head.levels[2].samples++, words = "+ level of 1.25 MPa"; }
    SECTION("stress") { head.levels[2].vertical_stress = 1e6, words = "+ level of 1 MPa"; }
    SECTION("design") { head.design_sizes = {10, 20}, words = "+ design grown through 10 20"; }
    SECTION("precision") { head.single_precision_curves = true, words = "precision yes"; }
    const std::vector<fs::path> files{shard(folder.path, 0, 2, store_head(kSamples)), [&] {
                                          head.shard = 1;
                                          head.shards = 2;
                                          Store(folder.path / "other.h5", head);
                                          return folder.path / "other.h5";
                                      }()};
    CHECK_THAT(refusal(folder.path / "all.h5", files),
               Contains("is not of the study of") && Contains(words));
}

TEST_CASE("merge: nothing, an output that is there, and shards that cannot be read are refused",
          "[app][merge]")
{
    const scenes::MemoryFolder folder;
    const std::vector<fs::path> files = shards(folder.path, 2);
    CHECK_THROWS_AS(app::merge(folder.path / "all.h5", {}), std::invalid_argument);
    CHECK_THROWS_WITH(app::merge(files[0], files), Contains("there already"));
    CHECK_THAT(refusal(folder.path / "all.h5", {files[0], folder.path / "none.h5"}),
               Contains("no such file"));
    CHECK(check_rows(files[0]) == 30);
}
