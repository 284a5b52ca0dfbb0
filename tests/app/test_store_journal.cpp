#include "app/store/journal.hpp"
#include "app/store/store.hpp"

#include "app/memory_folder.hpp"
#include "app/store_scene.hpp"
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

/// A store with `first` walls in its file and `second` more in its journal (times 3 levels).
std::string journal_of_study(const fs::path& file, std::uint32_t first, std::uint32_t second)
{
    Store store(file, store_head(20));
    store.append(store_rows(0, first, 2));
    store.compact();
    for (const app::WallRow& row : store_rows(first, first + second, 2))
        store.append({&row, 1});
    return read_text(app::journal_of(file));
}

/// Offset of the last record.
std::size_t last_record(const std::string& journal) { return journal.rfind("DREC"); }

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

TEST_CASE("journal: torn at any byte of its last record, it keeps all others and goes on",
          "[app][store_journal]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    const std::string whole = journal_of_study(file, 1, 2);
    for (std::size_t length = last_record(whole); length < whole.size(); ++length) {
        write_text(app::journal_of(file), whole.substr(0, length));
        REQUIRE(check_rows(file, 2) == 8);
        REQUIRE(fs::file_size(app::journal_of(file)) == length); // readers change nothing
        Store store(file, store_head(20));
        REQUIRE(store.replayed().torn_bytes == length - last_record(whole));
        REQUIRE(store.replayed().records == 6); // head and five walls
        REQUIRE(store.size() == 8);
        REQUIRE(fs::file_size(app::journal_of(file)) == last_record(whole));
        const app::WallRow lost = scenes::store_row({2, 1}, 2);
        store.append({&lost, 1});
        REQUIRE(check_rows(file, 2) == 9);
    }
}

TEST_CASE("journal: torn anywhere in its preamble and head, it is begun anew",
          "[app][store_journal]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    const std::string whole = journal_of_study(file, 1, 1);
    const std::size_t head_end = whole.find("DREC", app::kJournalPreamble + 1);
    for (std::size_t length = 0; length < head_end; length += length < 50 ? 1 : 29) {
        write_text(app::journal_of(file), whole.substr(0, length));
        REQUIRE(check_rows(file, 2) == 3);
        Store store(file, store_head(20));
        store.append(store_rows(1, 2, 2));
        REQUIRE(check_rows(file, 2) == 6);
    }
}

TEST_CASE("journal: a damaged record in the middle is skipped and counted, the others are kept",
          "[app][store_journal]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    std::string journal = journal_of_study(file, 1, 2);
    const std::size_t end = last_record(journal), begin = journal.rfind("DREC", end - 1);
    const std::size_t places[] = {begin, begin + 9, begin + 17, end - 1};
    const std::size_t offset = places[GENERATE(0, 1, 2, 3)];
    journal[offset] = static_cast<char>(journal[offset] ^ 0x10);
    write_text(app::journal_of(file), journal);
    CHECK(check_rows(file, 2) == 8);
    Store store(file, store_head(20));
    CHECK(store.replayed().damaged == 1);
    CHECK(store.replayed().torn_bytes == 0);
    store.compact();
    CHECK(check_rows(file, 2) == 8);
}

TEST_CASE("journal: that of another study, of another layout or of nothing is refused",
          "[app][store_journal]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    std::string journal = journal_of_study(file, 1, 1);
    SECTION("of another study")
    {
        app::StoreHead other = store_head(20);
        other.identity = "length = 2\n";
        Store store(folder.path / "b.h5", other);
        store.append(store_rows(0, 1));
        fs::copy_file(app::journal_of(folder.path / "b.h5"), app::journal_of(file),
                      fs::copy_options::overwrite_existing);
        CHECK_THAT(refusal(file),
                   Contains("is not of the study beside it") && Contains("+ length = 2"));
    }
    SECTION("of another layout")
    {
        journal[16] = 9;
        const std::uint32_t sum = app::crc32_of({journal.data(), 20});
        journal.replace(20, 4, reinterpret_cast<const char*>(&sum), 4);
        write_text(app::journal_of(file), journal);
        CHECK_THAT(refusal(file), Contains("has layout 9, this program knows 1"));
    }
    SECTION("of nothing")
    {
        write_text(app::journal_of(file), "some other text that is longer than the preamble");
        CHECK_THAT(refusal(file), Contains("damaged or no journal"));
    }
    SECTION("without its head")
    {
        journal[app::kJournalPreamble] = 'X';
        write_text(app::journal_of(file), journal);
        CHECK_THAT(refusal(file), Contains("it has no head"));
    }
    SECTION("without its file")
    {
        fs::remove(file);
        CHECK_THAT(refusal(file), Contains("no such file; bring it back"));
        CHECK_THROWS_WITH(Store(file, store_head(20)), Contains("without its"));
    }
    CHECK_THROWS_AS(Store(file, store_head(20)), StoreError);
}

TEST_CASE("journal: the last of several records of one wall counts", "[app][store_journal]")
{
    const scenes::MemoryFolder folder;
    const fs::path file = folder.path / "a.h5";
    Store store(file, store_head(20));
    app::WallRow row = scenes::store_row({0, 1});
    for (const std::int32_t status : {3, 2, 1}) {
        row.status = status;
        store.append({&row, 1});
    }
    CHECK(StoreReader(file).statuses().size() == 1);
    CHECK(StoreReader(file).row(std::size_t{0}).status == 1);
}
