#include "app/fragility/numbers/damage_counts.hpp"

#include "app/fragility/damage_curves.hpp"
#include "app/text/config_error.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using app::CountColumns;
using app::DamageCounts;

namespace {

/// Baker (2015), data of the example of the published tools.
const std::string kBaker = "Sa [g],collapsed,analyses\n0.2,0,40\n0.3,0,40\n0.4,0,40\n"
                           "0.6,4,40\n0.7,6,40\n0.8,13,40\n0.9,12,40\n1.0,16,40\n";

DamageCounts counts(const std::string& text, const CountColumns& columns)
{
    return damage_counts(app::parse_csv("counts.csv", text), columns);
}

std::string complaint(const std::string& text, const CountColumns& columns)
{
    try {
        (void)counts(text, columns);
    } catch (const app::ConfigError& e) {
        return e.what();
    }
    return "none";
}

} // namespace

TEST_CASE("damage counts: stripes of a table give the published median and dispersion",
          "[app][damage_counts]")
{
    const DamageCounts d = counts(kBaker, {"Sa", {"collapsed"}, "", "analyses"});
    REQUIRE(d.rows.size() == 8);
    CHECK(d.intensity == "Sa [g]");
    CHECK(d.states == std::vector<std::string>{"collapsed"});
    CHECK(d.rows[3].walls == std::vector<double>{36.0, 4.0});
    const auto fit = fragility::fit_ordinal(d.rows);
    CHECK(fit.medians.at(0) == Approx(1.0761157943).epsilon(1e-9));
    CHECK(fit.dispersion == Approx(0.4292372038).epsilon(1e-9));
}

TEST_CASE(
    "damage counts: several limit states become ordered states; rows of one intensity add up",
    "[app][damage_counts]")
{
    const DamageCounts d = counts("pga;slight;heavy;n\n0,2;9;1;20\n0,1;1;0;20\n0,2;1;0;20\n",
                                  {"pga", {"slight", "heavy"}, "", "n"});
    REQUIRE(d.rows.size() == 2);
    CHECK(d.rows[0].intensity == 0.1);
    CHECK(d.rows[0].walls == std::vector<double>{19.0, 1.0, 0.0});
    CHECK(d.rows[1].walls == std::vector<double>{30.0, 9.0, 1.0});
}

TEST_CASE("damage counts: damage states row by row", "[app][damage_counts]")
{
    const DamageCounts one = counts("pga,ds\n0.1,0\n0.1,2\n0.2,1\n", {"pga", {}, "ds", ""});
    REQUIRE(one.rows.size() == 2);
    CHECK(one.rows[0].walls == std::vector<double>{1.0, 0.0, 1.0});
    CHECK(one.rows[1].walls == std::vector<double>{0.0, 1.0, 0.0});
    CHECK(one.states == std::vector<std::string>{"ds >= 1", "ds >= 2"});
    const DamageCounts many =
        counts("pga,ds,houses\n0.1,0,12\n0.1,1,3\n", {"pga", {}, "ds", "houses"});
    CHECK(many.rows[0].walls == std::vector<double>{12.0, 3.0});
}

TEST_CASE("damage counts: faults are named by row and column", "[app][damage_counts]")
{
    const CountColumns c{"x", {"failed"}, "", "of"};
    CHECK(complaint("x,failed,of\n1,3,2\n", c) ==
          "counts.csv:2: failed: 3 is more than 2 in column \"of\"");
    CHECK(complaint("x,failed,of\n0,3,20\n", c).find("counts.csv:2: x: is 0") == 0);
    CHECK(complaint("x,failed,of\n1,3,20\n2,,20\n", c).find("counts.csv:3: failed: empty") ==
          0);
    CHECK(complaint("x,failed,of\n1,-3,20\n", c).find("is negative") != std::string::npos);
    CHECK(complaint("x,failed,n\n1,3,20\n", c).find("of: no such column") != std::string::npos);
    CHECK(complaint("x,a,b,of\n1,3,4,20\n", {"x", {"a", "b"}, "", "of"})
              .find("4 is more than 3 in column \"a\", the milder state") != std::string::npos);
    CHECK(complaint("x,failed,of\n1,3,1e308\n", c) ==
          "counts.csv:2: of: 1e+308 is more than 1000000000; write a number of walls");
    CHECK(complaint("x,ds,of\n1,1,2e9\n", {"x", {}, "ds", "of"}).find("counts.csv:2: of: ") ==
          0);
    CHECK(complaint("x,ds\n1,0.5\n", {"x", {}, "ds", ""}).find("is not a damage state") !=
          std::string::npos);
}

TEST_CASE("damage curves: a table of fits, one of each curve, and a picture",
          "[app][damage_counts]")
{
    const auto out = damage_output(counts(kBaker, {"Sa", {"collapsed"}, "", "analyses"}), 0.95);
    REQUIRE(out.tables.size() == 2);
    CHECK(out.tables[0].name == "fragility_curves");
    REQUIRE(out.tables[0].table.rows.size() == 1);
    CHECK(out.tables[0].table.rows[0].size() == out.tables[0].table.head.size());
    CHECK(out.tables[1].table.rows.size() == 8);
    CHECK(out.pictures.size() == 1);
    CHECK(out.remarks.empty());
    const auto none =
        damage_output(counts("x,failed,of\n1,0,9\n2,0,9\n", {"x", {"failed"}, "", "of"}), 0.95);
    CHECK(none.remarks.find("failed: no curve: state 1 never occurs") == 0);
}

TEST_CASE("damage curves: the largest counts that are taken have a curve or a reason",
          "[app][damage_counts]")
{
    for (const std::string of : {"1e9", "999999999"}) {
        const auto out = damage_output(counts("x,failed,of\n1,1," + of + "\n2,5," + of + "\n",
                                              {"x", {"failed"}, "", "of"}),
                                       0.95);
        CHECK(out.tables[0].table.rows.size() == 1);
    }
}
