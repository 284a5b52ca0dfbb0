/// The reading against figures worked out elsewhere for seven measured walls: Lourenço et al.
/// (2005), as digitised in the EPFL Stone Masonry Database (doi 10.5281/zenodo.812145). Needs
/// its force-displacement files in the folder named by the environment variable
/// DRYSTONE_EXPERIMENTS; without it these tests say so and check nothing.

#include "bench/tested/measured_walls.hpp"
#include "fragility/codes/code_table.hpp"
#include "fragility/curve/limit_states.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

using namespace fragility;

namespace {

/// Displacements in mm, forces in kN, with the digits they were printed with.
struct Printed {
    const char* wall;
    double peak;           ///< of the digitised curve
    double slc, slv;       ///< first 80 % crossing: 1 decimal
    double sld, slo;       ///< bilinear through 0.6: 2 decimals
    double yield_07;       ///< bilinear through 0.7: 2 decimals; 0: not printed
    double last;           ///< last 80 % crossing: 1 decimal; 0: not printed
    double yield_database; ///< the database's own yield displacement: 1 decimal
    bool slc_is_end;       ///< end of the test
};

constexpr Printed kPrinted[] = {
    {"SW.30.1", 21.5, 29.9, 22.4, 2.79, 1.86, 0.0, 0.0, 3.6, true},
    {"SW.30.2", 22.7, 9.4, 7.1, 2.62, 1.75, 0.0, 29.9, 3.0, false},
    {"SW.100.1", 41.5, 12.6, 9.4, 2.35, 1.57, 5.27, 17.1, 5.3, false},
    {"SW.100.2", 48.2, 18.9, 14.2, 3.85, 2.56, 4.39, 0.0, 4.4, false},
    {"SW.200.1", 72.2, 16.1, 12.1, 2.94, 1.96, 3.96, 0.0, 4.0, false},
    {"SW.200.2", 68.6, 22.6, 17.0, 4.47, 2.98, 4.69, 0.0, 4.8, true},
    {"SW.250.1", 102.5, 9.3, 7.0, 2.83, 1.89, 3.66, 16.8, 4.1, false},
};

/// Half a unit of the last printed digit; the rest is for 22.65, printed 22.6.
auto printed(double value, int decimals)
{
    return Approx(value).epsilon(0.0).margin(0.5 * std::pow(10.0, -decimals) + 1e-9);
}

/// By name; empty, with a message, if there is no folder.
std::map<std::string, bench::CurveTable> measured_walls()
{
    std::map<std::string, bench::CurveTable> walls;
    const char* folder = std::getenv("DRYSTONE_EXPERIMENTS");
    if (folder == nullptr) {
        WARN("skipped: DRYSTONE_EXPERIMENTS does not name a folder");
        return walls;
    }
    for (const bench::StressLevel& level : bench::kLevels)
        for (const bench::MeasuredWall& w : bench::read_series(folder, level.series))
            walls[w.name] = w.table;
    REQUIRE(walls.size() == std::size(kPrinted));
    return walls;
}

/// The printed figures were worked out on curves with one point, the first, at each
/// displacement.
bench::CurveTable first_at_each_displacement(const bench::CurveTable& all)
{
    bench::CurveTable out;
    for (std::size_t i = 0; i < all.force_kN.size(); ++i) {
        if (i > 0 && all.displacement_mm[i] == all.displacement_mm[i - 1]) continue;
        out.displacement_mm.push_back(all.displacement_mm[i]);
        out.force_kN.push_back(all.force_kN[i]);
    }
    return out;
}

} // namespace

TEST_CASE("measured walls: peaks are those of the database", "[fragility][measured_walls]")
{
    const auto walls = measured_walls();
    for (const Printed& p : kPrinted)
        if (!walls.empty()) CHECK(peak(walls.at(p.wall).curve()).force == p.peak);
}

