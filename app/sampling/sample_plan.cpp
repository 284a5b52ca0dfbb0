#include "app/sampling/sample_plan.hpp"

#include "app/input/study/study.hpp"
#include "app/sampling/study_dependence.hpp"
#include "app/sampling/study_kernel.hpp"
#include "app/sampling/study_rows.hpp"
#include "app/sampling/wall_sites.hpp"
#include "core/normal.hpp"
#include "uq/designs/design.hpp"
#include "uq/fields/kernel.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

namespace app {
namespace {

uq::SpatialInput spatial_input(const RandomInput& input, Spatial spatial,
                               const dem::Layout& layout)
{
    uq::SpatialInput s;
    s.marginal = input.marginal;
    s.sites = values_per_wall(input, spatial, layout);
    s.over = spatial == Spatial::stratified   ? uq::OverSites::stratified
             : spatial == Spatial::correlated ? uq::OverSites::field
                                              : uq::OverSites::independent;
    s.field = input.varies == Varies::by_crack ? 1 : 0;
    return s;
}

bool varies(const std::vector<RandomInput>& random, Varies how)
{
    return std::ranges::find(random, how, &RandomInput::varies) != random.end();
}

/// Over the joints, and over the cracks; empty if no input varies over them.
std::vector<uq::FieldBasis> fields_of(const Sampling& sampling, const StudyFile& source,
                                      const dem::Layout& layout)
{
    std::vector<uq::FieldBasis> fields(2);
    if (sampling.uq.spatial != Spatial::correlated) return fields;
    const auto over = [&](const std::vector<uq::Site>& sites) {
        return uq::cholesky_basis(
            uq::correlation_matrix(kernel_of(sampling.uq, source), sites));
    };
    if (varies(sampling.random, Varies::by_joint)) fields[0] = over(joint_sites(layout));
    if (varies(sampling.random, Varies::by_crack)) fields[1] = over(crack_sites(layout));
    return fields;
}

Eigen::MatrixXd design_of(const UqInput& uq, const StudyFile& source,
                          const uq::SpatialPlan& plan, std::uint64_t seed,
                          std::span<const std::uint32_t> sizes)
{
    if (plan.n_columns == 0) return Eigen::MatrixXd(sizes.back(), 0);
    const char* key = "uq.design";
    try {
        Eigen::MatrixXd u =
            uq::unit_cube({uq.design, {sizes.begin(), sizes.end()}, plan.n_columns, seed});
        key = "uq.samples";
        if (plan.reordered) uq::reorder(u, plan.dependence->rho_z, sizes);
        return u;
    } catch (const std::invalid_argument& bad) {
        throw error_at(source, key, bad.what());
    }
}

} // namespace

std::uint64_t level_seed(const UqInput& uq, double vertical_stress)
{
    if (uq.shared) return uq.seed;
    return uq::bits(uq.seed, std::bit_cast<std::uint64_t>(vertical_stress),
                    uq::Purpose::replicate, 0);
}

uq::SpatialPlan value_plan(const Sampling& sampling, const StudyFile& source,
                           const dem::Layout& layout, bool latin)
{
    std::vector<uq::SpatialInput> inputs;
    for (const RandomInput& input : sampling.random)
        inputs.push_back(spatial_input(input, sampling.uq.spatial, layout));
    uq::SpatialPlan plan =
        uq::spatial_plan(std::move(inputs), fields_of(sampling, source, layout),
                         dependence_of(sampling, source), latin);
    plan.together = joint_rows(sampling, source);
    return plan;
}

SamplePlan sample_plan(const Sampling& sampling, const LoadInput& load, const StudyFile& source,
                       const dem::Layout& layout, std::span<const std::uint32_t> sizes)
{
    SamplePlan plan{sampling.uq.spatial,
                    sampling.random,
                    value_plan(sampling, source, layout, is_latin(sampling.uq.design)),
                    {},
                    {},
                    joint_sites(layout),
                    crack_sites(layout)};
    for (const double stress : load.vertical_stress) {
        plan.seeds.push_back(level_seed(sampling.uq, stress));
        plan.design.push_back(
            design_of(sampling.uq, source, plan.values, plan.seeds.back(), sizes));
    }
    return plan;
}

WallDraw draw(const SamplePlan& plan, int level, int sample)
{
    Eigen::VectorXd normal = plan.design[level].row(sample).transpose();
    core::to_normal_quantiles({normal.data(), static_cast<std::size_t>(normal.size())});
    uq::Stream random(plan.seeds[level], static_cast<std::uint64_t>(sample),
                      uq::Purpose::field);
    return {uq::draw(plan.values, normal, random)};
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
    std::vector<int> sites;
    for (const uq::SpatialInput& input : plan.values.inputs) sites.push_back(input.sites);
    return draw_of(sites, std::span(row.data(), row.size()));
}

} // namespace app
