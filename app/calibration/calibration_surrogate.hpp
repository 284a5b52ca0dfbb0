#pragma once
/// The answers of walls that were never pushed: a Gaussian process of the ln of each answer.

#include "uq/inference/calibration.hpp"
#include "uq/surrogates/gaussian_process.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace app {

/// Walls as points: coordinates of the inputs, and ln of the answer in its shown unit.
struct AnswerPoints {
    Eigen::MatrixXd u; ///< walls x inputs
    Eigen::VectorXd y;
};

/// The points of `a`, then those of `b`.
[[nodiscard]] AnswerPoints joined(const AnswerPoints& a, const AnswerPoints& b);

struct AnswerSurrogate {
    std::optional<uq::GaussianProcess>
        process;           ///< nothing: the answer is the same on all walls
    double constant = 0.0; ///< ln of that answer
    /// Variance of the process, times this: mean square of what it misses on walls left out
    /// over what it promises, at least 1.
    double inflation = 1.0;
    double left_out = 0.0; ///< root mean square of ln of what it misses there
    double q2 = 0.0;       ///< share of the variance of ln that it explains there [-]
};

/// The kernel and trend with the smallest error on walls left out, judged by parts held out
/// (uq::held_out).
/// @throws std::invalid_argument if no process can be fitted
[[nodiscard]] AnswerSurrogate fit_answer(const AnswerPoints& points);

/// Variance of one wall about the process, which other inputs or jumps of the answer make.
[[nodiscard]] double noise_of(const AnswerSurrogate& answer);

/// @param deterministic the inputs alone make a wall: noise is doubt of the process, shared by
/// all tests of an answer; else it is scatter of walls
[[nodiscard]] uq::AnswerModel answer_model(std::vector<AnswerSurrogate> answers,
                                           bool deterministic);

} // namespace app