TEST_CASE("measured walls: SLC, SLV, SLD and SLO are the printed ones to their last digit",
          "[fragility][measured_walls]")
{
    const auto walls = measured_walls();
    if (walls.empty()) return;
    const Code& ntc = *find_code(built_in_codes(), "ntc");
    for (const Printed& p : kPrinted) {
        INFO(p.wall);
        const bench::CurveTable table = first_at_each_displacement(walls.at(p.wall));
        const std::vector<LimitState> s = read_limit_states(table.curve(), ntc, {});
        if (p.slc_is_end) { // a bound that holds however the test goes on
            CHECK(s[0].limit.displacement <= printed(p.slo, 2));
            CHECK(s[1].limit.displacement <= printed(p.sld, 2));
            CHECK(equal_energy_bilinear(table.curve(), table.curve().displacement.back(), 0.6)
                      .yield_displacement == printed(p.sld, 2));
        } else {
            CHECK(s[0].limit.displacement == printed(p.slo, 2));
            CHECK(s[1].limit.displacement == printed(p.sld, 2));
        }
        CHECK(s[2].limit.displacement == printed(p.slv, 1));
        CHECK(s[3].limit.displacement == printed(p.slc, 1));
        CHECK((s[1].limit.reading == Reading::censored) == p.slc_is_end);
        CHECK((s[3].limit.reading == Reading::censored) == p.slc_is_end);
    }
}

TEST_CASE("measured walls: steps kept instead of dropped move no limit displacement by 0.06 mm",
          "[fragility][measured_walls]")
{
    const auto walls = measured_walls();
    const Code& ntc = *find_code(built_in_codes(), "ntc");
    for (const auto& [wall, table] : walls) {
        INFO(wall);
        const bench::CurveTable dropped = first_at_each_displacement(table);
        const auto a = read_limit_states(table.curve(), ntc, {});
        const auto b = read_limit_states(dropped.curve(), ntc, {});
        for (std::size_t i = 0; i < a.size(); ++i)
            CHECK(std::abs(a[i].limit.displacement - b[i].limit.displacement) < 0.06);
    }
}

TEST_CASE(
    "measured walls: the yield through 0.7 of the peak is the printed one, and the database's "
    "within 2.5 % for four walls of five",
    "[fragility][measured_walls]")
{
    const auto walls = measured_walls();
    if (walls.empty()) return;
    for (const Printed& p : kPrinted) {
        if (p.yield_07 == 0.0) continue;
        INFO(p.wall);
        const bench::CurveTable table = first_at_each_displacement(walls.at(p.wall));
        const double ultimate = drop_after_peak(table.curve()).displacement;
        const Bilinear b =
            equal_energy_bilinear(table.curve(), ultimate, kBilinearShareDatabase);
        CHECK(b.yield_displacement == printed(p.yield_07, 2));
        // SW.250.1 is jerky where it reaches 0.7: 3.66 mm here, 4.1 mm in the database
        if (std::string(p.wall) != "SW.250.1")
            CHECK(b.yield_displacement == Approx(p.yield_database).epsilon(0.025).margin(0.0));
    }
}

TEST_CASE(
    "measured walls: the last 80 % crossing is between the printed last point above it and the "
    "next, and censored where that point is the end",
    "[fragility][measured_walls]")
{
    const auto walls = measured_walls();
    if (walls.empty()) return;
    for (const Printed& p : kPrinted) {
        if (p.last == 0.0) continue;
        INFO(p.wall);
        const bench::CurveTable& t = walls.at(p.wall);
        const double level = kUltimateShare * p.peak;
        std::size_t i = t.force_kN.size() - 1;
        while (t.force_kN[i] < level) --i;
        CHECK(t.displacement_mm[i] == printed(p.last, 1));
        const LimitDisplacement x = drop_after_peak(t.curve(), kUltimateShare, Crossing::last);
        if (i + 1 == t.force_kN.size()) {
            CHECK(x.reading == Reading::censored);
            CHECK(x.displacement == t.displacement_mm[i]);
        } else {
            CHECK(x.reading == Reading::observed);
            CHECK(x.displacement > t.displacement_mm[i]);
            CHECK(x.displacement < t.displacement_mm[i + 1]);
        }
    }
}
