#include "app/store/store.hpp"

#include "app/child_process.hpp"
#include "tests/app/store/memory_folder.hpp"
#include "tests/app/store/store_scene.hpp"
#include "tests/scenes/temporary_folder.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <sys/mman.h>
#include <vector>

namespace fs = std::filesystem;
using app::Store;
using app::StoreStage;
using scenes::check_rows;
using scenes::start_child;
using scenes::store_head;
using scenes::store_rows;
using scenes::wait_for;

namespace {

/// Shared with the children: what they had acknowledged.
struct Progress {
    std::atomic<std::uint32_t> samples;     ///< append() came back
    std::atomic<std::uint32_t> compactions; ///< done
};

Progress* shared_progress()
{
    void* memory = ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE,
                          MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    REQUIRE(memory != MAP_FAILED);
    return new (memory) Progress{};
}

/// Goes on with the study, one sample per batch, compacting often, until it is killed or done.
int write_walls(const fs::path& file, std::uint32_t samples, Progress& progress)
{
    app::StoreOptions options;
    options.most_parts = 12;
    options.reached = [&](StoreStage stage) {
        if (stage == StoreStage::parts_removed) ++progress.compactions;
    };
    Store store(file, store_head(samples), options);
    for (std::uint32_t i = 0; i < samples; ++i) {
        std::vector<app::WallRow> rows = store_rows(i, i + 1, 100);
        // a batch that was killed is there as a whole or not at all
        if (store.status(rows.front().key)) continue;
        store.append(rows);
        progress.samples = std::max(progress.samples.load(), i + 1);
    }
    store.compact();
    return 0;
}

bool h5dump_reads(const fs::path& file)
{
    if (std::system("command -v h5dump >/dev/null") != 0) return true; // hdf5-tools is optional
    const std::string command =
        "h5dump -d /walls/status '" + file.string() + "' >/dev/null 2>&1";
    return std::system(command.c_str()) == 0;
}

} // namespace

TEST_CASE(
    "store: killed six times at random, it loses no wall that was acknowledged and ends as "
    "if never killed",
    "[slow][app][store_kill]")
{
    constexpr std::uint32_t samples = 2500;
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    Progress& progress = *shared_progress();
    uq::Stream random(1, 0, uq::Purpose::search);
    int begun = 0;
    for (int killed = 0; killed < 6; ++begun) {
        REQUIRE(begun < 300);
        const pid_t child = start_child([&] { return write_walls(file, samples, progress); });
        const std::uint32_t until =
            std::min(samples, progress.samples + static_cast<std::uint32_t>(random.below(30)));
        for (int wait = 0; wait < 50000 && progress.samples < until; ++wait) ::usleep(100);
        ::usleep(static_cast<useconds_t>(random.below(1500)));
        ::kill(child, SIGKILL);
        killed += wait_for(child) == -SIGKILL;
        if (fs::exists(file)) { // not killed before it was there
            REQUIRE(check_rows(file, 100) >= 3 * progress.samples);
            REQUIRE(h5dump_reads(file));
        }
        if (progress.samples < samples) continue;
        for (const fs::path& done : {file, app::parts_of(file), app::lock_of(file)})
            fs::remove_all(done); // nothing left to write: another file
        progress.samples = 0;
    }
    INFO(begun << " begun, " << progress.samples << " samples before the last kill");
    CHECK(progress.compactions >= 2);
    REQUIRE(wait_for(start_child([&] { return write_walls(file, samples, progress); })) == 0);
    CHECK(check_rows(file, 100) == 3 * samples);
    CHECK(!fs::exists(app::parts_of(file)));
    CHECK(!fs::exists(app::lock_of(file)));
}

TEST_CASE("store: a compaction killed at any stage leaves all walls and can be done again",
          "[app][store_kill]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    const auto stage = GENERATE(StoreStage::rows_written, StoreStage::synced,
                                StoreStage::renamed, StoreStage::parts_removed);
    {
        Store store(file, store_head(40));
        store.append(store_rows(0, 20));
        store.compact();
        store.append(store_rows(20, 30));
    }
    const pid_t child = start_child([&] {
        app::StoreOptions options;
        options.reached = [&](StoreStage at) {
            if (at == stage) ::kill(::getpid(), SIGKILL);
        };
        Store store(file, store_head(40), options);
        store.compact();
        return 0;
    });
    REQUIRE(wait_for(child) == -SIGKILL);
    CHECK(check_rows(file) == 90);
    Store store(file, store_head(40));
    CHECK(store.size() == 90);
    store.append(store_rows(30, 40));
    store.compact();
    CHECK(check_rows(file) == 120);
    CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 2); // the file and its lock
}

TEST_CASE("store: a larger study killed in its compaction keeps the larger head",
          "[app][store_kill]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    {
        Store store(file, store_head(5));
        store.append(store_rows(0, 5));
    }
    const pid_t child = start_child([&] {
        app::StoreOptions options;
        options.reached = [](StoreStage at) {
            if (at == StoreStage::renamed) ::kill(::getpid(), SIGKILL);
        };
        Store store(file, store_head(8), options);
        store.append(store_rows(5, 8));
        store.compact();
        return 0;
    });
    REQUIRE(wait_for(child) == -SIGKILL);
    REQUIRE(fs::exists(app::parts_of(file)));
    CHECK(check_rows(file) == 24);
    CHECK(Store(file, store_head(8)).head().design_sizes == std::vector<std::uint32_t>{5, 8});
}
