#include "app/fragility/drift_csv.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

using app::parse_csv;

namespace {

app::DriftData read(const std::string& text, const app::DriftColumns& columns)
{
    return app::drift_data(parse_csv("walls.csv", text), columns);
}

} // namespace

TEST_CASE("drift CSV: quoted cells keep separators, quotes and line breaks", "[app][drift_csv]")
{
    const auto csv =
        parse_csv("x.csv", "\xEF\xBB\xBF\"a, b\",c\r\n\"say \"\"so\"\"\r\nor not\",2\r\n");
    CHECK(csv.head == std::vector<std::string>{"a, b", "c"});
    REQUIRE(csv.rows.size() == 1);
    CHECK(csv.rows[0].cells == std::vector<std::string>{"say \"so\"\r\nor not", "2"});
}

TEST_CASE("drift CSV: commas, semicolons and tabs are told apart by the head",
          "[app][drift_csv]")
{
    const std::string text = "wall;drift [%];stopped\nA;1,5;0\nB;2,25;1\n";
    const auto data = read(text, {{"drift"}, {"stopped"}, ""});
    CHECK(data.unit == "%");
    REQUIRE(data.groups.size() == 1);
    CHECK(data.groups[0].walls[0].limits[0]->upper == 1.5);
    CHECK(data.groups[0].walls[1].limits[0]->lower == 2.25);
    CHECK(std::isinf(data.groups[0].walls[1].limits[0]->upper));
    CHECK(parse_csv("x", "a\tb\n1\t2\n").separator == '\t');
}

TEST_CASE("drift CSV: groups keep their rows and are ordered by number", "[app][drift_csv]")
{
    const auto data = read("s,d\n10,1\n2,3\n10,2\n", {{"d"}, {}, "s"});
    REQUIRE(data.groups.size() == 2);
    CHECK(data.groups[0].name == "2");
    CHECK(data.groups[1].walls.size() == 2);
}

TEST_CASE("drift CSV: radians and ratios are 100 percent each, unknown units are nothing",
          "[app][drift_csv]")
{
    CHECK(read("d [rad]\n0.01\n", {{"d"}, {}, ""}).percent == 100.0);
    CHECK(read("d [%]\n1\n", {{"d"}, {}, ""}).percent == 1.0);
    CHECK(read("d [mm]\n1\n", {{"d"}, {}, ""}).percent == 0.0);
}

TEST_CASE("drift CSV: a bad cell is named by row and column", "[app][drift_csv]")
{
    const std::string head = "wall,drift [%],c\nA,1.0,0\n";
    const struct {
        const char* row;
        const char* message;
    } cases[] = {
        {"B,0,0", "walls.csv:3: drift [%]: is 0, where no limit state is reached; write the "
                  "drift, or NA "
                  "if it is not known"},
        {"B,>0,0",
         "walls.csv:3: drift [%]: is a bound of 0, which says nothing of a wall; write "
         "the drift at which it still stood, or NA if it is not known"},
        {"B,0,1",
         "walls.csv:3: drift [%]: is a bound of 0, which says nothing of a wall; write "
         "the drift at which it still stood, or NA if it is not known"},
        {"B,1e308,0",
         "walls.csv:3: drift [%]: \"1e308\" is no drift; it must be in [1e-09, 1e+09]"},
        {"B,> 1e-308,0",
         "walls.csv:3: drift [%]: \"1e-308\" is no drift; it must be in [1e-09, 1e+09]"},
        {"B,\"1.2\"3,0",
         "walls.csv:3: text behind the quote that closes a cell; write a quote inside a "
         "cell as \"\""},
        {"B,nan,0", "walls.csv:3: drift [%]: \"nan\" is not a finite number"},
        {"B,-inf,0", "walls.csv:3: drift [%]: \"-inf\" is not a finite number"},
        {"B,-0.5,0", "walls.csv:3: drift [%]: \"-0.5\" is negative; it must be at least 0"},
        {"B,1.2x,0", "walls.csv:3: drift [%]: \"1.2x\" is not a number"},
        {"B,1.2,maybe",
         "walls.csv:3: c: \"maybe\" does not say whether the value is a bound; write 1, yes or "
         "censored, or 0, no or observed"},
        {"B,1.2", "walls.csv:3: 2 cells, but the head has 3"},
        {"B,\"1.2,0", "walls.csv:3: a quoted cell is not closed; add a \" at its end"}};
    for (const auto& c : cases)
        CHECK_THROWS_WITH(read(head + c.row + "\n", {{"drift"}, {"c"}, ""}),
                          Catch::EndsWith(c.message));
}

