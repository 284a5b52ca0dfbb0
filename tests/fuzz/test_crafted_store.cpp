#include "fuzz/crafted_hdf5.hpp"

#include "app/child_process.hpp"
#include "app/store/store.hpp"
#include "tests/app/store/memory_folder.hpp"
#include "tests/app/store/store_scene.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>

namespace fs = std::filesystem;

namespace {

struct CraftedOutcome {
    int refused = 0, read = 0, wrong = 0;
};

/// Reads all walls: those that come have sound curves, or an error names the file and what to
/// do.
void read_crafted(const fs::path& file, const std::string& what, CraftedOutcome& outcome)
{
    try {
        app::StoreReader reader(file);
        reader.for_each_row([&](const app::WallRow& row) {
            for (const double f : row.curve.force)
                if (!std::isfinite(f) && row.status == app::kWallOk) ++outcome.wrong;
        });
        ++outcome.read;
    } catch (const app::StoreError& error) {
        const std::string words = error.what();
        const bool good = words.find(file.string()) != std::string::npos &&
                          words.find("; ") != std::string::npos;
        if (!good) std::fprintf(stderr, "%s: %s\n", what.c_str(), error.what());
        outcome.wrong += good ? 0 : 1;
        ++outcome.refused;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", what.c_str(), error.what());
        ++outcome.wrong;
    }
}

double peak_memory_mb()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// In a child: a crash or a hang is seen as that.
int craft_and_read(int times, std::uint64_t seed)
{
    const scenes::MemoryFolder folder;
    const fs::path whole = folder.path / "whole.h5", file = folder.path / "a.h5";
    {
        app::Store store(whole, scenes::store_head(6));
        store.append(scenes::store_rows(0, 6, 5));
        store.compact();
    }
    uq::Stream random(seed, 0, uq::Purpose::search);
    CraftedOutcome outcome;
    for (int k = 0; k < times; ++k) {
        fs::copy_file(whole, file, fs::copy_options::overwrite_existing);
        std::string what;
        for (std::uint64_t n = 1 + random.below(2); n > 0; --n)
            what += crafted::change_anything(file, random) + "; ";
        ::alarm(20); // ends a child that hangs
        read_crafted(file, what, outcome);
    }
    std::fprintf(stderr, "%d crafted files: %d refused, %d read, %d wrong, %.0f MB\n", times,
                 outcome.refused, outcome.read, outcome.wrong, peak_memory_mb());
    const bool both = outcome.refused > times / 3 && outcome.read > times / 50;
    return outcome.wrong == 0 && both && peak_memory_mb() < 1500.0 ? 0 : 2;
}

} // namespace

TEST_CASE("fuzz: files crafted with right checksums are read or refused with a reason, in "
          "bounded memory",
          "[fuzz][store]")
{
    const char* given = std::getenv("DRYSTONE_CRAFTED_FILES");
    const int times = given != nullptr ? std::atoi(given) : 400;
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        INFO("seed " << seed);
        const pid_t child =
            scenes::start_child([&] { return craft_and_read(times / 2, seed); });
        CHECK(scenes::wait_for(child) == 0);
    }
}
