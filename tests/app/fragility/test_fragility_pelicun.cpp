#include "app/fragility/drift_csv.hpp"
#include "app/fragility/numbers/fragility_limits.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace {

app::Csv read(const app::DriftData& data)
{
    return app::parse_csv("pelicun.csv", app::pelicun_csv(data));
}

std::string cell(const app::Csv& csv, std::size_t row, const std::string& column)
{
    for (std::size_t c = 0; c < csv.head.size(); ++c)
        if (csv.head[c] == column) return csv.rows.at(row).cells[c];
    throw std::out_of_range(column);
}

} // namespace

TEST_CASE("pelicun: the head is that of its damage databases of four limit states",
          "[app][fragility_pelicun]")
{
    // first line of damage_DB_Hazus_EQ_story.csv of pelicun 3, and a column it passes over:
    // names with "LS" are limit states to it (DamageModel_DS._create_dmg_RVs)
    const std::string head =
        "ID,Incomplete,Demand-Type,Demand-Unit,Demand-Offset,Demand-Directional,"
        "LS1-Family,LS1-Theta_0,LS1-Theta_1,LS1-DamageStateWeights,"
        "LS2-Family,LS2-Theta_0,LS2-Theta_1,LS2-DamageStateWeights,"
        "LS3-Family,LS3-Theta_0,LS3-Theta_1,LS3-DamageStateWeights,"
        "LS4-Family,LS4-Theta_0,LS4-Theta_1,LS4-DamageStateWeights,Notes\n";
    CHECK(app::pelicun_csv(scenes::drifts({{1.0}})).starts_with(head));
}

TEST_CASE("pelicun: parameters are the median in radians and the dispersion of the logarithm",
          "[app][fragility_pelicun]")
{
    const app::Csv csv = read(scenes::drifts({{1.0, 2.0, 4.0, 2.0}}));
    REQUIRE(csv.rows.size() == 1);
    CHECK(cell(csv, 0, "ID") == "DRYSTONE.ntc.group_0");
    CHECK(cell(csv, 0, "Incomplete") == "0");
    CHECK(cell(csv, 0, "Demand-Type") == "Peak Interstory Drift Ratio");
    CHECK(cell(csv, 0, "Demand-Unit") == "rad");
    CHECK(cell(csv, 0, "Demand-Offset") == "0");
    CHECK(cell(csv, 0, "Demand-Directional") == "1");
    CHECK(cell(csv, 0, "LS1-Family") == "lognormal");
    CHECK(std::stod(cell(csv, 0, "LS1-Theta_0")) == Approx(0.02).epsilon(1e-5));
    CHECK(std::stod(cell(csv, 0, "LS1-Theta_1")) ==
          Approx(std::log(2.0) * std::sqrt(0.5)).epsilon(1e-5));
    CHECK(cell(csv, 0, "LS2-Family").empty());
}

TEST_CASE("pelicun: notes say how far walls were seen, and what lies beyond is not given",
          "[app][fragility_pelicun]")
{
    CHECK(cell(read(scenes::drifts({{1.0, 2.0, 4.0, 2.0}})), 0, "Notes") ==
          "group 0: LS1 tested up to 0.04 rad");
    const app::Csv csv = read(scenes::drifts({{1.0, 2.0, -2.5, -2.5, -2.5, -2.5, -2.5}}));
    CHECK(cell(csv, 0, "Incomplete") == "1");
    CHECK(cell(csv, 0, "LS1-Theta_0").empty());
    CHECK(cell(csv, 0, "Notes")
              .ends_with("84 % of the walls reach it beyond the drift tested, 0.025 rad"));
}

TEST_CASE("pelicun: what cannot be fitted is incomplete and has no parameters",
          "[app][fragility_pelicun]")
{
    app::DriftData data = scenes::drifts({{-2.0, -2.0, -2.0}, {}, {1.0, 2.0, 4.0}});
    app::Csv csv = read(data);
    for (const std::size_t r : {std::size_t{0}, std::size_t{1}}) {
        CHECK(cell(csv, r, "Incomplete") == "1");
        CHECK(cell(csv, r, "LS1-Theta_0").empty());
    }
    CHECK(cell(csv, 2, "Incomplete") == "0");
    data.percent = 0.0; // of no known unit
    csv = read(data);
    CHECK(cell(csv, 2, "Incomplete") == "1");
    CHECK(cell(csv, 2, "LS1-Theta_0").empty());
}

TEST_CASE("pelicun: limit states come in the order of their medians, five in two components",
          "[app][fragility_pelicun]")
{
    app::DriftData data = scenes::drifts({{1.0, 2.0, 4.0}});
    data.states.assign(5, data.states[0]);
    for (app::DriftWall& w : data.groups[0].walls) {
        const double d = w.limits[0]->lower;
        w.limits = {fragility::observed(3.0 * d), fragility::observed(d),
                    fragility::observed(2.0 * d), fragility::observed(4.0 * d),
                    fragility::observed(5.0 * d)};
    }
    const app::Csv csv = read(data);
    REQUIRE(csv.rows.size() == 2);
    CHECK(std::stod(cell(csv, 0, "LS1-Theta_0")) == Approx(0.02).epsilon(1e-5));
    CHECK(std::stod(cell(csv, 0, "LS3-Theta_0")) == Approx(0.06).epsilon(1e-5));
    CHECK(cell(csv, 0, "ID") != cell(csv, 1, "ID"));
    CHECK(std::stod(cell(csv, 1, "LS1-Theta_0")) == Approx(0.10).epsilon(1e-5));
}

TEST_CASE("pelicun: no two groups share an ID, whatever signs their names have",
          "[app][fragility_pelicun]")
{
    const std::vector<std::string> names = {
        "\u03b1", "\u03b2", "A/B", "A b", "a_b", "A-B", "gr\u00f6\u00dfe", "gr\u00fc\u00dfe"};
    app::DriftData data = scenes::drifts(std::vector(names.size(), std::vector{1.0, 2.0, 4.0}));
    for (std::size_t g = 0; g < names.size(); ++g) data.groups[g].name = names[g];
    const app::Csv csv = read(data);
    std::set<std::string> ids;
    for (std::size_t r = 0; r < csv.rows.size(); ++r) {
        ids.insert(cell(csv, r, "ID"));
        CHECK(cell(csv, r, "ID").find_first_of("-,\" ") == std::string::npos);
        CHECK(cell(csv, r, "Notes").starts_with(names[r] + ": ")); // which is which
    }
    CHECK(ids.size() == names.size());
}
