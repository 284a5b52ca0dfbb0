/// The pages in docs/ and the studies in configs/ keep their word: studies read, commands are
/// commands, links and tests that are named are there. tests/docs/test_cookbook.sh runs the
/// recipes.

#include "app/input/command_line.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/verbs.hpp"
#include "scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path kRoot = DRYSTONE_SOURCE_DIR;

std::vector<fs::path> files(const fs::path& folder, const std::string& extension)
{
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == extension) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    REQUIRE_FALSE(found.empty());
    return found;
}

std::vector<fs::path> pages()
{
    std::vector<fs::path> all = files(kRoot / "docs", ".md");
    all.insert(all.begin(), kRoot / "README.md");
    return all;
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern)
{
    std::vector<std::string> found;
    const std::regex form(pattern);
    for (std::sregex_iterator m(text.begin(), text.end(), form), end; m != end; ++m)
        found.push_back((*m)[1]);
    return found;
}

/// Words of a command line as a shell has them: quotes hold blanks together, # ends the line.
std::vector<std::string> words(const std::string& line)
{
    std::vector<std::string> all(1);
    char quote = 0;
    for (const char c : line) {
        if (quote == 0 && c == '#' && all.back().empty()) break;
        if (c == quote || (quote == 0 && (c == '"' || c == '\'')))
            quote = quote == 0 ? c : 0;
        else if (c == ' ' && quote == 0)
            all.emplace_back();
        else
            all.back() += c;
    }
    std::erase(all, "");
    return all;
}

/// Command lines in the fenced parts of a page, without the name of the program.
std::vector<std::string> commands(const fs::path& page)
{
    std::istringstream text(scenes::read_text(page));
    std::vector<std::string> found;
    bool fenced = false;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("```")) fenced = !fenced;
        if (fenced && line.starts_with("./drystone ")) found.push_back(line.substr(11));
    }
    return found;
}

/// Anchors of the headings of a page as links name them: lower case, blanks as hyphens, no
/// other signs.
std::set<std::string> anchors(const fs::path& page)
{
    std::set<std::string> all;
    for (const std::string& heading : matches(scenes::read_text(page), "\n#+ ([^\n]*)")) {
        std::string anchor;
        for (const unsigned char c : heading)
            if (std::isalnum(c) != 0 || c == '_' || c == '-')
                anchor += static_cast<char>(std::tolower(c));
            else if (c == ' ')
                anchor += '-';
        all.insert(anchor);
    }
    return all;
}

} // namespace

TEST_CASE("docs: every picture has a ground of its own, for pages that are dark", "[app][docs]")
{
    for (const fs::path& file : files(kRoot / "docs", ".svg")) {
        const std::string text = scenes::read_text(file);
        const std::size_t first = text.find("<rect"), end = text.find('>', first);
        INFO(file.string());
        REQUIRE(first != std::string::npos);
        CHECK(std::regex_search(text.substr(first, end - first),
                                std::regex("fill=\"(white|#fff)\"")));
        CHECK(text.substr(0, first).find("<text") == std::string::npos);
        CHECK(text.find("<title></title>") == std::string::npos);
    }
}

TEST_CASE("docs: every shipped study reads, and every value of it says where it is from",
          "[app][docs]")
{
    for (const fs::path& path : files(kRoot / "configs", ".ini")) {
        INFO(path.filename());
        CHECK_NOTHROW(app::prepare(app::read_study(app::read_study_file(path.string()))).study);
        std::istringstream text(scenes::read_text(path));
        for (std::string line; std::getline(text, line);) {
            INFO(line);
            if (line.find('=') != std::string::npos && line[0] != '#')
                CHECK(line.find(" # ") != std::string::npos);
        }
    }
}

TEST_CASE("docs: every command of every page is one, and its study reads", "[app][docs]")
{
    std::size_t read = 0;
    for (const fs::path& page : pages())
        for (const std::string& line : commands(page)) {
            INFO(page.filename() << ": " << line);
            const std::vector<std::string> all = words(line);
            if (all.front() == "test" || all.front() == "python" || all.back() == "--help")
                continue; // verbs of the launcher
            app::Command command;
            REQUIRE_NOTHROW(command = app::parse_command_line(app::verbs(), all));
            if (!command.study.starts_with("configs/") || !command.study.ends_with(".ini") ||
                line.find("=runs/") != std::string::npos) // needs what an earlier one writes
                continue;
            const std::string study = (kRoot / command.study).string();
            CHECK_NOTHROW(app::prepare(app::read_study(app::with_overrides(
                                           app::read_study_file(study), command.overrides)))
                              .study);
            ++read;
        }
    CHECK(read > 20);
}

TEST_CASE("docs: every link leads to a file, and to a heading of it", "[app][docs][repeats]")
{
    std::size_t headings = 0;
    for (const fs::path& page : pages()) {
        const std::string text = scenes::read_text(page);
        for (const std::string& link : matches(text, R"(\]\(([^):]+)\))")) {
            INFO(page.filename() << ": " << link);
            const std::string file = link.substr(0, link.find('#'));
            const fs::path target = file.empty() ? page : page.parent_path() / file;
            REQUIRE(fs::exists(target));
            if (file.size() == link.size()) continue;
            CHECK(anchors(target).contains(link.substr(file.size() + 1)));
            ++headings;
        }
    }
    CHECK(headings > 20);
}

TEST_CASE("docs: every test that the page of verification names is there",
          "[app][docs][repeats]")
{
    std::string names;
    for (const fs::path& source : files(kRoot / "tests", ".cpp"))
        for (const std::string& name :
             matches(scenes::read_text(source), R"rx(TEST_CASE\(\s*((?:"[^"]*"\s*)+))rx"))
            names += std::regex_replace(name, std::regex(R"("\s*"|")"), "") + "\n";
    std::size_t named = 0;
    for (std::string name : matches(scenes::read_text(kRoot / "docs" / "verification.md"),
                                    "`([A-Za-z_-][A-Za-z_ -]*: [^`]*)`")) {
        INFO(name);
        if (name.ends_with("...")) name.resize(name.size() - 3);
        CHECK(names.find(name) != std::string::npos);
        ++named;
    }
    CHECK(named > 80);
}
