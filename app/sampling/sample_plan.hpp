#pragma once
/// From a study to the random values of each of its walls.

#include "app/input/study.hpp"
#include "app/sampling/wall_draw.hpp"
#include "uq/designs/stream.hpp"
#include "uq/fields/field_basis.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace app {

/// Everything the draws of a study have in common. Each input has coordinates: one, or one for each
/// of the joints over which it varies, or as many as its random field needs. Column by column of the
/// design come the first coordinates of all inputs, then their second ones, ...: a study that is not
/// spatial has the first columns of the spatial one.
struct SamplePlan {
    Spatial spatial = Spatial::none;
    std::vector<RandomInput> inputs;
    std::vector<int> n_values;             ///< per wall, of each input
    std::vector<std::vector<int>> columns; ///< of the design, of each input
    int n_columns = 0;
    uq::FieldBasis joints, cracks;       ///< with Spatial::correlated
    Eigen::MatrixXd mixing;              ///< of the inputs' coordinates; empty: none to be done
    std::vector<std::uint64_t> seeds;    ///< of each level
    std::vector<Eigen::MatrixXd> design; ///< of each level: samples x n_columns, in (0, 1)
};

/// Seed of the design of a stress level: it belongs to the stress, not to its place in the list.
[[nodiscard]] std::uint64_t level_seed(const UqInput& uq, double vertical_stress);

/// @param sizes through which the design has grown, the last one study.uq.samples
/// @throws ConfigError where the study asks for what its design or correlation cannot give
[[nodiscard]] SamplePlan sample_plan(const Study& study, const dem::Layout& layout,
                                     std::span<const std::uint32_t> sizes);

/// @param sample in [0, samples)
[[nodiscard]] WallDraw draw(const SamplePlan& plan, int level, int sample);

/// The draw at given coordinates.
/// @param normal n_columns standard normal values
/// @param random for Spatial::stratified alone, which draws inside the wall
[[nodiscard]] WallDraw draw_at(const SamplePlan& plan, const Eigen::VectorXd& normal,
                               uq::Stream& random);

/// All values of a draw in one row, input by input.
[[nodiscard]] std::vector<double> flattened(const WallDraw& draw);
/// And back.
[[nodiscard]] WallDraw unflattened(const SamplePlan& plan, const Eigen::VectorXd& row);

} // namespace app
