#include "app/fragility/numbers/tested_walls.hpp"

#include "app/input/study/model_factor_text.hpp"
#include "app/input/study/study.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

/// Measured: docs/tests/comparison.csv. A displacement is the first fall to 80 % of the peak;
/// SW.200.2 ended before. The walls under 30 kN turned about a toe that this model does not
/// have, and say nothing of the drop (docs/validation.md, section 1).
struct Test {
    std::string_view name;
    double stress;             ///< [MPa]
    double peak, displacement; ///< [kN] [mm]; 0: not used
    bool at_least;             ///< of the displacement
};
constexpr std::array kTests = {
    Test{"SW.30.1", 0.15, 21.5, 0.0, false},    Test{"SW.30.2", 0.15, 22.7, 0.0, false},
    Test{"SW.100.1", 0.50, 41.5, 12.6, false},  Test{"SW.100.2", 0.50, 48.2, 18.9, false},
    Test{"SW.200.1", 1.00, 72.2, 16.1, false},  Test{"SW.200.2", 1.00, 68.6, 22.65, true},
    Test{"SW.250.1", 1.25, 102.5, 9.28, false},
};

/// Medians of 50 walls under each stress, as this program pushes them. Combined damping:
/// configs/collapse.ini with load.stop_below = 0.79 and solver.fidelity = standard, all walls
/// to their drop; its peaks, too. Local damping: configs/paper.ini, 34 to 48 % of the walls
/// censored (Kaplan and Meier). Mean peaks of both differ by at most 3 %.
struct Predicted {
    double stress;                ///< [MPa]
    double peak, combined, local; ///< [kN] [mm] [mm]; 0: no test to compare with
};
constexpr std::array kPredicted = {
    Predicted{0.15, 15.4, 0.0, 0.0}, Predicted{0.50, 44.8, 19.2, 25.4},
    Predicted{1.00, 83.1, 22.3, 22.4}, Predicted{1.25, 100.4, 16.8, 21.0}};

constexpr double kConfidence = 0.90; // of the intervals that are told

double at(const fragility::HierarchicalPosterior& posterior, double p)
{
    return fragility::scatter_quantile(posterior, p);
}

/// One of the four factors of the tests; each is the same in every call.
const EstimatedFactor& tests_factor(Answer answer, dem::Damping damping)
{
    if (answer == Answer::force) {
        static const EstimatedFactor kForce =
            estimated_factor(tested_walls(Answer::force, dem::Damping::combined));
        return kForce;
    }
    if (damping == dem::Damping::local) {
        static const EstimatedFactor kLocal =
            estimated_factor(tested_walls(Answer::drift, dem::Damping::local));
        return kLocal;
    }
    static const EstimatedFactor kCombined =
        estimated_factor(tested_walls(Answer::drift, dem::Damping::combined));
    return kCombined;
}

std::string outside(std::string_view what, double value, double least, double most,
                    std::string_view unit)
{
    if (value >= least * (1.0 - 1e-9) && value <= most * (1.0 + 1e-9)) return {};
    return std::string(what) + " " + number(value, 3) + " " + std::string(unit) + ", outside " +
           number(least, 3) + " to " + number(most, 3) + " " + std::string(unit);
}

/// The sentence on the factor of the tests, for a caption: its numbers, and how many walls
/// stand behind it.
std::string tests_text(Answer answer, const dem::SolverOptions& solver)
{
    const auto walls = tested_walls(answer, solver.damping);
    const EstimatedFactor& e = tests_factor(answer, solver.damping);
    const auto two = [](double x) { return fixed(x, 2); };
    return "The factor of the tests (test over prediction, " + std::to_string(walls.size()) +
           " walls of Lourenco et al. 2005) has the median " + two(e.factor.median) + " [" +
           two(e.median.lower) + ", " + two(e.median.upper) + "] and the dispersion " +
           two(e.factor.dispersion) + " [" + two(e.dispersion.lower) + ", " +
           two(e.dispersion.upper) + "], intervals of 90 %.";
}

/// "0.55 to 1.02": least and largest of measured over predicted.
std::string ratios_text(std::span<const TestedWall> walls)
{
    const auto ratio = [](const TestedWall& w) { return w.measured / w.predicted; };
    const auto [least, most] = std::ranges::minmax_element(walls, {}, ratio);
    return fixed(ratio(*least), 2) + " to " + (most->at_least ? "more than " : "") +
           fixed(ratio(*most), 2);
}

} // namespace

