#include "app/store/store.hpp"

#include "app/memory_folder.hpp"
#include "app/store_scene.hpp"
#include "tests/scenes/temporary_folder.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;
using app::StoreError;

namespace {

/// One random change: bits flipped, cut, a block moved over another, a block of one value, bytes added.
std::string mutated(std::string bytes, uq::Stream& random)
{
    const auto place = [&] { return static_cast<std::size_t>(random.below(bytes.size())); };
    const std::size_t a = place(), b = place();
    const std::size_t n = 1 + std::min({static_cast<std::size_t>(random.below(64)),
                                        bytes.size() - a - 1, bytes.size() - b - 1});
    switch (random.below(6)) {
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
    default:
        bytes.erase(a, n);
        break;
    }
    return bytes;
}

struct Outcome {
    int refused = 0, read = 0, unchanged = 0;
    std::size_t wrong = 0; ///< walls that nobody stored, errors without words
};

void put(const fs::path& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

/// Reads all there is; every wall that comes out must be one that went in.
void read_all(const fs::path& file, Outcome& outcome)
{
    try {
        app::StoreReader reader(file);
        reader.for_each_row([&](const app::WallRow& row) {
            if (!app::same_results(row, scenes::store_row(row.key))) ++outcome.wrong;
        });
        ++outcome.read;
    } catch (const StoreError& error) {
        if (std::string(error.what()).size() < 20) ++outcome.wrong;
        ++outcome.refused;
    }
}

/// Goes on with the study, unless that is refused.
void write_on(const fs::path& file, Outcome& outcome)
{
    try {
        app::Store store(file, scenes::store_head(20));
        store.append(scenes::store_rows(6, 7));
        store.compact();
    } catch (const StoreError&) {
        return;
    }
    read_all(file, outcome);
}

/// Mutates one of the two files of a study that has both; every 100th is written to as well.
Outcome fuzz(int mutations, std::uint64_t seed, bool of_journal)
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5", journal = app::journal_of(file);
    {
        app::Store store(file, scenes::store_head(20));
        store.append(scenes::store_rows(0, 3));
        store.compact();
        store.append(scenes::store_rows(3, 6));
    }
    const std::string whole_file = scenes::read_text(file);
    const std::string whole_journal = scenes::read_text(journal);
    const std::string& whole = of_journal ? whole_journal : whole_file;
    uq::Stream random(seed, 0, uq::Purpose::search);
    Outcome outcome;
    for (int k = 0; k < mutations; ++k) {
        const std::string bytes = mutated(whole, random);
        if (bytes == whole) ++outcome.unchanged;
        put(of_journal ? journal : file, bytes);
        read_all(file, outcome);
        if (k % 100 != 0) continue;
        Outcome written;
        write_on(file, written);
        outcome.wrong += written.wrong;
        put(file, whole_file);
        put(journal, whole_journal);
    }
    return outcome;
}

} // namespace

TEST_CASE(
    "fuzz: 10 000 mutations of FILE.h5 are all refused with a reason, before HDF5 sees them",
    "[fuzz][store][slow]")
{
    const Outcome outcome = fuzz(10000, 1, false);
    CHECK(outcome.wrong == 0);
    CHECK(outcome.read == outcome.unchanged); // a block of zeros moved over zeros
    CHECK(outcome.refused > 8000);
}

TEST_CASE("fuzz: 5 000 mutations of a journal give sound walls or are refused with a reason",
          "[fuzz][store][slow]")
{
    const Outcome outcome = fuzz(5000, 2, true);
    INFO(outcome.refused << " refused, " << outcome.read << " read");
    CHECK(outcome.wrong == 0);
    CHECK(outcome.read > 2500);
}
