#include "app/fragility/numbers/sampling_errors.hpp"
#include "bench/validation/joint_inputs.hpp"
#include "bench/validation/numerical_scatter.hpp"
#include "bench/validation/paper_comparison.hpp"
#include "bench/validation/paper_tables.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

TEST_CASE("validation: interval of a difference of shares is Newcombe's", "[app][validation]")
{
    // Newcombe (1998), Statistics in Medicine 17, Table II, method 10
    const auto a = bench::share_difference(56, 70, 48, 80);
    CHECK(a.value == Approx(0.2).epsilon(1e-12));
    CHECK(a.lower == Approx(0.0524).margin(5e-5));
    CHECK(a.upper == Approx(0.3339).margin(5e-5));
    const auto b = bench::share_difference(9, 10, 3, 10);
    CHECK(b.lower == Approx(0.1705).margin(5e-5));
    CHECK(b.upper == Approx(0.8090).margin(5e-5));
    const auto c = bench::share_difference(5, 56, 0, 29);
    CHECK(c.lower == Approx(-0.0381).margin(5e-5));
    CHECK(c.upper == Approx(0.1926).margin(5e-5));
}

TEST_CASE("validation: the paper's tables agree with themselves", "[app][validation]")
{
    for (const bench::PaperLevel& p : bench::kPaperLevels) {
        const double share = static_cast<double>(p.rocking_walls) / p.walls;
        const double friction = share * p.rocking.friction_deg +
                                (p.mixed ? (1.0 - share) * p.mixed->friction_deg : 0.0);
        CHECK(friction == Approx(31.8).margin(0.25)); // Table 5
    }
    CHECK(bench::pooled_peak(bench::kPaperLevels[2]) == Approx(0.34 * 69.51 + 0.66 * 63.89));
}

TEST_CASE("validation: a level is told apart by the mode rule", "[app][validation]")
{
    app::StudyWalls walls = scenes::study_walls(10);
    auto& level = walls.levels[0];
    for (app::StudyWall& w : level.walls) {
        w.reading.dropped = false;
        w.mechanism.cracked_units = 1;
        w.mechanism.rotation_share = 0.45;
        w.reading.ultimate.displacement = 0.030;
        w.reading.ultimate.reading = fragility::Reading::censored;
    }
    level.walls[0].mechanism.rotation_share = 0.9;
    level.walls[1].mechanism.cracked_units = 0;
    level.walls[2].reading.dropped = true;
    level.walls[2].reading.ultimate = {0.010, fragility::Reading::observed, ""};
    const auto s = bench::level_statistics(walls, 0, {0.5, 1});
    CHECK(s.walls == 10);
    CHECK(s.rocking_walls == 2);
    CHECK(s.slid_walls == 1);
    CHECK(s.dropped_walls == 1);
    CHECK(s.mixed.displacement_mm.mean == Approx((7 * 30.0 + 10.0) / 8));
    CHECK(s.mixed.dropped_mm.n == 1);
    CHECK(s.mixed.dropped_mm.mean == 10.0);
    CHECK(s.rocking.friction_deg.mean ==
          Approx(0.5 * (level.walls[0].inputs[0] + level.walls[1].inputs[0])));
    CHECK(bench::level_statistics(walls, 0, {0.4, 1}).rocking_walls == 9);
    CHECK(bench::level_statistics(walls, 0, {0.5, 0}).rocking_walls == 1);
}

