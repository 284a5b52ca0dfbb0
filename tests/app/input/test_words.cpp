#include "app/text/words.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <string>
#include <string_view>

TEST_CASE("words: the edit distance counts insertions, deletions, replacements and swaps",
          "[app][words]")
{
    CHECK(app::edit_distance("push", "push") == 0);
    CHECK(app::edit_distance("kitten", "sitting") == 3); // the textbook pair
    CHECK(app::edit_distance("psuh", "push") == 1);      // neighbours that changed places
    CHECK(app::edit_distance("ca", "abc") == 3); // which only neighbours of both words do
    CHECK(app::edit_distance("", "abc") == 3);
    CHECK(app::edit_distance("abc", "") == 3);
    CHECK(app::edit_distance("flaw", "lawn") == app::edit_distance("lawn", "flaw"));
}

TEST_CASE("words: the nearest word is suggested only if at most a third of it is wrong",
          "[app][words]")
{
    constexpr std::array<std::string_view, 3> kWords = {"length", "height", "bond"};
    CHECK(app::nearest_word("bnod", kWords) == "bond");
    CHECK(app::nearest_word("lenght", kWords) == "length");
    CHECK(app::nearest_word("hieght", kWords) == "height");
    CHECK(app::nearest_word("bund", kWords) == "bond");
    CHECK(app::nearest_word("bud", kWords) == "");
    constexpr std::array<std::string_view, 3> kNeighbours = {"joint", "point", "joist"};
    CHECK(app::nearest_word("joist", kNeighbours) == "joist");
    CHECK(app::nearest_word("pointt", kNeighbours) == "point");
    CHECK(app::suggestion("lenght", kWords) == "did you mean \"length\"?");
    CHECK(app::suggestion("weight of it", kWords) == "use length, height or bond");
}

TEST_CASE("words: quoted input stays on one line, short, and whole characters", "[app][words]")
{
    CHECK(app::in_quotes("a\nb\x1b[31m") == "\"a?b?[31m\"");
    CHECK(app::in_quotes(std::string(61, 'a')) == '"' + std::string(60, 'a') + "...\"");
    CHECK(app::in_quotes(std::string(59, 'a') + "\xc3\xa9\xc3\xa9") ==
          '"' + std::string(59, 'a') + "...\"");
}

TEST_CASE("words: blanks, tabs and carriage returns are trimmed at the ends only",
          "[app][words]")
{
    CHECK(app::trimmed(" \t a \t b \r") == "a \t b");
    CHECK(app::trimmed(" \t\r").empty());
}
