/// Records of others, which this project does not hold: their folder is named by
/// DRYSTONE_RECORDS.

#include "ground/intensity.hpp"
#include "ground/motion_facts.hpp"
#include "ground/record.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

constexpr double kG = 9.80665;

/// Empty where the records are not there.
std::string folder()
{
    const char* const named = std::getenv("DRYSTONE_RECORDS");
    if (named == nullptr || !std::filesystem::is_directory(named)) {
        WARN("skipped: DRYSTONE_RECORDS names no folder of records");
        return {};
    }
    return named;
}

struct Peaks {
    const char* file;
    std::vector<double> values; ///< in unit
    double unit;                ///< [m/s2]
};

} // namespace

TEST_CASE("shared records: peaks of ten formats are those that the heads state",
          "[ground][shared]")
{
    const std::string records = folder();
    if (records.empty()) return;
    const std::vector<Peaks> stated = {
        {"20161113_110300_HSES_20.V2A", {2364.6, 2553.7, -1571.2}, 1e-3},
        {"20161113_110313_THZ_20.V2A", {357.8, 467.2, -224.4}, 1e-3},
        {"ce36456p_CE36456.V2", {-267.957, -94.805, -256.231}, 1e-2},
        {"CE58667.V2", {27.114, 11.244, -26.411}, 1e-2},
        {"0111a.smc", {104.4}, 1e-2},
        {"np01002p_4225a_a.smc", {-222.5}, 1e-2},
        {"np01002p_4225c_a.smc", {272.3}, 1e-2},
        {"angol1002271parte1.v1", {-0.682, -0.928, -0.281}, kG},
        {"HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC", {0.300022}, 1e-2},
        {"HI.ARS1..HNN.D.20190728.160908.C.ACC.ASC", {0.359017}, 1e-2},
        {"RSN763_LOMAP_GIL067.AT2", {-0.358533}, kG},
        {"274o42pv.s0a", {-6.869}, 1e-2},
        {"AKBMR--n.1000hyfh.BNZ.acc.V2c", {-6.852}, 1e-2},
        {"elCentro.at2", {0.31882}, kG}};
    for (const Peaks& p : stated) {
        INFO(p.file);
        const auto all = ground::read_records(records + "/formats/" + p.file);
        REQUIRE(all.size() == p.values.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            double peak = 0.0;
            for (const double a : all[i].motion.acceleration)
                peak = std::abs(a) > std::abs(peak) ? a : peak;
            CHECK(std::abs(peak) / p.unit ==
                  Approx(std::abs(p.values[i])).epsilon(2e-4).margin(6e-4));
        }
    }
    CHECK(
        ground::read_records(records + "/formats/usaca40.044")[0].motion.acceleration.size() ==
        5983);
    CHECK(
        ground::read_records(records + "/formats/elCentro.at2")[0].motion.acceleration.size() ==
        1559);
}

TEST_CASE("shared records: measures of 44 records are those of an independent program",
          "[ground][shared][slow]")
{
    const std::string records = folder();
    if (records.empty()) return;
    std::ifstream index(records + "/fema_p695/index.csv");
    std::string line;
    std::getline(index, line);
    int rows = 0;
    while (std::getline(index, line)) {
        std::vector<std::string> cells;
        std::istringstream in(line);
        for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
        const auto at = [&](int i) { return std::stod(cells.at(static_cast<std::size_t>(i))); };
        const auto m =
            ground::read_records(records + "/fema_p695/" + cells[0] + ".txt")[0].motion;
        INFO(cells[0]);
        const auto f = motion_facts(m);
        CHECK(m.step == Approx(at(4)).epsilon(1e-9));
        CHECK(f.pga / kG == Approx(at(6)).epsilon(1e-4));
        CHECK(f.pgv * 100.0 == Approx(at(7)).epsilon(1e-4));
        CHECK(f.pgd * 100.0 == Approx(at(8)).epsilon(1e-4));
        CHECK(ground::arias_intensity(m) == Approx(at(9)).epsilon(1e-4));
        CHECK(ground::cumulative_absolute_velocity(m) == Approx(at(10)).epsilon(1e-4));
        CHECK(ground::significant_duration(m, 0.05, 0.75) == Approx(at(11)).epsilon(1e-4));
        CHECK(ground::significant_duration(m, 0.05, 0.95) == Approx(at(12)).epsilon(1e-4));
        const double periods[] = {0.1, 0.2, 0.3, 0.5, 1.0, 2.0};
        for (int i = 0; i < 6; ++i)
            CHECK(ground::spectral_acceleration(m, periods[i]) / kG ==
                  Approx(at(13 + i)).epsilon(5e-4));
        ++rows;
    }
    CHECK(rows == 44);
}