TEST_CASE("validation: the force of the equal-energy bilinear is the plateau of a bilinear "
          "curve",
          "[app][validation]")
{
    app::StudyWalls walls = scenes::study_walls(4);
    walls.step = 0.25e-3;
    auto& level = walls.levels[0];
    for (std::size_t i = 0; i < 4; ++i) {
        app::StudyWall& w = level.walls[i];
        w.mechanism.rotation_share = i < 2 ? 0.9 : 0.1;
        w.mechanism.cracked_units = i < 2 ? 0 : 1;
        w.reading.dropped = i >= 2;
        w.reading.ultimate.displacement = 0.010;
        const double plateau = 50e3 + 1e3 * static_cast<double>(i);
        w.forces.clear();
        for (int k = 0; k <= 40; ++k) w.forces.push_back(std::min(plateau, plateau * k / 8.0));
    }
    const auto s = bench::level_statistics(walls, 0, {0.5, 1});
    CHECK(s.rocking.plateau_kN.mean == Approx(50.5).epsilon(1e-9));
    CHECK(s.mixed.plateau_kN.mean == Approx(52.5).epsilon(1e-9));
    CHECK(s.plateau_kN.mean == Approx(51.5).epsilon(1e-9));
    CHECK(s.plateau_kN.n == 4);
}

TEST_CASE("validation: the drift of a mean curve at 80 % of its peak", "[app][validation]")
{
    app::StudyWalls walls = scenes::study_walls(4);
    walls.step = 0.5e-3;
    walls.height = 1.0;
    auto& level = walls.levels[0];
    walls.levels.resize(1);
    for (std::size_t i = 0; i < 4; ++i) {
        app::StudyWall& w = level.walls[i];
        w.reading.mode = i < 2 ? dem::FailureMode::rocking : dem::FailureMode::mixed;
        w.forces.assign(61, 60e3);
        for (int k = 30; i >= 2 && k <= 60; ++k) w.forces[static_cast<std::size_t>(k)] = 48e3;
        for (int k = 20; i >= 2 && k < 30; ++k) w.forces[static_cast<std::size_t>(k)] = 52e3;
    }
    const app::Table t = bench::drifts_of_mean_curves(walls);
    REQUIRE(t.rows.size() == 1);
    CHECK(app::cell_text(t.rows[0][1]) == "> 3.00");
    CHECK(app::cell_text(t.rows[0][2]) == "1.50");
}

TEST_CASE(
    "validation: what differs from the paper differs by more than both hypercubes scatter",
    "[app][validation]")
{
    const auto as_paper = [](std::size_t walls, double error) {
        std::vector<bench::LevelStatistics> levels;
        for (const bench::PaperLevel& p : bench::kPaperLevels) {
            bench::LevelStatistics s;
            s.walls = walls;
            const double share = static_cast<double>(p.rocking_walls) / p.walls;
            s.rocking_walls = static_cast<std::size_t>(std::lround(share * walls));
            s.rocking_percent = {walls, 100.0 * share, 40.0, 10.0 * error};
            s.peak_kN = {walls, bench::pooled_peak(p), 5.0, error};
            levels.push_back(s);
        }
        return levels;
    };
    bench::OurLevels ours{as_paper(50, 0.3), as_paper(500, 0.1)};
    CHECK(bench::what_differs(ours) ==
          "Beyond the sampling of both, these differ from the paper. Mean peaks: none. Shares "
          "of rocking walls: none.");
    const double scatter = 1.96 * std::hypot(0.3, 0.1);
    ours.large[0].peak_kN.mean -= 1.05 * scatter;
    ours.large[1].peak_kN.mean += 0.95 * scatter;
    ours.large[4].rocking_percent.mean += 10.5 * scatter;
    ours.large[3].rocking_percent.mean -= 9.5 * scatter;
    CHECK(bench::what_differs(ours) ==
          "Beyond the sampling of both, these differ from the paper. Mean peaks: -4.0 % at "
          "0.15 MPa. Shares of rocking walls: 6.5 points at 1.25 MPa.");
    const app::Table peaks = bench::pooled_peaks(ours);
    CHECK(app::cell_text(peaks.rows[0].back()) == "yes");
    CHECK(app::cell_text(peaks.rows[1].back()) == "no");
}