TEST_CASE("drift CSV: a table without head, or without the column, is refused",
          "[app][drift_csv]")
{
    CHECK_THROWS_WITH(read("", {{"d"}, {}, ""}), Catch::Contains("no head"));
    CHECK_THROWS_WITH(read("drift\n1\n", {{"drif"}, {}, ""}),
                      Catch::Contains("did you mean \"drift\""));
    CHECK_THROWS_WITH(read("d,d\n1,2\n", {{"d"}, {}, ""}), Catch::Contains("two columns"));
    CHECK_THROWS_WITH(read("d [%],d [mm]\n1,2\n", {{"d"}, {}, ""}),
                      Catch::Contains("add the unit"));
}

TEST_CASE("drift CSV: a head without rows is refused", "[app][drift_csv]")
{
    CHECK_THROWS_WITH(read("d\n", {{"d"}, {}, ""}), Catch::Contains("no row below the head"));
}

TEST_CASE(
    "drift CSV: tables as spreadsheets write them are read: sep=, empty rows, units in round "
    "brackets, NA and bounds in the cell",
    "[app][drift_csv]")
{
    const auto data =
        read("sep=;\r\nwall;drift (%);stopped\r\nA;1,5;n\r\nB;> 2,27;n\r\nC;NA;\r\n"
             "D;1,2;y\r\n;;\r\n;;\r\n",
             {{"drift"}, {"stopped"}, ""});
    CHECK(data.unit == "%");
    CHECK(data.percent == 1.0);
    CHECK(data.states[0].name == "drift");
    const auto& walls = data.groups.at(0).walls;
    REQUIRE(walls.size() == 4);
    CHECK(walls[0].limits[0]->upper == 1.5);
    CHECK(walls[1].limits[0]->lower == 2.27);
    CHECK(std::isinf(walls[1].limits[0]->upper));
    CHECK_FALSE(walls[2].limits[0].has_value());
    CHECK(std::isinf(walls[3].limits[0]->upper));
    CHECK(data.drift.find("1 cell without a value") != std::string::npos);
    // lines of old spreadsheets
    CHECK(
        read("wall,drift [%]\rA,1.5\rB,2.5\r", {{"drift"}, {}, ""}).groups.at(0).walls.size() ==
        2);
}

TEST_CASE("drift CSV: each column of drifts may have a column of censoring of its own",
          "[app][drift_csv]")
{
    const std::string text = "slight [%],a,heavy [%],b\n0.3,0,1.2,1\n0.4,0,1.5,0\n";
    const auto data = read(text, {{"slight", "heavy"}, {"a", "b"}, ""});
    const auto& first = data.groups[0].walls[0].limits;
    CHECK(first[0]->upper == 0.3);
    CHECK(std::isinf(first[1]->upper));
    CHECK_THROWS_WITH(read("x,y,z,a,b\n1,1,1,0,0\n", {{"x", "y", "z"}, {"a", "b"}, ""}),
                      Catch::Contains("give it once, or once for each --drift"));
}

TEST_CASE("drift CSV: all mistakes of a table are named at once", "[app][drift_csv]")
{
    CHECK_THROWS_WITH(
        read("d\n1\nx\n2\n-3\n", {{"d"}, {}, ""}),
        Catch::Equals("walls.csv: 2 mistakes:\n"
                      "walls.csv:3: d: \"x\" is not a number\n"
                      "walls.csv:5: d: \"-3\" is negative; it must be at least 0"));
}
