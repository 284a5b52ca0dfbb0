#include "app/input/study/study_file.hpp"

#include "app/text/text_file.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <string_view>
#include <vector>

using app::parse_study_text;
using Assignments = std::vector<std::string>;

TEST_CASE("study file: every value knows its section and its line", "[app][study_file]")
{
    const app::StudyFile file =
        parse_study_text("a.ini", "# a wall\n"
                                  "[wall]\n"
                                  "length = 1.00 m   # along = the push\n"
                                  "\n"
                                  "  courses=10\n"
                                  "[load]\n"
                                  "vertical_stress\t=\t0.15, 0.50 MPa");
    REQUIRE(file.entries.size() == 3);
    CHECK(file.entries[0].key == "wall.length");
    CHECK(file.entries[0].value == "1.00 m");
    CHECK(file.entries[0].line == 3);
    CHECK(file.entries[1].key == "wall.courses");
    CHECK(file.entries[1].value == "10");
    CHECK(file.entries[1].line == 5);
    CHECK(file.entries[2].key == "load.vertical_stress");
    CHECK(file.entries[2].value == "0.15, 0.50 MPa");
    CHECK(file.entries[2].line == 7);
    REQUIRE(file.sections.size() == 2);
    CHECK(file.sections[1].name == "load");
    CHECK(file.sections[1].line == 6);
    CHECK(file.last_line == 7);
}

TEST_CASE("study file: CRLF line ends and a byte order mark change nothing",
          "[app][study_file]")
{
    const auto file = parse_study_text("a.ini", "\xef\xbb\xbf[wall]\r\n\r\ncourses = 10 # c\r\n"
                                                "length = 1 m\r\n");
    REQUIRE(file.entries.size() == 2);
    CHECK(file.entries[0].key == "wall.courses");
    CHECK(file.entries[0].value == "10");
    CHECK(file.entries[0].line == 3);
    CHECK(file.entries[1].value == "1 m");
    CHECK(file.entries[1].line == 4);
}

TEST_CASE("study file: a value of carriage returns alone is empty", "[app][study_file]")
{
    CHECK_THROWS_WITH(parse_study_text("a.ini", "[wall]\nbond = \r\r\n"),
                      "a.ini:2: wall.bond: empty value; write one after the =");
}

TEST_CASE("study file: a section may be opened twice", "[app][study_file]")
{
    const auto file = parse_study_text("a.ini", "[a]\nx = 1\n[b]\nx = 2\n[a]\ny = 3\n");
    REQUIRE(file.entries.size() == 3);
    CHECK(file.entries[2].key == "a.y");
    REQUIRE(file.sections.size() == 2);
    CHECK(file.sections[0].line == 1);
}

TEST_CASE("study file: --set replaces a value of the file, or adds one", "[app][study_file]")
{
    const auto file = app::with_overrides(parse_study_text("a.ini", "[wall]\nlength = 1 m\n"),
                                          Assignments{"wall.length = 2 m", "wall.courses=9"});
    REQUIRE(file.entries.size() == 2);
    CHECK(file.entries[0].key == "wall.length");
    CHECK(file.entries[0].value == "2 m");
    CHECK(file.entries[0].line == 0);
    CHECK(file.entries[1].key == "wall.courses");
    CHECK(file.entries[1].value == "9");
}

TEST_CASE("study file: --set of nothing takes a key out of the file, and refuses one that is "
          "not there",
          "[app][study_file]")
{
    const auto file = parse_study_text("a.ini", "[wall]\nlength = 1 m\ncourses = 9\n");
    const auto without = app::with_overrides(file, Assignments{"wall.length="});
    REQUIRE(without.entries.size() == 1);
    CHECK(without.entries[0].key == "wall.courses");
    CHECK(app::with_overrides(file, Assignments{"wall.length=", "wall.length=2 m"})
              .entries.size() == 2);
    CHECK_THROWS_WITH(
        app::with_overrides(file, Assignments{"wall.lenght="}),
        Catch::Contains("wall.lenght: empty value of a key that is not in the file"));
}

TEST_CASE("study file: an error stands where the key is, else its section, else the end",
          "[app][study_file]")
{
    const auto file = app::with_overrides(
        parse_study_text("a.ini", "# a\n[wall]\nlength = 1 m\nthickness = 1 m\n\n"),
        Assignments{"wall.thickness=2 m"});
    CHECK(std::string(app::error_at(file, "wall.length", "why").what()) ==
          "a.ini:3: wall.length: why");
    CHECK(std::string(app::error_at(file, "wall.thickness", "why").what()) ==
          "--set: wall.thickness: why");
    CHECK(std::string(app::error_at(file, "wall.courses", "why").what()) ==
          "a.ini:2: wall.courses: why");
    CHECK(std::string(app::error_at(file, "load.height", "why").what()) ==
          "a.ini:5: load.height: why");
}

TEST_CASE("study file: text is well-formed UTF-8 without NUL", "[app][study_file]")
{
    using namespace std::string_view_literals;
    CHECK(app::is_text("plain, \xc3\xa9, \xe2\x82\xac, \xf0\x9f\xa7\xb1"));
    const std::string_view bad =
        GENERATE("\0"sv, "\x80"sv, "\xc3"sv, "\xc0\xaf"sv, "\xe0\x80\xaf"sv, "\xed\xa0\x80"sv,
                 "\xf0\x80\x80\x80"sv, "\xf4\x90\x80\x80"sv, "\xff\xfe"sv, "\xe2\x82"sv,
                 "\xe2\x82z"sv, "\xf0\x9f\xa7z"sv);
    CHECK_FALSE(app::is_text(bad));
}
