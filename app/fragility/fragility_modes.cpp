#include "app/fragility/fragility_modes.hpp"

#include "app/input/number_text.hpp"
#include "app/study/fragility_text.hpp"
#include "app/study/mode_rule.hpp"
#include "dem/scene/mechanism.hpp"
#include "fragility/binomial.hpp"
#include "fragility/equal_modes.hpp"
#include "fragility/mode_sensitivity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace app {
namespace {

constexpr std::array<const char*, 2> kModes = {"rocking", "mixed"};

std::string stress_text(const StudyLevel& level) { return number(level.stress * 1e-6, 12); }

std::string rule_text(const StudyWalls& walls)
{
    return mode_rule_text(walls.study.fragility.mode);
}

std::string share_text(const fragility::Interval& i)
{
    return fixed(100.0 * i.lower, 1) + " to " + fixed(100.0 * i.upper, 1);
}

/// How many walls of a level slid and did not crack.
std::string slid_text(const StudyWalls& walls, const StudyLevel& level)
{
    return std::to_string(
        std::count_if(level.walls.begin(), level.walls.end(), [&](const StudyWall& w) {
            return slid_whole({w.rotation_share, w.sliding_share, w.cracked_units, 0},
                              w.dropped, walls.study.fragility.mode);
        }));
}

std::vector<std::string> mode_row(const StudyWalls& walls, const StudyLevel& level, int mode)
{
    const double confidence = walls.study.fragility.confidence;
    const auto n = static_cast<double>(level.walls.size());
    const auto k =
        static_cast<double>(std::count_if(level.walls.begin(), level.walls.end(),
                                          [&](const StudyWall& w) { return w.mode == mode; }));
    const auto failed = static_cast<double>(level.failed);
    std::vector<std::string> row = {
        stress_text(level), kModes[static_cast<std::size_t>(mode)],
        number(k, 9),       mode == kRocking ? slid_text(walls, level) : "",
        number(n, 9),       number(failed, 9)};
    if (n == 0.0) {
        row.insert(row.end(),
                   {"no wall gave a result", "", "", failed > 0.0 ? "0 to 100" : ""});
        return row;
    }
    using enum fragility::BinomialInterval;
    const auto s = fragility::share(k, n, failed, wilson, confidence);
    row.push_back(
        with_interval(100.0 * s.value, 100.0 * s.interval.lower, 100.0 * s.interval.upper, 1));
    for (const auto kind : {clopper_pearson, jeffreys})
        row.push_back(share_text(fragility::binomial_interval(kind, k, n, confidence)));
    row.push_back(share_text(s.bounds));
    return row;
}

const char* const kFriction = "joint.friction_angle";

std::optional<std::size_t> friction_of(const StudyWalls& walls)
{
    for (std::size_t i = 0; i < walls.inputs.size(); ++i)
        if (walls.inputs[i].key == kFriction) return i;
    return {};
}

fragility::ModeData mode_data(const StudyLevel& level, std::size_t input)
{
    const auto n = static_cast<Eigen::Index>(level.walls.size());
    fragility::ModeData data{Eigen::MatrixXd(n, 1), Eigen::MatrixXd::Zero(n, 2)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const StudyWall& w = level.walls[static_cast<std::size_t>(i)];
        data.covariates(i, 0) = w.inputs[input];
        data.counts(i, w.mode) = 1.0;
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

std::vector<std::string> equal_row(const StudyWalls& walls, const StudyLevel& level,
                                   std::size_t input)
{
    const auto n = level.walls.size();
    const auto rocking = static_cast<std::size_t>(
        std::count_if(level.walls.begin(), level.walls.end(),
                      [](const StudyWall& w) { return w.mode == kRocking; }));
    std::vector<std::string> row = {stress_text(level), std::to_string(n),
                                    std::to_string(rocking)};
    const auto sentence = [&](const std::string& text) {
        row.insert(row.end(), {text, "", "", ""});
        return row;
    };
    if (n == 0) return sentence("no wall gave a result");
    if (rocking == 0 || rocking == n)
        return sentence(std::string("all walls ") + (rocking == 0 ? "mixed" : "rocking") +
                        ": no such angle in the data");
    const auto data = mode_data(level, input);
    const auto model = fragility::fit_modes_safely(data);
    if (model.outcome != fragility::ModelOutcome::converged)
        return sentence("no model: " + model.reason);
    const double confidence = walls.study.fragility.confidence;
    const auto equal = fragility::equal_modes(model, data, kRocking, kMixed, 0,
                                              Eigen::VectorXd::Zero(1), confidence);
    const bool firth = model.penalty == fragility::ModePenalty::firth;
    if (!equal.found) return sentence("none: " + equal.reason);
    const std::string slope = with_error(model.coefficients(0, 1), model.std_errors(0, 1), 3);
    const fragility::Interval i = physical(firth ? equal.delta : equal.profile);
    if (std::isinf(i.lower) && std::isinf(i.upper)) {
        row.insert(row.end(),
                   {"not identifiable: the slope is not significant", slope, "", ""});
        return row;
    }
    const auto angles = data.covariates.col(0);
    std::string note =
        firth ? "Firth's penalty, interval by the delta method: " + model.reason : "";
    if (equal.at < angles.minCoeff() || equal.at > angles.maxCoeff())
        note += std::string(note.empty() ? "" : "; ") + "outside the angles of the walls";
    row.push_back(with_interval(equal.at, i, 1));
    row.push_back(slope);
    row.push_back(with_interval(equal.at, physical(equal.fieller), 1));
    row.push_back(note);
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
        figures.push_back(
            {w.rotation_share, static_cast<double>(w.cracked_units), w.dropped ? 1.0 : 0.0});
    return figures;
}

int mode_of(std::span<const double> figures, std::span<const double> thresholds)
{
    const dem::Mechanism m{figures[0], 0.0, static_cast<int>(figures[1]), 0};
    return static_cast<int>(dem::failure_mode(
        m, figures[2] > 0.5, {thresholds[0], static_cast<int>(thresholds[1])}));
}

} // namespace

Table mode_table(const StudyWalls& walls)
{
    Table t;
    const std::string confidence = percent_text(walls.study.fragility.confidence);
    t.caption = "Modes of failure per vertical stress. " + rule_text(walls) +
                ". Share of the walls with a result, Wilson interval in brackets, then "
                "Clopper-Pearson and Jeffreys, all " +
                confidence +
                "; the last column holds the share whatever the failed walls would have been. "
                "Intervals suppose independent samples; a Latin hypercube has less scatter.";
    t.head = {"stress [MPa]",
              "mode",
              "walls of it",
              "that slid",
              "n",
              "failed",
              "share [%]",
              "Clopper-Pearson [%]",
              "Jeffreys [%]",
              "with failed walls [%]"};
    for (const StudyLevel& level : walls.levels)
        for (const int mode : {kRocking, kMixed})
            t.rows.push_back(mode_row(walls, level, mode));
    return t;
}

Table equal_modes_table(const StudyWalls& walls)
{
    Table t;
    t.caption = "Joint friction angle at which rocking and mixed mode are equally likely: "
                "logistic regression of the mode on the angle, for each vertical stress. " +
                rule_text(walls) +
                ". Brackets: " + percent_text(walls.study.fragility.confidence) +
                " intervals by profile likelihood, beside them by Fieller's theorem (\"no "
                "limit\": up to 0 or "
                "90 deg). Slope: of "
                "the log odds of mixed against rocking. Where angles tell the modes apart "
                "without error, Firth's penalty keeps the slope finite. Values per joint: mean "
                "over the joints of a wall. Failed walls are left out.";
    t.head = {"stress [MPa]",  "n",   "rocking", "angle [deg]", "slope [1/deg]",
              "Fieller [deg]", "note"};
    const auto input = friction_of(walls);
    for (const StudyLevel& level : walls.levels) {
        if (input) {
            t.rows.push_back(equal_row(walls, level, *input));
        } else {
            t.rows.push_back({stress_text(level), std::to_string(level.walls.size()), "",
                              "joint.friction_angle does not vary in this study", "", "", ""});
        }
    }
    return t;
}

Table threshold_table(const StudyWalls& walls)
{
    Table t;
    t.caption = "Share of mixed mode [%] for other thresholds of the rule; the first row has "
                "those used. A wall whose load fell to 80 % of its peak is mixed whatever the "
                "thresholds. Moved: share of all walls whose mode changes. Failed walls are "
                "left out.";
    t.head = {"rotation share", "cracked units"};
    std::vector<std::vector<double>> all;
    for (const StudyLevel& level : walls.levels) {
        t.head.push_back("mixed at " + stress_text(level) + " MPa [%]");
        for (const auto& f : figures_of(level)) all.push_back(f);
    }
    t.head.emplace_back("moved [%]");
    if (all.empty()) return t;
    const ThresholdGrid grid = grid_of(walls.study.fragility);
    const auto overall = fragility::mode_shares(all, grid.points, mode_of, 2);
    for (std::size_t p = 0; p < grid.points.size(); ++p)
        t.rows.push_back({number(grid.points[p][0], 6), number(grid.points[p][1], 6)});
    for (const StudyLevel& level : walls.levels) {
        const auto figures = figures_of(level);
        std::vector<fragility::ThresholdShares> shares;
        if (!figures.empty()) shares = fragility::mode_shares(figures, grid.points, mode_of, 2);
        for (std::size_t p = 0; p < grid.points.size(); ++p)
            t.rows[p].push_back(shares.empty() ? ""
                                               : fixed(100.0 * shares[p].shares[kMixed], 0));
    }
    for (std::size_t p = 0; p < grid.points.size(); ++p)
        t.rows[p].push_back(fixed(100.0 * overall[p].moved, 1));
    return t;
}

} // namespace app