std::string tests_sentence(dem::Damping damping)
{
    const auto peaks = tested_walls(Answer::force, damping);
    const auto drops = tested_walls(Answer::drift, damping);
    return "In a laboratory " + std::to_string(peaks.size()) +
           " walls of dry sandstone were pushed (Lourenco et al. 2005): their peak forces "
           "were " +
           ratios_text(peaks) + " times those of this program, and the limits of " +
           std::to_string(drops.size()) + " of them " + ratios_text(drops) +
           " times. The others, under the least load, turned about a toe that this model does "
           "not have: one fell at less than a third of the displacement to which this "
           "program's walls stand";
}

std::vector<TestedWall> tested_walls(Answer answer, dem::Damping damping)
{
    std::vector<TestedWall> walls;
    for (const Test& t : kTests) {
        const Predicted& p = *std::ranges::find(kPredicted, t.stress, &Predicted::stress);
        const bool force = answer == Answer::force;
        const double measured = force ? t.peak : t.displacement;
        if (!(measured > 0.0)) continue;
        const double drop = damping == dem::Damping::local ? p.local : p.combined;
        walls.push_back({std::string(t.name), 1e6 * t.stress, measured, force ? p.peak : drop,
                         !force && t.at_least});
    }
    return walls;
}

std::vector<fragility::LevelledValue> log_ratios(std::span<const TestedWall> walls)
{
    std::vector<double> levels;
    std::vector<fragility::LevelledValue> values;
    for (const TestedWall& w : walls) {
        auto level = std::ranges::find(levels, w.stress);
        if (level == levels.end()) level = levels.insert(level, w.stress);
        values.push_back({static_cast<std::size_t>(level - levels.begin()),
                          std::log(w.measured / w.predicted), w.at_least, 0.0});
    }
    return values;
}

EstimatedFactor estimated_factor(std::span<const TestedWall> walls)
{
    const auto posterior = fragility::hierarchical_posterior(log_ratios(walls), kFactorPrior);
    EstimatedFactor e;
    e.factor = {std::exp(posterior.mu), posterior.scatter, posterior.mu_error};
    const double low = 0.5 * (1.0 - kConfidence), high = 0.5 * (1.0 + kConfidence);
    e.median = {std::exp(fragility::mu_quantile(posterior, low)),
                std::exp(fragility::mu_quantile(posterior, high)), kConfidence};
    e.dispersion = {at(posterior, low), at(posterior, high), kConfidence};
    return e;
}

std::string unlike_tested(const Masonry& masonry, const LoadInput& load, double stress,
                          Answer answer)
{
    if (is_drawn(masonry.geometry) || masonry.geometry.rubble) return "they are not in courses";
    if (!masonry.geometry.openings.empty()) return "they have openings";
    if (has_mortar(masonry.parameters.joint)) return "their joints are bonded";
    if (!masonry.cracks.in_units) return "their units cannot crack";
    if (push_way(load).direction == 0) return "they are pushed to and fro";
    if (std::string why = outside("their length is", wall_length(masonry), 0.75, 1.25, "m");
        !why.empty())
        return why;
    if (std::string why = outside("their load stands at", load.height, 0.80, 1.40, "m");
        !why.empty())
        return why;
    return outside("their vertical stress is", stress / 1e6,
                   answer == Answer::drift ? 0.40 : 0.12, 1.50, "MPa");
}

AppliedFactor applied_factor(const Study& study, double stress, Answer answer)
{
    const FragilityInput& f = study.fragility;
    const FactorChoice choice =
        parse_model_factor(answer == Answer::drift ? f.model_factor : f.model_factor_force);
    if (choice.given) return {*choice.given, "given", {}};
    if (!choice.tests) return {};
    fragility::ModelFactor factor = tests_factor(answer, study.solver.damping).factor;
    std::string unlike = unlike_tested(study, study.load, stress, answer);
    if (unlike.empty()) return {factor, "tests", {}};
    factor.median_error = std::hypot(factor.median_error, std::log(factor.median));
    factor.median = 1.0;
    return {factor, "tests, median not applied", std::move(unlike)};
}

std::string factor_text(const dem::SolverOptions& solver, const FragilityInput& fragility,
                        Answer answer)
{
    const bool drift = answer == Answer::drift;
    const std::string& text = drift ? fragility.model_factor : fragility.model_factor_force;
    const std::string key = drift ? "fragility.model_factor" : "fragility.model_factor_force";
    const std::string start = key + " = " + text + ".";
    return text == "tests" ? start + " " + tests_text(answer, solver) : start;
}

} // namespace app
