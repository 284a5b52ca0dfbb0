#include "app/fragility/fragility_modes.hpp"

#include "app/fragility/numbers/table_texts.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/mode_rule.hpp"
#include "app/study/answers/mode_share.hpp"
#include "core/binomial.hpp"
#include "core/interval.hpp"
#include "dem/scene/mechanism/mechanism.hpp"
#include "fragility/modes/equal_modes.hpp"
#include "fragility/modes/mode_sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace app {
namespace {

double walls_with(const StudyLevel& level, int mode)
{
    return static_cast<double>(walls_of(level, mode).size());
}

Number range_cell(const core::Interval& i)
{
    return range(100.0 * i.lower, 100.0 * i.upper, 1);
}

/// How many walls of a mode satisfy a condition.
template <class Holds> Number count_of(const StudyLevel& level, int mode, Holds holds)
{
    return count(std::ranges::count_if(walls_of(level, mode),
                                       [&](const StudyWall* w) { return holds(*w); }));
}

void add_mode(const StudyWalls& walls, const StudyLevel& level, int mode, Table& t)
{
    const double confidence = walls.study.fragility.confidence;
    const bool has_slid =
        mode == kRocking && walls.study.fragility.mode.modes == dem::ModeRule::paper;
    const Row start = {
        stress_cell(level.stress),
        mode_name(mode),
        count(walls_with(level, mode)),
        has_slid ? count_of(level, kAllModes, [](const auto& w) { return w.reading.slid; })
                 : Number{},
        count_of(level, mode, [](const auto& w) { return !w.reading.dropped; }),
        count_of(level, mode, [](const auto& w) { return w.mechanism.spalled_units > 0; }),
        count_of(level, mode, [](const auto& w) { return w.mechanism.crushed_area > 0.0; }),
        count(level.walls.size()),
        count(level.failed_walls.size())};
    if (level.walls.empty()) return add_row(t, start, "No wall gave a result.");
    using enum core::BinomialInterval;
    const fragility::Share s = mode_share(level, mode, confidence);
    const auto by = [&](core::BinomialInterval kind) {
        return range_cell(mode_share(level, mode, confidence, kind).interval);
    };
    add_row(
        t, joined(start, {percent(s.value, s.interval, 1), by(clopper_pearson), by(jeffreys)}));
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
        const StudyWall& w = *walls[i];
        data.covariates(i, 0) = w.inputs[input];
        data.counts(i, mode_of(w) == kRocking ? 0 : 1) = 1.0;
    }
    return data;
}

/// Bounds that no friction angle can have bound nothing.
core::Interval physical(core::Interval i)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (!(i.lower > 0.0)) i.lower = -kInfinity;
    if (!(i.upper < 90.0)) i.upper = kInfinity;
    return i;
}

void add_equal(const StudyWalls& walls, const StudyLevel& level,
               const std::optional<std::size_t>& input, int other, Table& t)
{
    const double rocking = walls_with(level, kRocking), n = rocking + walls_with(level, other);
    const Row start = {stress_cell(level.stress), mode_name(other), count(n), count(rocking)};
    if (!input) return add_row(t, start, "joint.friction_angle does not vary in this study.");
    if (level.walls.empty()) return add_row(t, start, "No wall gave a result.");
    if (rocking == 0 || rocking == n)
        return add_row(t, start,
                       std::string("The mode ") + mode_name(rocking == n ? other : kRocking) +
                           " does not occur: the data have no such angle.");
    const auto data = mode_data(level, *input, other);
    const auto model = fragility::fit_modes_safely(data);
    if (model.outcome != fragility::ModelOutcome::converged)
        return add_row(t, start, "No model: " + model.reason + ".");
    const auto equal = fragility::equal_modes(model, data, 0, 1, 0, Eigen::VectorXd::Zero(1),
                                              walls.study.fragility.confidence);
    if (!equal.found) return add_row(t, start, "No such angle: " + equal.reason + ".");
    const Number slope = with_error(model.coefficients(0, 1), model.std_errors(0, 1), 3);
    const bool firth = model.penalty == fragility::ModePenalty::firth;
    const core::Interval i = physical(firth ? equal.delta : equal.profile);
    if (std::isinf(i.lower) && std::isinf(i.upper))
        return add_row(t, joined(start, {{}, slope}),
                       "Not identifiable: the slope is not significant.");
    const auto angles = data.covariates.col(0);
    std::string note =
        firth ? "Firth's penalty, interval by the delta method: " + model.reason + "." : "";
    if (equal.at < angles.minCoeff() || equal.at > angles.maxCoeff())
        note += std::string(note.empty() ? "" : " ") +
                "The angle lies outside the angles of the walls.";
    const core::Interval fieller = physical(equal.fieller);
    add_row(t,
            joined(start, {with_interval(equal.at, i, 1), slope,
                           range(fieller.lower, fieller.upper, 1)}),
            note);
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
              {"slid without cracking", kDetail},
              {"still stood", kDetail},
              {"with spalled units", kDetail},
              {"with contacts crushed through", kDetail},
              "n",
              "failed",
              {"share [%]", kInterval},
              {"Clopper-Pearson [%]", kRange | kProgramsOnly},
              {"Jeffreys [%]", kRange | kProgramsOnly},
              {"note", kNote}};
    for (const StudyLevel& level : walls.levels)
        for (const int mode : modes_of(walls)) add_mode(walls, level, mode, t);
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
    const auto input = input_of(walls, "joint.friction_angle");
    for (const StudyLevel& level : walls.levels)
        for (const int other : modes_of(walls))
            if (other != kRocking) add_equal(walls, level, input, other, t);
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
            t.head.emplace_back(mode_name(mode) + (" at " + stress_text(level.stress)) +
                                " [%]");
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
