#include "app/sampling/sample_plan.hpp"

#include "app/sampling/study_dependence.hpp"
#include "app/sampling/study_design.hpp"
#include "app/sampling/study_kernel.hpp"
#include "app/sampling/wall_sites.hpp"
#include "uq/designs/iman_conover.hpp"
#include "uq/designs/stream.hpp"
#include "uq/fields/field.hpp"
#include "uq/marginals/normal_quantile.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace app {
namespace {

/// Coordinates that the design gives to an input.
int coordinates_of(const SamplePlan& plan, std::size_t input)
{
    if (plan.n_values[input] == 1) return 1;
    if (plan.spatial == Spatial::stratified) return 0;
    if (plan.spatial == Spatial::independent) return plan.n_values[input];
    const bool joint = plan.inputs[input].varies == Varies::by_joint;
    return static_cast<int>((joint ? plan.joints : plan.cracks).map.cols());
}

/// First coordinates of all inputs, then second ones, ...
void number_columns(SamplePlan& plan)
{
    std::vector<int> left;
    for (std::size_t i = 0; i < plan.inputs.size(); ++i)
        left.push_back(coordinates_of(plan, i));
    plan.columns.resize(plan.inputs.size());
    while (std::any_of(left.begin(), left.end(), [](int n) { return n > 0; }))
        for (std::size_t i = 0; i < left.size(); ++i)
            if (left[i]-- > 0) plan.columns[i].push_back(plan.n_columns++);
}

bool varies(const Study& study, Varies how)
{
    return std::any_of(study.random.begin(), study.random.end(),
                       [how](const RandomInput& r) { return r.varies == how; });
}

uq::FieldBasis basis_over(const Study& study, const std::vector<uq::Site>& sites)
{
    return uq::cholesky_basis(uq::correlation_matrix(kernel_of(study), sites));
}

/// Rows of each size reordered among themselves: a Latin hypercube stays one.
void correlate(const Study& study, const Eigen::MatrixXd& target,
               std::span<const std::uint32_t> sizes, Eigen::MatrixXd& u)
{
    Eigen::Index before = 0;
    try {
        for (const std::uint32_t n : sizes) {
            const Eigen::MatrixXd block = u.middleRows(before, n - before);
            u.middleRows(before, n - before) =
                uq::reordered(block, target, uq::normal_scores(block));
            before = n;
        }
    } catch (const std::invalid_argument& bad) {
        throw error_at(study.source, "uq.samples", bad.what());
    }
}

using Coordinates = std::vector<std::vector<double>>; ///< standard normal, of each input

Coordinates coordinates(const SamplePlan& plan, const Eigen::VectorXd& normal)
{
    Coordinates z(plan.inputs.size());
    for (std::size_t i = 0; i < z.size(); ++i)
        for (const int column : plan.columns[i]) z[i].push_back(normal(column));
    return z;
}

/// Correlates coordinate c of each input with coordinate c of the inputs before it.
void mix(const Eigen::MatrixXd& mixing, Coordinates& z)
{
    if (mixing.size() == 0) return;
    for (std::size_t i = z.size(); i-- > 0;)
        for (std::size_t c = 0; c < z[i].size(); ++c) {
            const auto row = static_cast<Eigen::Index>(i);
            double sum = mixing(row, row) * z[i][c];
            for (std::size_t j = 0; j < i; ++j)
                if (const double l = mixing(row, static_cast<Eigen::Index>(j)); l != 0.0)
                    sum += l * z[j][c];
            z[i][c] = sum;
        }
}

/// A Latin hypercube over the joints of one wall.
std::vector<double> stratified(int n, uq::Stream& random)
{
    std::vector<int> stratum(static_cast<std::size_t>(n));
    std::iota(stratum.begin(), stratum.end(), 0);
    for (std::size_t i = stratum.size() - 1; i > 0; --i) // Fisher-Yates
        std::swap(stratum[i], stratum[random.below(i + 1)]);
    std::vector<double> z;
    for (const int s : stratum) z.push_back(uq::normal_quantile((s + random.uniform()) / n));
    return z;
}

std::vector<double> over_sites(const SamplePlan& plan, std::size_t input,
                               const std::vector<double>& z, uq::Stream& random)
{
    if (plan.n_values[input] == 1) return z;
    if (plan.spatial == Spatial::stratified) return stratified(plan.n_values[input], random);
    if (plan.spatial == Spatial::independent) return z;
    const uq::FieldBasis& basis =
        plan.inputs[input].varies == Varies::by_joint ? plan.joints : plan.cracks;
    const Eigen::MatrixXd row =
        Eigen::Map<const Eigen::RowVectorXd>(z.data(), static_cast<Eigen::Index>(z.size()));
    const Eigen::MatrixXd field = uq::realise(basis, row);
    return {field.data(), field.data() + field.size()};
}

} // namespace

