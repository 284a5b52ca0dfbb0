#include "app/fragility/fragility_modes.hpp"

#include "app/fragility/fragility_means.hpp"
#include "app/fragility/table_texts.hpp"
#include "app/study/fragility_text.hpp"
#include "app/study/mode_rule.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/mechanism.hpp"
#include "fragility/binomial.hpp"
#include "fragility/equal_modes.hpp"
#include "fragility/mode_sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace app {
namespace {

Number stress_cell(const StudyLevel& level) { return given(level.stress / 1e6); }

double walls_with(const StudyLevel& level, int mode)
{
    return static_cast<double>(
        std::count_if(level.walls.begin(), level.walls.end(),
                      [&](const StudyWall& w) { return mode_of(w) == mode; }));
}

Number range_cell(const fragility::Interval& i)
{
    return range(100.0 * i.lower, 100.0 * i.upper, 1);
}

/// How many walls of a level slid and did not crack.
double slid(const StudyLevel& level)
{
    return static_cast<double>(
        std::count_if(level.walls.begin(), level.walls.end(),
                      [](const StudyWall& w) { return w.reading.slid; }));
}

bool slides_count_as_rocking(const StudyWalls& walls)
{
    return walls.study.fragility.mode.modes == dem::ModeRule::two;
}

/// Walls of a mode of which something holds.
template <class Holds> Number count_of(const StudyLevel& level, int mode, Holds holds)
{
    return count(
        static_cast<double>(std::ranges::count_if(level.walls, [&](const StudyWall& w) {
            return mode_of(w) == mode && holds(w.mechanism);
        })));
}

Row mode_row(const StudyWalls& walls, const StudyLevel& level, int mode)
{
    const double confidence = walls.study.fragility.confidence;
    const auto n = static_cast<double>(level.walls.size());
    const auto failed = static_cast<double>(level.failed_walls.size());
    const double k = walls_with(level, mode);
    Row row = {
        stress_cell(level),
        mode_name(mode),
        count(k),
        mode == kRocking && slides_count_as_rocking(walls) ? count(slid(level)) : Number{},
        count_of(level, mode, [](const dem::Mechanism& m) { return m.spalled_units > 0; }),
        count_of(level, mode, [](const dem::Mechanism& m) { return m.crushed_area > 0.0; }),
        count(n),
        count(failed)};
    if (n == 0.0) {
        row.insert(row.end(), {{},
                               {},
                               {},
                               failed > 0.0 ? range(0.0, 100.0, 1) : Number{},
                               "No wall gave a result."});
        return row;
    }
    using enum fragility::BinomialInterval;
    const auto s = fragility::share(k, n, failed, wilson, confidence);
    row.emplace_back(
        with_interval(100.0 * s.value, 100.0 * s.interval.lower, 100.0 * s.interval.upper, 1));
    for (const auto kind : {clopper_pearson, jeffreys})
        row.emplace_back(range_cell(fragility::binomial_interval(kind, k, n, confidence)));
    row.emplace_back(range_cell(s.bounds));
    row.emplace_back();
    return row;
}

const char* const kFriction = "joint.friction_angle";

std::optional<std::size_t> friction_of(const StudyWalls& walls)
{
    for (std::size_t i = 0; i < walls.inputs.size(); ++i)
        if (walls.inputs[i].key == kFriction) return i;
    return {};
}

/// Walls that rock and walls of another mode.
fragility::ModeData mode_data(const StudyLevel& level, std::size_t input, int other)
{
    std::vector<const StudyWall*> walls;
    for (const StudyWall& w : level.walls)
        if (mode_of(w) == kRocking || mode_of(w) == other) walls.push_back(&w);
    const auto n = static_cast<Eigen::Index>(walls.size());
    fragility::ModeData data{Eigen::MatrixXd(n, 1), Eigen::MatrixXd::Zero(n, 2)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const StudyWall& w = *walls[static_cast<std::size_t>(i)];
        data.covariates(i, 0) = w.inputs[input];
        data.counts(i, mode_of(w) == kRocking ? 0 : 1) = 1.0;
    }
    return data;
}

/// Bounds that no friction angle can have bound nothing.
fragility::Interval physical(fragility::Interval i)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (!(i.lower > 0.0)) i.lower = -kInfinity;
    if (!(i.upper < 90.0)) i.upper = kInfinity;
    return i;
}

Row equal_row(const StudyWalls& walls, const StudyLevel& level,
              const std::optional<std::size_t>& input, int other)
{
    const double rocking = walls_with(level, kRocking), n = rocking + walls_with(level, other);
    Row row = {stress_cell(level), mode_name(other), count(n), count(rocking)};
    const auto only_note = [&](const std::string& text, Cell slope = {}) {
        row.insert(row.end(), {{}, std::move(slope), {}, text});
        return row;
    };
    if (!input) return only_note("joint.friction_angle does not vary in this study.");
    if (level.walls.empty()) return only_note("No wall gave a result.");
    if (rocking == 0 || rocking == n)
        return only_note(std::string("No wall is ") +
                         mode_name(rocking == n ? other : kRocking) +
                         ": the data have no such angle.");
    const auto data = mode_data(level, *input, other);
    const auto model = fragility::fit_modes_safely(data);
    if (model.outcome != fragility::ModelOutcome::converged)
        return only_note("No model: " + model.reason + ".");
    const auto equal = fragility::equal_modes(model, data, 0, 1, 0, Eigen::VectorXd::Zero(1),
                                              walls.study.fragility.confidence);
    if (!equal.found) return only_note("No such angle: " + equal.reason + ".");
    const Number slope = with_error(model.coefficients(0, 1), model.std_errors(0, 1), 3);
    const bool firth = model.penalty == fragility::ModePenalty::firth;
    const fragility::Interval i = physical(firth ? equal.delta : equal.profile);
    if (std::isinf(i.lower) && std::isinf(i.upper))
        return only_note("Not identifiable: the slope is not significant.", slope);
    const auto angles = data.covariates.col(0);
    std::string note =
        firth ? "Firth's penalty, interval by the delta method: " + model.reason + "." : "";
    if (equal.at < angles.minCoeff() || equal.at > angles.maxCoeff())
        note += std::string(note.empty() ? "" : " ") +
                "The angle lies outside the angles of the walls.";
    const fragility::Interval fieller = physical(equal.fieller);
    row.insert(row.end(), {with_interval(equal.at, i, 1), slope,
                           range(fieller.lower, fieller.upper, 1), note});
    return row;
}

