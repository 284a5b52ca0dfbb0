#include "uq/fields/spatial_sample.hpp"

#include "core/normal.hpp"
#include "uq/designs/iman_conover.hpp"
#include "uq/fields/field.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace uq {
namespace {

/// Standard normal coordinates of each input.
using Coordinates = std::vector<std::vector<double>>;

int coordinates_of(const SpatialPlan& plan, const SpatialInput& input)
{
    if (input.sites == 1) return 1;
    if (input.over == OverSites::stratified) return 0;
    if (input.over == OverSites::independent) return input.sites;
    return static_cast<int>(plan.fields[input.field].map.cols());
}

void number_columns(SpatialPlan& plan)
{
    std::vector<int> left;
    for (const SpatialInput& input : plan.inputs) left.push_back(coordinates_of(plan, input));
    plan.columns.resize(plan.inputs.size());
    while (std::ranges::any_of(left, [](int n) { return n > 0; }))
        for (std::size_t i = 0; i < left.size(); ++i)
            if (left[i]-- > 0) plan.columns[i].push_back(plan.n_columns++);
}

/// Correlates coordinate c of each input with coordinate c of the inputs before it.
void mix(const Eigen::MatrixXd& factor, Coordinates& z)
{
    for (std::size_t i = z.size(); i-- > 0;)
        for (std::size_t c = 0; c < z[i].size(); ++c) {
            const auto row = static_cast<Eigen::Index>(i);
            double sum = factor(row, row) * z[i][c];
            for (std::size_t j = 0; j < i; ++j)
                if (const double l = factor(row, static_cast<Eigen::Index>(j)); l != 0.0)
                    sum += l * z[j][c];
            z[i][c] = sum;
        }
}

/// A Latin hypercube over the sites of one sample, on the standard normal axis.
std::vector<double> stratified(int n, Stream& random)
{
    std::vector<int> stratum(static_cast<std::size_t>(n));
    std::iota(stratum.begin(), stratum.end(), 0);
    for (std::size_t i = stratum.size() - 1; i > 0; --i) // Fisher-Yates
        std::swap(stratum[i], stratum[random.below(i + 1)]);
    std::vector<double> z;
    for (const int s : stratum) z.push_back(core::normal_quantile((s + random.uniform()) / n));
    return z;
}

std::vector<double> over_sites(const SpatialPlan& plan, const SpatialInput& input,
                               const std::vector<double>& z, Stream& random)
{
    if (input.sites == 1 || input.over == OverSites::independent) return z;
    if (input.over == OverSites::stratified) return stratified(input.sites, random);
    const Eigen::MatrixXd row =
        Eigen::Map<const Eigen::RowVectorXd>(z.data(), static_cast<Eigen::Index>(z.size()));
    const Eigen::MatrixXd field = realise(plan.fields[input.field], row);
    return {field.data(), field.data() + field.size()};
}

/// Puts one row of the table in place of the values of its inputs.
void take_row(const JointRows& together, const Coordinates& z,
              std::vector<std::vector<double>>& values)
{
    if (together.inputs.empty()) return;
    const auto n = static_cast<double>(together.rows.size());
    const double at = core::normal_cdf(z[together.inputs.front()].front()) * n;
    const auto& row = together.rows[static_cast<std::size_t>(std::min(at, n - 1.0))];
    for (std::size_t k = 0; k < row.size(); ++k) values[together.inputs[k]] = {row[k]};
}

} // namespace

SpatialPlan spatial_plan(std::vector<SpatialInput> inputs, std::vector<FieldBasis> fields,
                         std::optional<NormalCopula> dependence, bool latin)
{
    SpatialPlan plan{
        std::move(inputs), std::move(fields), std::move(dependence), false, {}, 0, {}};
    number_columns(plan);
    plan.reordered = plan.dependence && latin &&
                     std::ranges::all_of(plan.inputs, [](const SpatialInput& input) {
                         return input.sites == 1;
                     });
    return plan;
}

void reorder(Eigen::MatrixXd& u, const Eigen::MatrixXd& rho_z,
             std::span<const std::uint32_t> sizes)
{
    Eigen::Index before = 0;
    for (const std::uint32_t n : sizes) {
        const Eigen::MatrixXd block = u.middleRows(before, n - before);
        u.middleRows(before, n - before) = reordered(block, rho_z, normal_scores(block));
        before = n;
    }
}

std::vector<std::vector<double>> draw(const SpatialPlan& plan, const Eigen::VectorXd& normal,
                                      Stream& random)
{
    Coordinates z(plan.inputs.size());
    for (std::size_t i = 0; i < z.size(); ++i)
        for (const int column : plan.columns[i]) z[i].push_back(normal(column));
    if (plan.dependence && !plan.reordered) mix(plan.dependence->factor, z);
    std::vector<std::vector<double>> values;
    for (std::size_t i = 0; i < z.size(); ++i) {
        values.push_back(over_sites(plan, plan.inputs[i], z[i], random));
        for (double& value : values.back()) value = from_normal(plan.inputs[i].marginal, value);
    }
    take_row(plan.together, z, values);
    return values;
}

} // namespace uq