std::uint64_t level_seed(const UqInput& uq, double vertical_stress)
{
    if (uq.shared) return uq.seed;
    return uq::bits(uq.seed, std::bit_cast<std::uint64_t>(vertical_stress),
                    uq::Purpose::replicate, 0);
}

SamplePlan sample_plan(const Study& study, const dem::Layout& layout,
                       std::span<const std::uint32_t> sizes)
{
    SamplePlan plan;
    plan.spatial = study.uq.spatial;
    plan.inputs = study.random;
    for (const RandomInput& input : study.random)
        plan.n_values.push_back(values_per_wall(input, plan.spatial, layout));
    if (plan.spatial == Spatial::correlated) {
        if (varies(study, Varies::by_joint))
            plan.joints = basis_over(study, joint_sites(layout));
        if (varies(study, Varies::by_crack))
            plan.cracks = basis_over(study, crack_sites(layout));
    }
    number_columns(plan);
    const std::optional<uq::JointDistribution> dependence = dependence_of(study);
    const bool reorder =
        dependence && plan.spatial == Spatial::none && is_latin(study.uq.design);
    if (dependence && !reorder) plan.mixing = dependence->factor;
    for (const double stress : study.load.vertical_stress) {
        plan.seeds.push_back(level_seed(study.uq, stress));
        plan.design.push_back(unit_cube_of(study, plan.n_columns, plan.seeds.back(), sizes));
        if (reorder) correlate(study, dependence->rho_z, sizes, plan.design.back());
    }
    return plan;
}

WallDraw draw_at(const SamplePlan& plan, const Eigen::VectorXd& normal, uq::Stream& random)
{
    Coordinates z = coordinates(plan, normal);
    mix(plan.mixing, z);
    WallDraw all;
    for (std::size_t i = 0; i < z.size(); ++i) {
        all.values.push_back(over_sites(plan, i, z[i], random));
        for (double& value : all.values.back())
            value = uq::from_normal(plan.inputs[i].marginal, value);
    }
    return all;
}

WallDraw draw(const SamplePlan& plan, int level, int sample)
{
    const auto l = static_cast<std::size_t>(level);
    const Eigen::VectorXd normal =
        plan.design[l].row(sample).transpose().unaryExpr(&uq::normal_quantile);
    uq::Stream random(plan.seeds[l], static_cast<std::uint64_t>(sample), uq::Purpose::field);
    return draw_at(plan, normal, random);
}

std::vector<double> flattened(const WallDraw& draw)
{
    std::vector<double> row;
    for (const std::vector<double>& values : draw.values)
        row.insert(row.end(), values.begin(), values.end());
    return row;
}

WallDraw unflattened(const SamplePlan& plan, const Eigen::VectorXd& row)
{
    WallDraw draw;
    const double* from = row.data();
    for (const int n : plan.n_values) {
        draw.values.emplace_back(from, from + n);
        from += n;
    }
    return draw;
}

} // namespace app