struct ThresholdGrid {
    std::vector<std::vector<double>> points; ///< rotation share, cracked units
};

ThresholdGrid grid_of(const FragilityInput& f)
{
    const std::vector<std::vector<double>> values = {{0.3, 0.4, 0.5, 0.6, 0.7},
                                                     {0.0, 1.0, 2.0, 4.0}};
    ThresholdGrid grid{{{f.mode.rotation_share, static_cast<double>(f.mode.cracked_units)}}};
    for (const auto& point : fragility::threshold_grid(values))
        if (point != grid.points.front()) grid.points.push_back(point);
    return grid;
}

std::vector<std::vector<double>> figures_of(const StudyLevel& level)
{
    std::vector<std::vector<double>> figures;
    for (const StudyWall& w : level.walls)
        figures.push_back({w.mechanism.rotation_share,
                           static_cast<double>(w.mechanism.cracked_units),
                           w.reading.dropped ? 1.0 : 0.0, w.mechanism.turning_share});
    return figures;
}

int mode_by_figures(std::span<const double> figures, std::span<const double> thresholds,
                    dem::ModeRule modes)
{
    const dem::Mechanism m{.rotation_share = figures[0],
                           .cracked_units = static_cast<int>(figures[1]),
                           .turning_share = figures[3]};
    return static_cast<int>(dem::failure_mode(
        m, figures[2] > 0.5, {thresholds[0], static_cast<int>(thresholds[1]), modes}));
}

} // namespace

Table mode_table(const StudyWalls& walls)
{
    Table t = titled_table("modes", words_of(walls));
    t.keys = 2;
    t.head = {"stress [MPa]",
              "mode",
              "walls with this mode",
              "slid without cracking",
              "with spalled units",
              "with contacts crushed through",
              "n",
              "failed",
              {"share [%]", kInterval},
              {"Clopper-Pearson [%]", kRange | kProgramsOnly},
              {"Jeffreys [%]", kRange | kProgramsOnly},
              {"share with failed walls [%]", kRange},
              {"note", kNote}};
    for (const StudyLevel& level : walls.levels)
        for (const int mode : modes_of(walls)) t.rows.push_back(mode_row(walls, level, mode));
    return t;
}

Table equal_modes_table(const StudyWalls& walls)
{
    Table t = titled_table("equal_modes", words_of(walls));
    t.keys = 2;
    t.head = {"stress [MPa]",
              "other mode",
              "n",
              "rocking",
              {"angle [deg]", kInterval},
              {"slope [1/deg]", kError},
              {"angle after Fieller [deg]", kRange | kProgramsOnly},
              {"note", kNote}};
    const auto input = friction_of(walls);
    for (const StudyLevel& level : walls.levels)
        for (const int other : modes_of(walls))
            if (other != kRocking) t.rows.push_back(equal_row(walls, level, input, other));
    return t;
}

Table threshold_table(const StudyWalls& walls)
{
    Table t = titled_table("mode_thresholds", words_of(walls));
    t.keys = 2;
    t.head = {"rotation share", "cracked units"};
    std::vector<std::vector<double>> all;
    std::vector<int> shown = modes_of(walls);
    std::erase(shown, kRocking);
    for (const StudyLevel& level : walls.levels) {
        for (const int mode : shown)
            t.head.emplace_back(mode_name(mode) + (" at " + number(level.stress / 1e6, 12)) +
                                " MPa [%]");
        for (const auto& f : figures_of(level)) all.push_back(f);
    }
    t.head.emplace_back("walls that change their mode [%]");
    if (all.empty()) return t;
    const ThresholdGrid grid = grid_of(walls.study.fragility);
    const fragility::ModeRule rule = [&](auto figures, auto thresholds) {
        return mode_by_figures(figures, thresholds, walls.study.fragility.mode.modes);
    };
    const auto overall = fragility::mode_shares(all, grid.points, rule, kAllModes);
    for (const auto& point : grid.points) t.rows.push_back({given(point[0]), count(point[1])});
    for (const StudyLevel& level : walls.levels) {
        const auto figures = figures_of(level);
        std::vector<fragility::ThresholdShares> shares;
        if (!figures.empty())
            shares = fragility::mode_shares(figures, grid.points, rule, kAllModes);
        for (std::size_t p = 0; p < grid.points.size(); ++p)
            for (const int mode : shown)
                t.rows[p].emplace_back(shares.empty()
                                           ? Number{}
                                           : plain_number(100.0 * shares[p].shares[mode], 0));
    }
    for (std::size_t p = 0; p < grid.points.size(); ++p)
        t.rows[p].emplace_back(plain_number(100.0 * overall[p].moved, 1));
    return t;
}

} // namespace app
