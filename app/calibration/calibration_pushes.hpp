#pragma once
/// True walls at points of a posterior.

#include "app/calibration/calibration_data.hpp"
#include "app/input/prepared_study.hpp"
#include "app/sampling/wall_draw.hpp"
#include "uq/fields/spatial_sample.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace app {

/// Whether a wall of the study is one push of one layout, and can be pushed again by its inputs
/// alone.
[[nodiscard]] bool is_pushed_again(const PreparedStudy& ready);

/// The values of a wall whose calibrated inputs have these coordinates. The others are drawn
/// as the study draws them, with its correlations and joint rows.
/// @param others value_plan(study, layout, false) of a study whose inputs have one value a wall
/// @param row the same seed and row draw the same values
[[nodiscard]] WallDraw wall_at(const uq::SpatialPlan& others, const CalibratedInputs& inputs,
                               const Eigen::VectorXd& u, std::uint64_t seed, std::uint64_t row);

/// ln of the answers of walls with these inputs, a row for each and a column for each answer;
/// NaN where a wall does not have it. Other random inputs are drawn, row by row, from the seed.
/// @param u coordinates, a row for each wall
/// @param seen is told how many walls are done
/// @throws Interrupted
[[nodiscard]] Eigen::MatrixXd
pushed_answers(const PreparedStudy& ready, const CalibratedInputs& inputs,
               const CalibrationData& data, const Eigen::MatrixXd& u, std::uint64_t seed,
               int threads, const std::function<void(std::size_t)>& seen);

/// Error of a surrogate on true walls.
struct SurrogateMiss {
    std::size_t walls = 0;         ///< that have the answer
    double root_mean_square = 0.0; ///< of ln
};
[[nodiscard]] std::vector<SurrogateMiss>
missed(const uq::AnswerModel& model, const Eigen::MatrixXd& u, const Eigen::MatrixXd& pushed);

} // namespace app
