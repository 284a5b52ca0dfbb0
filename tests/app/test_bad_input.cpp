/// Every case of bad input, through the program: message, exit code, and nothing written.

#include "app/bad_input/cases.hpp"
#include "scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace {

/// For the shell.
std::string for_shell(std::string_view word)
{
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

struct Run {
    int exit_code = -1; ///< -1: did not end by itself
    std::string out, err;
};

/// In the folder `work` of a place; the streams go beside it.
Run run(const fs::path& place, const std::vector<std::string>& arguments)
{
    std::string command =
        "cd " + for_shell((place / "work").string()) + " && " + for_shell(DRYSTONE_PROGRAM);
    for (const std::string& argument : arguments) command += " " + for_shell(argument);
    command += " >../out 2>../err </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, scenes::read_text(place / "out"),
            scenes::read_text(place / "err")};
}

void check_refused(std::string_view study, const std::vector<std::string>& arguments,
                   std::string_view message)
{
    const scenes::TemporaryFolder place;
    const fs::path work = place.path / "work";
    fs::create_directory(work);
    std::ofstream(work / "study.ini", std::ios::binary) << study;

    const Run result = run(place.path, arguments);
    CHECK(result.exit_code == 2);
    CHECK(result.err == std::string(message) + "\n");
    CHECK(result.out.empty());
    std::vector<std::string> left;
    for (const auto& entry : fs::recursive_directory_iterator(work)) {
        left.push_back(entry.path().filename().string());
    }
    CHECK(left == std::vector<std::string>{"study.ini"});
    CHECK(scenes::read_text(work / "study.ini") == study);
}

} // namespace

TEST_CASE("program: a bad study file is refused with exit code 2 and nothing is written",
          "[app][bad_input][program]")
{
    for (const bad_input::BadStudy& bad : bad_input::bad_studies()) {
        INFO(bad.fault);
        check_refused(bad_input::text_of(bad), {"push", "study.ini", "--out", "results"},
                      bad.message);
    }
}

TEST_CASE("program: a bad command line is refused with exit code 2 and nothing is written",
          "[app][bad_input][program]")
{
    for (const bad_input::BadCommand& bad : bad_input::bad_commands()) {
        INFO(bad.fault);
        check_refused(bad_input::kGoodStudy, bad.arguments, bad.message);
    }
}
