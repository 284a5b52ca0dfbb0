#include "app/store/merge.hpp"
#include "app/store/store.hpp"

#include "app/child_process.hpp"
#include "tests/app/store/store_scene.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <sys/resource.h>

namespace fs = std::filesystem;
using app::Store;
using scenes::store_head;
using scenes::store_row;

namespace {

/// Largest resident memory of this process so far [MiB].
double peak_memory()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void add_walls(Store& store, std::uint32_t first, std::uint32_t last)
{
    std::vector<app::WallRow> batch;
    for (std::uint32_t sample = first; sample < last; ++sample) {
        for (std::uint32_t level = 0; level < 3; ++level)
            batch.push_back(store_row({level, sample}, 20));
        if (batch.size() < 300 && sample + 1 < last) continue;
        store.append(batch);
        batch.clear();
    }
}

} // namespace

// A known defect since layout 2: some 165 MB instead of 25 (docs/store.md). Whoever mends it
// takes the mark away.
TEST_CASE("store: 100 000 walls are written, compacted several times and read in flat memory",
          "[app][store_memory][slow][!shouldfail]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    const auto run = [&](std::uint32_t samples) {
        const double before = peak_memory();
        Store store(file, store_head(samples));
        add_walls(store, 0, samples);
        store.compact();
        app::StoreReader reader(file);
        std::size_t n = 0;
        reader.for_each_row([&n](const app::WallRow&) { ++n; });
        const double grown = peak_memory() - before;
        // 60 MB of numbers pass through; the index takes some 100 bytes a wall in a compaction
        return n == 3 * samples && grown < 25.0 ? 0 : 2 + static_cast<int>(grown);
    };
    CHECK(scenes::wait_for(scenes::start_child([&] { return run(33334); })) == 0);
    CHECK(fs::file_size(file) > 30'000'000);
}

TEST_CASE("merge: 16 shards of 48 000 walls are merged in flat memory", "[app][merge][slow]")
{
    const scenes::TemporaryFolder folder;
    std::vector<fs::path> files;
    for (std::uint32_t i = 0; i < 16; ++i) {
        files.push_back(folder.path / (std::to_string(i) + ".h5"));
        app::StoreHead head = store_head(16000);
        head.shard = i;
        head.shards = 16;
        Store store(files.back(), head);
        add_walls(store, 1000 * i, 1000 * (i + 1));
        store.compact();
    }
    const auto run = [&] {
        const double before = peak_memory();
        app::merge(folder.path / "all.h5", files);
        const double grown = peak_memory() - before;
        return grown < 40.0 ? 0 : 2 + static_cast<int>(grown);
    };
    CHECK(scenes::wait_for(scenes::start_child(run)) == 0);
    CHECK(app::StoreReader(folder.path / "all.h5").statuses().size() == 48000);
}
