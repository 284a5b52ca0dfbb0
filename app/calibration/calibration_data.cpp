#include "app/calibration/calibration_data.hpp"

#include "app/text/config_error.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/// The walls of a level that have the answer, and how many have none or only a bound.
struct LevelAnswer {
    AnswerPoints points;
    std::size_t without = 0, bounds = 0;
};

LevelAnswer answer_of(const StudyLevel& level, const StudyWalls& walls,
                      const CalibratedInputs& inputs, const TestedQuantity& quantity)
{
    std::vector<std::size_t> places;
    for (const CalibratedInput& in : inputs.inputs) places.push_back(*input_of(walls, in.key));
    LevelAnswer a;
    a.without = level.failed_walls.size();
    std::vector<Eigen::VectorXd> u;
    std::vector<double> y;
    for (const StudyWall& w : level.walls) {
        const double value =
            shown(quantity, {w.reading, w.curve.displacement, w.curve.force}, walls.rules);
        if (!(value > 0.0 && std::isfinite(value))) {
            ++a.without;
            continue;
        }
        if (is_bound(quantity, w.reading)) ++a.bounds;
        Eigen::VectorXd x(static_cast<Eigen::Index>(places.size()));
        for (std::size_t i = 0; i < places.size(); ++i)
            x(static_cast<Eigen::Index>(i)) =
                w.inputs[places[i]] / walls.inputs[places[i]].scale;
        u.push_back(to_coordinates(inputs, x));
        y.push_back(std::log(value));
    }
    a.points.u.resize(static_cast<Eigen::Index>(u.size()),
                      static_cast<Eigen::Index>(places.size()));
    a.points.y.resize(static_cast<Eigen::Index>(u.size()));
    for (std::size_t i = 0; i < u.size(); ++i) {
        a.points.u.row(static_cast<Eigen::Index>(i)) = u[i].transpose();
        a.points.y(static_cast<Eigen::Index>(i)) = y[i];
    }
    return a;
}

/// Why an answer cannot be used; empty if it can.
std::string trouble(const LevelAnswer& a, const TestedQuantity& quantity, double stress,
                    int least)
{
    const auto n = static_cast<std::size_t>(a.points.y.size());
    const std::string at = quantity.words + " under " + stress_text(stress);
    if (n < static_cast<std::size_t>(least))
        return at + ": only " + counted(n, "wall has", "walls have") + " one, and " +
               std::to_string(least) + " are needed";
    if (ends_with_push(quantity) &&
        static_cast<double>(a.bounds) > kMostOutlasting * static_cast<double>(n))
        return at + ": " + std::to_string(a.bounds) + " of " + std::to_string(n) +
               " walls outlast their push; push them further (load.max_displacement, "
               "solver.kinematics = finite)";
    return {};
}

void add_answer(CalibrationData& data, const TestedQuantity& q, std::size_t level,
                const StudyWalls& walls, const CalibratedInputs& inputs)
{
    const double stress = walls.levels[level].stress;
    LevelAnswer a = answer_of(walls.levels[level], walls, inputs, q);
    const std::string why = trouble(a, q, stress, fewest_walls(inputs.inputs.size()));
    if (!why.empty()) {
        data.remarks.push_back("Not used, " + why + ".");
        return;
    }
    if (a.without + a.bounds > 0)
        data.remarks.push_back(q.words + " under " + stress_text(stress) + ": " +
                               counted(a.without, "wall", "walls") + " without it left out, " +
                               counted(a.bounds, "wall", "walls") +
                               " taken at the end of the push.");
    data.answers.push_back({data.quantities.size(), level, stress, std::move(a.points)});
}

void use_tests(CalibrationData& data, const std::vector<MeasuredTest>& tests)
{
    std::size_t left_out = 0;
    for (std::size_t kind = 0; kind < data.quantities.size(); ++kind) {
        const TestedQuantity& q = data.quantities[kind];
        for (std::size_t i = 0; i < tests.size(); ++i) {
            const MeasuredTest& t = tests[i];
            const std::optional<double> value = measured(q, t);
            if (!value) continue;
            const auto found =
                std::ranges::find_if(data.answers, [&](const CalibratedAnswer& a) {
                    return a.kind == kind && same_stress(a.stress, t.stress);
                });
            if (found == data.answers.end())
                ++left_out;
            else
                data.tests.push_back({i, static_cast<std::size_t>(found - data.answers.begin()),
                                      *value, ends_with_push(q) && t.censored, t.error});
        }
    }
    if (left_out > 0)
        data.remarks.push_back(counted(left_out, "measured value has", "measured values have") +
                               " no answer of the model to stand beside, and " +
                               (left_out == 1 ? "is" : "are") + " left out.");
}

} // namespace

CalibrationData calibration_data(const StudyFile& source, const CalibratedInputs& inputs,
                                 const StudyWalls& walls,
                                 const std::vector<TestedQuantity>& quantities,
                                 const std::vector<MeasuredTest>& tests)
{
    CalibrationData data;
    for (const TestedQuantity& q : quantities) {
        if (!is_tested(tests, q)) continue;
        const std::size_t before = data.answers.size();
        for (std::size_t l = 0; l < walls.levels.size(); ++l)
            add_answer(data, q, l, walls, inputs);
        if (data.answers.size() > before) data.quantities.push_back(q);
    }
    use_tests(data, tests);
    if (data.tests.empty()) {
        std::string all;
        for (const std::string& r : data.remarks) all += " " + r;
        throw error_at(source, "calibration.inputs", "no test is left to learn from." + all);
    }
    if (std::ranges::all_of(data.tests, [&](const UsedTest& t) {
            const Eigen::VectorXd& y = data.answers[t.answer].points.y;
            return y.maxCoeff() - y.minCoeff() < 1e-9;
        }))
        throw error_at(source, "calibration.inputs",
                       "what was measured is the same on all walls of the study: it does not "
                       "depend on the inputs, and tests teach nothing about them");
    return data;
}

} // namespace app
