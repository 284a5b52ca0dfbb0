#include "app/store/store.hpp"

#include "app/child_process.hpp"
#include "tests/app/store/memory_folder.hpp"
#include "tests/app/store/store_scene.hpp"
#include "tests/scenes/same_results.hpp"
#include "tests/scenes/temporary_folder.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;
using app::StoreError;

namespace {

/// One random change: bits flipped, cut, a block moved over another, a block of one value,
/// a sector of zeros, bytes added or taken out.
std::string mutated(std::string bytes, uq::Stream& random)
{
    const auto place = [&] { return static_cast<std::size_t>(random.below(bytes.size())); };
    const std::size_t a = place(), b = place();
    const std::size_t n = 1 + std::min({static_cast<std::size_t>(random.below(64)),
                                        bytes.size() - a - 1, bytes.size() - b - 1});
    switch (random.below(7)) {
    case 0:
        for (std::uint64_t k = 0, flips = 1 + random.below(8); k < flips; ++k) {
            char& byte = bytes[place()];
            byte = static_cast<char>(byte ^ (1 << random.below(8)));
        }
        break;
    case 1:
        bytes.resize(a);
        break;
    case 2:
        bytes.replace(a, n, bytes.substr(b, n));
        break;
    case 3:
        bytes.replace(a, n, std::string(n, random.below(2) == 0 ? '\0' : '\xff'));
        break;
    case 4:
        bytes.insert(a, bytes.substr(b, n));
        break;
    case 5: { // whole sectors
        const std::size_t sector = a / 512 * 512;
        bytes.replace(sector, std::min<std::size_t>(512, bytes.size() - sector), 512, '\0');
        break;
    }
    default:
        bytes.erase(a, n);
        break;
    }
    return bytes;
}

struct Outcome {
    int refused = 0, read = 0;
    std::size_t wrong = 0; ///< walls that nobody stored, errors without words
};

void put(const fs::path& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

/// Reads all walls: each must be one that went in, or an error names the file and what to do.
void read_all(const fs::path& file, Outcome& outcome)
{
    try {
        app::StoreReader reader(file);
        std::size_t walls = 0;
        reader.for_each_row([&](const app::WallRow& row) {
            ++walls;
            if (!scenes::same_results(row, scenes::store_row(row.key))) ++outcome.wrong;
        });
        if (walls != 60 || !(reader.head() == scenes::store_head(20))) ++outcome.wrong;
        ++outcome.read;
    } catch (const StoreError& error) {
        const std::string words = error.what();
        const bool good = words.find(file.string()) != std::string::npos &&
                          words.find("; ") != std::string::npos;
        if (!good) ++outcome.wrong;
        ++outcome.refused;
    }
}

/// Damages FILE.h5 or its part and reads, in a child: a crash or a hang is seen as that.
int damage_and_read(int times, std::uint64_t seed, bool of_part)
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5", part = app::part_of(file, 1);
    {
        app::Store store(file, scenes::store_head(20));
        store.append(scenes::store_rows(0, 15));
        store.compact();
        store.append(scenes::store_rows(15, 20));
    }
    const fs::path damaged = of_part ? part : file;
    const std::string whole = scenes::read_text(damaged);
    uq::Stream random(seed, 0, uq::Purpose::search);
    Outcome outcome;
    for (int k = 0; k < times; ++k) {
        put(damaged, mutated(whole, random));
        ::alarm(20); // ends a child that hangs
        read_all(file, outcome);
    }
    std::fprintf(stderr, "%d damaged files: %d refused, %d read right, %zu wrong\n", times,
                 outcome.refused, outcome.read, outcome.wrong);
    return outcome.wrong == 0 && outcome.refused > times / 2 ? 0 : 2;
}

} // namespace

TEST_CASE("fuzz: damaged files give the walls that went in or are refused with a reason, HDF5 "
          "does not crash",
          "[fuzz][store][slow]")
{
    const char* given = std::getenv("DRYSTONE_DAMAGED_FILES");
    const int times = given != nullptr ? std::atoi(given) : 2000;
    const bool of_part = GENERATE(false, true);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        INFO("seed " << seed << (of_part ? ", a part" : ", the file"));
        const pid_t child =
            scenes::start_child([&] { return damage_and_read(times / 8, seed, of_part); });
        CHECK(scenes::wait_for(child) == 0);
    }
}
