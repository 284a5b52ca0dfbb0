#pragma once
/// The random values of each wall of a study.

#include "app/input/study/random_input.hpp"
#include "app/input/study/uq_input.hpp"
#include "app/sampling/wall_draw.hpp"
#include "uq/fields/field_site.hpp"
#include "uq/fields/spatial_sample.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace app {

struct LoadInput;
struct Sampling;
struct StudyFile;

/// Everything that the draws of a study have in common.
struct SamplePlan {
    Spatial spatial = Spatial::none;
    std::vector<RandomInput> inputs;
    uq::SpatialPlan values;           ///< of the inputs, in their order
    std::vector<std::uint64_t> seeds; ///< of each level
    std::vector<Eigen::MatrixXd>
        design; ///< of each level: samples x values.n_columns, in (0, 1)
    std::vector<uq::Site> joints, cracks; ///< where each ID is
};

/// Seed of the design of a stress level: it belongs to the stress, not to its place in the
/// list.
[[nodiscard]] std::uint64_t level_seed(const UqInput& uq, double vertical_stress);

/// How standard normal numbers become the values of a wall.
/// @param latin whether their rows are those of a Latin hypercube
/// @throws ConfigError where the correlation or the rows asked for cannot be had
[[nodiscard]] uq::SpatialPlan value_plan(const Sampling& sampling, const StudyFile& source,
                                         const dem::Layout& layout, bool latin);

/// The plan of a study's draws.
/// @param sizes through which the design has grown, the last one study.uq.samples
/// @throws ConfigError where the study asks for what its design or correlation cannot give
[[nodiscard]] SamplePlan sample_plan(const Sampling& sampling, const LoadInput& load,
                                     const StudyFile& source, const dem::Layout& layout,
                                     std::span<const std::uint32_t> sizes);

/// The values of one wall.
/// @param sample in [0, samples)
[[nodiscard]] WallDraw draw(const SamplePlan& plan, int level, int sample);

/// All values of a draw in one row, input by input.
[[nodiscard]] std::vector<double> flattened(const WallDraw& draw);
/// The draw that has the values of `row`: undoes flattened.
[[nodiscard]] WallDraw unflattened(const SamplePlan& plan, const Eigen::VectorXd& row);

} // namespace app
