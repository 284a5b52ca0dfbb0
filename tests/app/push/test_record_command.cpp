#include "app/commands.hpp"
#include "app/record/record_pictures.hpp"
#include "app/record/record_table.hpp"
#include "app/text/config_error.hpp"
#include "ground/pulse.hpp"
#include "scenes/terminal.hpp"

#include <catch2/catch.hpp>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

class RecordFolder {
  public:
    RecordFolder() { fs::create_directories(path); }
    ~RecordFolder() { fs::remove_all(path); }
    RecordFolder(const RecordFolder&) = delete;
    RecordFolder& operator=(const RecordFolder&) = delete;
    fs::path path =
        fs::temp_directory_path() / ("drystone_record_" + std::to_string(::getpid()));
};

std::string text_of_file(const fs::path& file)
{
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

int record(const RecordFolder& folder, std::vector<std::string> words,
           std::vector<std::string> measures = {}, std::string unit = {})
{
    app::Command c;
    c.words = std::move(words);
    c.study = c.words.front();
    c.out = (folder.path / "out").string();
    c.measures = std::move(measures);
    c.unit = std::move(unit);
    c.quiet = true;
    const scenes::Terminal terminal;
    return app::record_command(c);
}

} // namespace

TEST_CASE("record command: a file and a pulse give one table, spectra, histories and pictures",
          "[app][record]")
{
    RecordFolder folder;
    const fs::path file = folder.path / "small.txt";
    std::ofstream(file) << "t [s], a [m/s2]\n0, 0\n0.1, 1\n0.2, -1\n0.3, 0\n";
    (void)record(folder, {file.string(), "ricker(peak 0.5 g, period 0.6 s)"}, {"fiv3(0.3 s)"});
    const fs::path out = folder.path / "out";
    const std::string table = text_of_file(out / "records.csv");
    CHECK_THAT(table, Contains("fiv3(0.3 s) [m/s]"));
    CHECK_THAT(table, Contains("small,two columns,m/s2,0.1,4,0.3,"));
    CHECK_THAT(table, Contains("formula"));
    CHECK_THAT(text_of_file(out / "motions/small.csv"),
               Contains("time_s,acceleration_g,velocity_m_s,displacement_m\n0,0,0,0\n0.1,0."
                        "101971621,0.05,0.0025\n"));
    for (const char* const name :
         {"spectra.csv", "spectra.svg", "records.md", "motions/small.svg",
          "motions/ricker_peak_0.5_g_period_0.6_s.svg"})
        CHECK(fs::exists(out / name));
}

TEST_CASE("record command: bad input is refused with its place, and nothing is written",
          "[app][record]")
{
    RecordFolder folder;
    const fs::path file = folder.path / "bad.txt";
    std::ofstream(file) << "0 0\n0.1 nan\n";
    CHECK_THROWS_WITH(record(folder, {file.string()}),
                      Contains("bad.txt:2: \"nan\" is no finite number"));
    CHECK_THROWS_AS(record(folder, {file.string()}), app::ConfigError);
    CHECK_THROWS_WITH(record(folder, {"sine(peak 1 g)"}), Contains("missing period"));
    CHECK_THROWS_WITH(record(folder, {"sine(peak 1 g, period 1 s)"}, {"pda"}),
                      Contains("--measure"));
    CHECK_THROWS_WITH(record(folder, {"sine(peak 1 g, period 1 s)"}, {}, "feet"),
                      Contains("--acceleration-unit"));
    CHECK_FALSE(fs::exists(folder.path / "out"));
}

TEST_CASE("record command: what is unfit to shake a wall is noted", "[app][record]")
{
    ground::Record r;
    r.motion = ground::pulse("half_sine(peak 0.5 g, duration 0.3 s)");
    const auto table = app::plain(app::record_table({r}, {}));
    CHECK_THAT(std::get<std::string>(table.rows[0].back()), Contains("100 % of the PGV"));
}

TEST_CASE("record command: a million samples make a small picture", "[app][record]")
{
    ground::Record r;
    r.motion = {"long", 0.001, std::vector<double>(1'000'000, 0.0)};
    for (std::size_t i = 0; i < r.motion.acceleration.size(); i += 7)
        r.motion.acceleration[i] = 1.0;
    CHECK(app::motion_svg(r).size() < 200'000);
}
