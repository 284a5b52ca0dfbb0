#include "app/fragility/numbers/sampling_errors.hpp"

#include "app/fragility/numbers/table_texts.hpp"
#include "app/output/table/cells.hpp"
#include "app/reading/wall_numbers.hpp"
#include "uq/estimates/estimate.hpp"
#include "uq/estimates/latin_error.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace app {
namespace {

/// One row for each wall that gave a result.
Eigen::MatrixXd inputs_of(const StudyWalls& walls, const StudyLevel& level)
{
    Eigen::MatrixXd inputs(static_cast<Eigen::Index>(level.walls.size()),
                           static_cast<Eigen::Index>(walls.inputs.size()));
    for (std::size_t i = 0; i < level.walls.size(); ++i)
        for (std::size_t k = 0; k < walls.inputs.size(); ++k)
            inputs(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
                level.walls[i].inputs[k];
    return inputs;
}

/// Degree of the additive part that the walls of a level tell; 0: they tell none.
int additive_degree(const StudyWalls& walls, const StudyLevel& level)
{
    return uq::latin_degree(static_cast<Eigen::Index>(level.walls.size()),
                            static_cast<Eigen::Index>(walls.inputs.size()));
}

struct Values {
    std::vector<double> y;
    std::vector<bool> member; ///< walls whose y counts
};

void add_mean(const StudyWalls& walls, const StudyLevel& level, const std::string& what,
              const Values& v, int decimals, Table& t)
{
    std::vector<double> counted;
    for (std::size_t i = 0; i < v.y.size(); ++i)
        if (v.member[i]) counted.push_back(v.y[i]);
    Row row = {stress_cell(level.stress), what, count(counted.size())};
    if (counted.size() < 2) return add_row(t, row, "Fewer than two walls.");
    const uq::Estimate e = uq::estimate_mean(counted);
    row.emplace_back(plain_number(e.value, decimals));
    row.emplace_back(plain_number(e.std_error, decimals + 1));
    const auto error = hypercube_error(walls, level, v.y, v.member);
    if (!error && in_hypercube(walls.study))
        return add_row(
            t, row,
            "Fewer than 4 (inputs + 1) = " + std::to_string(4 * (walls.inputs.size() + 1)) +
                " walls do not tell what the hypercube removes.");
    if (!error)
        return add_row(t, row, "No Latin hypercube with one value of each input per wall.");
    row.emplace_back(plain_number(*error, decimals + 1));
    row.emplace_back(e.std_error > 0.0 ? plain_number(*error / e.std_error, 2) : Number{});
    add_row(t, row);
}

} // namespace

bool in_hypercube(const Sampling& sampling)
{
    const bool latin = sampling.uq.design == uq::DesignKind::latin_random ||
                       sampling.uq.design == uq::DesignKind::latin_centred ||
                       sampling.uq.design == uq::DesignKind::latin_optimised;
    return latin && sampling.uq.spatial == Spatial::none && sampling.uq.pearson.empty() &&
           sampling.uq.together.empty() && !sampling.random.empty();
}

std::optional<double> hypercube_error(const StudyWalls& walls, const StudyLevel& level,
                                      std::span<const double> y,
                                      const std::vector<bool>& member)
{
    if (!in_hypercube(walls.study) || additive_degree(walls, level) == 0 ||
        std::ranges::count(member, true) < 2)
        return {};
    return uq::latin_subset_error(y, member, inputs_of(walls, level));
}

std::optional<SamplingError> log_peak_error(const StudyWalls& walls, const StudyLevel& level)
{
    Values v;
    for (const StudyWall& w : level.walls) {
        const double peak = peak_force(w.reading);
        v.member.push_back(peak > 0.0);
        v.y.push_back(peak > 0.0 ? std::log(peak) : 0.0);
    }
    const auto error = hypercube_error(walls, level, v.y, v.member);
    if (!error) return {};
    const auto coefficients =
        1.0 + additive_degree(walls, level) * static_cast<double>(walls.inputs.size());
    const auto n = static_cast<double>(std::ranges::count(v.member, true));
    return SamplingError{*error, std::max(1.0, n - coefficients)};
}

Table sampling_error_table(const StudyWalls& walls)
{
    Table t = titled_table("sampling_errors", words_of(walls));
    t.keys = 2;
    t.head = {"stress [MPa]",
              "mean of",
              "n",
              "mean",
              "error, independent walls",
              "error, hypercube",
              "hypercube / independent",
              {"note", kNote}};
    for (const StudyLevel& level : walls.levels) {
        Values peak, fell;
        for (const StudyWall& w : level.walls) {
            const double force = peak_force(w.reading);
            peak.member.push_back(force > 0.0);
            peak.y.push_back(force > 0.0 ? force / 1e3 : 0.0);
            fell.member.push_back(is_observed(w.reading.ultimate));
            fell.y.push_back(1e3 * w.reading.ultimate.displacement);
        }
        add_mean(walls, level, head_text(wall_number("peak_force")), peak, 2, t);
        for (const int mode : modes_of(walls)) {
            Values share;
            for (const StudyWall& w : level.walls) {
                share.member.push_back(true);
                share.y.push_back(mode_of(w) == mode ? 100.0 : 0.0);
            }
            add_mean(walls, level, std::string(mode_name(mode)) + " [%]", share, 1, t);
        }
        add_mean(walls, level, "displacement of those that fell [mm]", fell, 2, t);
    }
    return t;
}

} // namespace app
