#include "app/input/study/code_file.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/study_scenes.hpp"
#include "app/text/config_error.hpp"
#include "fragility/codes/code_table.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

constexpr const char* kMine = R"({"codes": [
  {"name": "mine", "title": "Guideline # 7", "states": [
    {"name": "LS", "rule": "3/4 CP", "source": "guideline"},
    {"name": "CP", "rule": "ultimate", "source": "guideline",
     "drift": {"rocking": "0.6 % H0/D", "other": "0.3 %"}}]},
  {"name": "ntc", "title": "Another NTC", "states": [
    {"name": "SLV", "rule": "peak", "source": "me"}]}]}
)";

std::string study_text(const std::string& fragility)
{
    return std::string(study_scenes::kSmall) + "[uq]\nsamples = 1\n[fragility]\n" + fragility;
}

/// A study in a folder, beside a file mine.json.
app::Study study_beside(const scenes::TemporaryFolder& folder, const std::string& table,
                        const std::string& sets)
{
    std::ofstream(folder.path / "mine.json") << table;
    return app::read_study(
        app::parse_study_text((folder.path / "wall.ini").string(),
                              study_text("codes = mine.json\nlimit_states = " + sets + "\n")));
}

std::vector<std::string> names(const app::Study& study)
{
    std::vector<std::string> all;
    for (const app::StateName& s : app::state_names(app::reading_rules(study)))
        all.push_back(app::state_name(s));
    return all;
}

} // namespace

TEST_CASE("code file: codes of a user are read from the folder of the study, and stand before "
          "those of the program",
          "[app][code_file]")
{
    const scenes::TemporaryFolder folder;
    const app::Study study = study_beside(folder, kMine, "mine, ntc, ec8");
    CHECK(names(study) == std::vector<std::string>{"mine LS", "mine CP", "ntc SLV", "ec8 DL",
                                                   "ec8 SD", "ec8 NC"});
}

TEST_CASE(
    "code file: a path of --set counts from the current folder, not from that of the study",
    "[app][code_file]")
{
    const scenes::TemporaryFolder folder;
    std::ofstream(folder.path / "mine.json") << kMine;
    const std::filesystem::path here = std::filesystem::relative(folder.path / "mine.json");
    const std::vector<std::string> given = {"fragility.codes=" + here.string()};
    const app::StudyFile file = app::parse_study_text( // no way leads through its folder
        (folder.path / "none" / "wall.ini").string(), study_text("limit_states = mine\n"));
    CHECK(names(app::read_study(app::with_overrides(file, given))) ==
          std::vector<std::string>{"mine LS", "mine CP"});
}

TEST_CASE("study file: a path of the file counts from its folder, one of --set does not",
          "[app][code_file]")
{
    const app::StudyFile file =
        app::parse_study_text("configs/wall.ini", "[shaking]\nrecords = a.txt\n");
    const std::vector<std::string> given = {"shaking.records=a.txt"};
    const app::StudyFile set = app::with_overrides(file, given);
    CHECK(app::path_from(file, "shaking.records", "a.txt") == "configs/a.txt");
    CHECK(app::path_from(file, "shaking.records", "/b/a.txt") == "/b/a.txt");
    CHECK(app::path_from(set, "shaking.records", "a.txt") == "a.txt");
}

TEST_CASE("code file: the drift limit of a user's code follows the mode and H0/D of the wall",
          "[app][code_file]")
{
    const scenes::TemporaryFolder folder;
    const app::ReadingRules rules = app::reading_rules(study_beside(folder, kMine, "mine"));
    const std::vector<double> x = {0.0, 0.01, 1.0}, f = {0.0, 5.0, 5.0}; // never falls
    const auto cp = [&](double rotation) {
        const dem::Mechanism m{.rotation_share = rotation, .turning_share = rotation};
        const auto limit = app::read({x, f}, m, rules).limits.back();
        CHECK(limit.reason == "governed by the code's drift limit");
        return limit.displacement / rules.height;
    };
    CHECK(cp(0.9) == Approx(0.006 * rules.slenderness).epsilon(1e-12));
    CHECK(cp(0.1) == Approx(0.003).epsilon(1e-12));
}

TEST_CASE("code file: a study that was read stands alone, without the file", "[app][code_file]")
{
    std::string alone, text;
    std::vector<std::string> before;
    {
        const scenes::TemporaryFolder folder;
        const app::Study study = study_beside(folder, kMine, "mine");
        before = names(study);
        alone = app::effective_configuration(study);
        text = study.fragility.codes;
    }
    const app::Study again = app::read_study(app::parse_study_text("alone.ini", alone));
    CHECK(names(again) == before);
    REQUIRE(again.fragility.own_codes.size() == 2);
    CHECK(again.fragility.own_codes.front().title == "Guideline # 7");
    CHECK(again.fragility.codes == text);
}

TEST_CASE("code file: errors name the file and its line, the key, and what to write",
          "[app][code_file]")
{
    const scenes::TemporaryFolder folder;
    const std::string file = (folder.path / "mine.json").string();
    CHECK_THROWS_WITH(
        study_beside(folder, "{\"codes\": [\n{\"name\": \"mine\"}]}", "mine"),
        Catch::Equals(file + ":2: mine.title: is missing; write the name of the code and its "
                             "year"));
    CHECK_THROWS_WITH(study_beside(folder, kMine, "mien"),
                      Catch::Contains("wall.ini:") &&
                          Catch::Contains("fragility.limit_states: \"mien\" is not a set; ") &&
                          Catch::Contains("mine"));
    CHECK_THROWS_WITH(
        app::read_study(
            app::parse_study_text("wall.ini", study_text("codes = nowhere.json\n"))),
        Catch::StartsWith("nowhere.json: ") && Catch::Contains("fragility/codes/codes.json"));
    CHECK_THROWS_WITH(app::read_study(app::parse_study_text(
                          "wall.ini", study_text("codes = {\"codes\": 1}\n"))),
                      Catch::StartsWith("wall.ini:") &&
                          Catch::Contains("fragility.codes: codes: must be a list of objects"));
}

TEST_CASE(
    "code file: a code of which nothing is given is refused with the reason and the remedy",
    "[app][code_file]")
{
    for (const char* code : {"tbdy2018", "asce41", "fema356"})
        CHECK_THROWS_WITH(
            study_scenes::study(std::string("samples = 1\n[fragility]\nlimit_states = ") +
                                code),
            Catch::Contains("nothing is given here: ") &&
                Catch::Contains("write its limit states into a file of your own"));
}

TEST_CASE("code file: docs/codes.md is current", "[app][code_file]")
{
    INFO("write it anew: ./drystone help codes > docs/codes.md");
    CHECK(scenes::read_text(std::string(DRYSTONE_SOURCE_DIR) + "/docs/codes.md") ==
          app::codes_page());
}

TEST_CASE("code file: the example of the page is a table that can be read", "[app][code_file]")
{
    const std::string page = app::codes_page(), begin = "```json\n";
    const auto from = page.find(begin) + begin.size();
    const auto codes =
        fragility::read_code_table(page.substr(from, page.find("```", from) - from));
    REQUIRE(codes.size() == 1);
    CHECK(fragility::limits_drift(codes.front()));
}
