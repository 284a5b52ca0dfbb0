#include "bench/validation/effects.hpp"

#include "app/text/number_text.hpp"

#include <array>
#include <cmath>
#include <string>

namespace bench {
namespace {

struct Choice {
    const char* file;
    const char* name;
};

constexpr std::array kChoices = {
    Choice{"load_height_1.05", "load at 1.05 m, half the height of the beam (1.10 m)"},
    Choice{"load_height_1.15", "load at 1.15 m, beam as heavy and 0.20 m high"},
    Choice{"beam_0.20",
           "beam as heavy and 0.20 m high, load at its half height, 1.10 m (beam 0.10 m)"},
    Choice{"beam_light", "beam of 0.5 kN, concrete (1.5 kN)"},
    Choice{"base_joint", "first course on a dry joint (clamped)"},
    Choice{"toe_free", "toe not held sideways (held)"},
    Choice{"first_course_fixed",
           "first course fixed as a whole, nine above it (its bottom face)"},
    Choice{"beam_joint", "beam on a dry joint (tied)"},
    Choice{"density_2000", "stone 2000 kg/m3 (2300)"},
    Choice{"density_2600", "stone 2600 kg/m3 (2300)"},
    Choice{"points_4", "4 contact points per face (5)"},
    Choice{"points_7", "7 contact points per face (5)"},
    Choice{"even_points", "contact points evenly spaced (Gauss-Lobatto)"},
    Choice{"modes_6", "6 modes of a block (12)"},
    Choice{"modes_all", "all zones of a block (12 modes)"},
    Choice{"snap_back_weakens", "snap-back: crack weakened to what G allows (breaks at f_T)"},
    Choice{"unloading_elastic",
           "a crack unloads elastically, propped open (secant to the origin)"},
    Choice{"uncoupled", "uncoupled contact law (coupled)"},
    Choice{"strength_in_tension", "shear strength not lowered by tension (lowered)"},
    Choice{"damping_0.5", "damping factor 0.5 (0.8)"},
    Choice{"damping_0.95", "damping factor 0.95 (0.8)"},
    Choice{"combined", "combined damping (local)"},
    Choice{"combined_0.95", "combined damping, factor 0.95"},
    Choice{"drive_fast", "accuracy of 3 % instead of 1 %"},
    Choice{"drive_slow", "accuracy of 0.3 % instead of 1 %"},
    Choice{"drive_constant_fast", "constant speed, 300 steps per mm"},
    Choice{"drive_constant_slow", "constant speed, 3000 steps per mm"},
    Choice{"modulus_768", "modulus at 0.75 MPa as at 0.50, 768 MPa (912.5)"},
    Choice{"modulus_1057", "modulus at 0.75 MPa as at 1.00, 1057 MPa (912.5)"},
    Choice{"push_28", "push to 28 mm (30)"},
    Choice{"push_45", "push to 45 mm (30)"}};

struct Rule {
    dem::ModeThresholds thresholds;
    const char* name;
};

constexpr std::array kRules = {
    Rule{{0.3, 1}, "mode rule: mixed below 0.3 of rotation (0.5)"},
    Rule{{0.7, 1}, "mode rule: mixed below 0.7 of rotation (0.5)"},
    Rule{{0.5, 0}, "mode rule: sliding without cracks is mixed too (is not)"},
    Rule{{0.5, 4}, "mode rule: 4 units cracked through (1)"}};

std::string change(double value, int decimals)
{
    const std::string text = app::fixed(value, decimals);
    const bool none = text.find_first_not_of("-0.") == std::string::npos;
    return none ? "0" : (value > 0.0 ? "+" : "") + text;
}

/// "a / b / c", a level each.
template <class Cell> std::string levels(std::size_t n, Cell cell)
{
    std::string text;
    for (std::size_t l = 0; l < n; ++l) text += (l > 0 ? " / " : "") + std::string(cell(l));
    return text;
}

double rocking(const LevelStatistics& s)
{
    return 100.0 * static_cast<double>(s.rocking_walls) / static_cast<double>(s.walls);
}

app::Row row(const char* name, const std::vector<LevelStatistics>& base,
             const std::vector<LevelStatistics>& changed)
{
    const std::size_t n = base.size();
    std::size_t failed = 0;
    for (const LevelStatistics& s : changed) failed += s.failed;
    return {name,
            levels(n,
                   [&](std::size_t l) {
                       return change(
                           100.0 * (changed[l].peak_kN.mean / base[l].peak_kN.mean - 1.0), 1);
                   }),
            levels(n,
                   [&](std::size_t l) {
                       return change(rocking(changed[l]) - rocking(base[l]), 0);
                   }),
            levels(n,
                   [&](std::size_t l) -> std::string {
                       const Sample &a = base[l].mixed.displacement_mm,
                                    &b = changed[l].mixed.displacement_mm;
                       if (a.n < 5 || b.n < 5) return "-";
                       return change(b.mean - a.mean, 1);
                   }),
            failed > 0 ? std::to_string(failed) : ""};
}

} // namespace

app::Table effects_table(const app::StudyWalls& base, const std::filesystem::path& folder)
{
    app::Table t;
    const auto ours = level_statistics(base);
    t.caption =
        "Effect of each choice alone on means of 50 walls, under " +
        levels(ours.size(), [&](std::size_t l) { return app::fixed(ours[l].stress_MPa, 2); }) +
        " MPa; our choice in brackets. Each row has the same samples, so that differences come "
        "from the choice; if single walls change their mode by chance, shares move by 2 or 4 "
        "points. Displacement: first fall to 80 % or end of the run, -: fewer than "
        "5 walls of mixed mode. Failed: walls without a result.";
    t.head = {"choice", "peak force of all walls [%]", "rocking walls [points]",
              "displacement of mixed walls [mm]", "failed"};
    for (const Choice& c : kChoices)
        t.rows.push_back(
            row(c.name, ours, read_levels(folder / (std::string(c.file) + ".h5"))));
    for (const Rule& r : kRules) {
        std::vector<LevelStatistics> changed;
        for (std::size_t l = 0; l < base.levels.size(); ++l)
            changed.push_back(level_statistics(base, l, r.thresholds));
        t.rows.push_back(row(r.name, ours, changed));
    }
    return t;
}

} // namespace bench
