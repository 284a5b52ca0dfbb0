#include "app/study/fragility_text.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

TEST_CASE(
    "fragility text: bounds that the data do not give are words, values that are no numbers "
    "are nothing",
    "[app][fragility_text]")
{
    const double inf = std::numeric_limits<double>::infinity();
    CHECK(app::with_interval(1.576, 1.4, inf, 2) == "1.58 [1.40, no limit]");
    CHECK(app::with_interval(std::nan(""), 1.0, 2.0, 2).empty());
    CHECK(app::with_error(16.24, 0.31, 1) == "16.2 +- 0.3");
    CHECK(app::with_error(16.24, inf, 1) == "16.2");
}

TEST_CASE("fragility text: plain numbers have intervals and errors in columns of their own",
          "[app][fragility_text]")
{
    const app::Table t{"c",
                       {"n", "median [%]", "force [kN]"},
                       {{"3", "1.58 [1.40, no limit]", "16.2 +- 0.3"},
                        {"0", "not identifiable: median > 2", "12.0 (1 wall)"}}};
    const app::Table p = app::plain_numbers(t);
    CHECK(p.head == std::vector<std::string>{"n", "median [%]", "median lower [%]",
                                             "median upper [%]", "force [kN]",
                                             "force std error [kN]"});
    CHECK(p.rows[0] == std::vector<std::string>{"3", "1.58", "1.40", "", "16.2", "0.3"});
    CHECK(p.rows[1] == std::vector<std::string>{"0", "not identifiable: median > 2", "", "",
                                                "12.0 (1 wall)", ""});
}

TEST_CASE(
    "fragility text: numbers beyond the end of the walls are marked, and the mark is a column "
    "of its own for programs",
    "[app][fragility_text]")
{
    const std::string whole = app::with_interval(3.03, 1.97, 9.67, 2, 2.72);
    CHECK(whole == "3.03† [1.97, 9.67†]");
    CHECK(app::with_interval(2.11, 1.67, 2.87, 2, 2.72) == "2.11 [1.67, 2.87†]");
    CHECK(app::with_mark(2.72, 2, 2.72) == "2.72");
    CHECK(app::with_mark(2.725, 3, 2.72) == "2.725"); // one interval of 0.05 mm of 30 mm
    CHECK(app::with_mark(2.726, 3, 2.72) == "2.726†");
    const app::Table p = app::plain_numbers(
        {"", {"95 % drift [%]"}, {{whole}, {"2.11 [1.67, 2.87†]"}, {"not identifiable"}}});
    CHECK(p.head == std::vector<std::string>{"95 % drift [%]", "95 % drift extrapolated",
                                             "95 % drift lower [%]", "95 % drift upper [%]"});
    CHECK(p.rows[0] == std::vector<std::string>{"3.03", "1", "1.97", "9.67"});
    CHECK(p.rows[1] == std::vector<std::string>{"2.11", "0", "1.67", "2.87"});
    CHECK(p.rows[2] == std::vector<std::string>{"not identifiable", "", "", ""});
    CHECK(app::as_latex({"", {"a"}, {{whole}}}).find("3.03\\dag{} [1.97") != std::string::npos);
}

TEST_CASE("fragility text: a lower bound is rounded down, and says whether it may be reached",
          "[app][fragility_text]")
{
    CHECK(app::rounded_down(2.7259, 2) == "2.72");
    CHECK(app::rounded_down(0.29, 2) == "0.29");
    CHECK(app::rounded_down(2.5, 1) == "2.5");
    CHECK(app::median_bound({0.95, true, 2.7259, true}, 2) == "> 2.72");
    CHECK(app::median_bound({0.95, true, 2.7259, false}, 2) == ">= 2.72");
    CHECK(app::median_bound({}, 2).empty());
}

TEST_CASE("fragility text: names of files have no path in them", "[app][fragility_text]")
{
    CHECK(app::file_name("0.75 MPa") == "0.75_MPa");
    CHECK(app::file_name("../x") == "_.._x");
    CHECK(app::file_name("").size() == 1);
}