TEST_CASE("validation: means of a level have the error of the hypercube that it is",
          "[app][validation]")
{
    app::StudyWalls walls = scenes::study_walls(40);
    REQUIRE(app::in_hypercube(walls.study));
    const auto level = bench::level_statistics(walls, 0, {0.5, 1});
    std::vector<double> peaks;
    for (const app::StudyWall& w : walls.levels[0].walls)
        peaks.push_back(app::peak_force(w.reading) * 1e-3);
    const std::vector<bool> all(peaks.size(), true);
    CHECK(level.peak_kN.std_error() ==
          app::hypercube_error(walls, walls.levels[0], peaks, all).value());
    walls.study.uq.design = uq::DesignKind::monte_carlo;
    const auto independent = bench::level_statistics(walls, 0, {0.5, 1});
    CHECK(independent.peak_kN.std_error() ==
          Approx(independent.peak_kN.sd / std::sqrt(40.0)).epsilon(1e-12));
}

TEST_CASE("validation: the numerical share of scatter is that of walls under discretisations",
          "[app][validation]")
{
    // Ten walls, ln displacement i / 10 plus -0.1, 0 and 0.1 under three discretisations.
    std::vector<app::StudyWalls> studies;
    for (int k = 0; k < 3; ++k) {
        studies.push_back(scenes::study_walls(12));
        auto& walls = studies.back().levels[0].walls;
        for (std::size_t i = 0; i < 12; ++i) {
            walls[i].reading.dropped = i < 10 || (i == 10 && k == 0);
            walls[i].reading.mode =
                i == 3 && k == 2 ? dem::FailureMode::rocking : dem::FailureMode::mixed;
            walls[i].reading.ultimate.displacement =
                0.01 * std::exp(0.1 * static_cast<double>(i) + 0.1 * (k - 1));
        }
    }
    const bench::ScatterParts p = bench::scatter_parts(studies, 0);
    CHECK(p.walls == 10);
    CHECK(p.within == Approx(0.1).epsilon(1e-9));
    const double of_means = std::sqrt(110.0 / 12.0) * 0.1; // of 0, 1, ... 9, tenths
    CHECK(p.between == Approx(std::sqrt(of_means * of_means - 0.01 / 3.0)).epsilon(1e-9));
    CHECK(p.fell_in_some == 1);
    CHECK(p.changed_mode == 1);
    studies[1].levels[0].walls[4].inputs[0] += 1.0;
    CHECK_THROWS_AS(bench::scatter_parts(studies, 0), std::invalid_argument);
}

TEST_CASE("validation: inputs one at a time, each in its row", "[app][validation]")
{
    std::size_t number = 0;
    const auto walls = [&] {
        bench::LevelStatistics s;
        s.walls = number == 0 ? 1 : 100;
        s.rocking_walls = number == 0 ? 0 : 10 + number;
        const double mean = 60.0 + static_cast<double>(number++);
        s.peak_kN = {s.walls, mean, 5.0};
        s.mixed.displacement_mm = {s.walls, mean - 40.0, 6.0};
        return s;
    };
    const bench::JointInputs inputs{walls(), walls(), walls(), walls(), walls(),
                                    walls(), walls(), walls(), walls()};
    const app::Table t = bench::joint_inputs_table(inputs);
    REQUIRE(t.rows.size() == 9);
    const auto texts = [&t](std::size_t row) {
        std::vector<std::string> all;
        for (const app::Cell& cell : t.rows[row]) all.push_back(app::cell_text(cell));
        return all;
    };
    CHECK(texts(0) ==
          std::vector<std::string>{"none: mean values, one wall", "", "60.00", "", "20.0"});
    CHECK(texts(1) == std::vector<std::string>{"friction of joints", "11 [6, 19]",
                                               "61.00 [60.02, 61.98]", "0.082",
                                               "21.0 [19.8, 22.2]"});
    for (std::size_t r = 2; r < t.rows.size(); ++r)
        CHECK(texts(r)[2].starts_with(std::to_string(60 + r) + ".00 ["));
}
