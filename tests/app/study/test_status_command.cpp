#include "app/commands.hpp"
#include "app/store/store.hpp"
#include "app/text/config_error.hpp"
#include "scenes/temporary_folder.hpp"
#include "scenes/terminal.hpp"
#include "tests/app/store/store_scene.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string status_of(const fs::path& file)
{
    app::Command c;
    c.study = file.string();
    const scenes::Terminal terminal;
    const int code = app::status_command(c);
    CHECK(code == 0);
    return terminal.text();
}

} // namespace

TEST_CASE("status: what is there, failed and missing, while another process writes",
          "[app][status]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    app::Store store(file, scenes::store_head(10)); // holds the lock
    store.append(scenes::store_rows(0, 8));
    const std::string text = status_of(file);
    INFO(text);
    // 3 levels; every 7th wall of store_row failed
    CHECK(text.find(": 24 of 30 walls, the same study command runs the others") !=
          std::string::npos);
    std::size_t failed = 0;
    for (const app::WallRow& row : scenes::store_rows(0, 8))
        failed += row.status == app::kWallOk ? 0 : 1;
    REQUIRE(failed > 0);
    std::size_t rows = 0, said_failed = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        double stress = 0.0;
        std::size_t walls = 0, done = 0, bad = 0, missing = 0;
        if (!(words >> stress >> walls >> done >> bad >> missing)) continue;
        ++rows;
        CHECK(walls == 10);
        CHECK(done + bad == 8);
        CHECK(missing == 2);
        said_failed += bad;
    }
    CHECK(rows == 3);
    CHECK(said_failed == failed);
    CHECK(text.find("last written 2") != std::string::npos);
}

TEST_CASE("status: a file that is read alone gets no other beside it", "[app][status]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    {
        app::Store store(file, scenes::store_head(3));
        store.append(scenes::store_rows(0, 3));
        store.compact();
    }
    fs::remove(folder.path / "a.h5.lock");
    const auto names = [&] {
        return std::distance(fs::directory_iterator(folder.path), fs::directory_iterator());
    };
    const auto before = names();
    CHECK(status_of(file).find(": 9 of 9 walls, all are there") != std::string::npos);
    CHECK(names() == before);
    std::ofstream(folder.path / "text.h5") << "nothing";
    CHECK_THROWS_AS(status_of(folder.path / "text.h5"), app::ConfigError);
}
