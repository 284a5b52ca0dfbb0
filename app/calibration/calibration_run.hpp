#pragma once
/// A whole calibration: surrogates, posteriors, true walls at their points.

#include "app/calibration/calibration_data.hpp"
#include "app/calibration/calibration_pushes.hpp"
#include "core/interval.hpp"

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

namespace app {

struct CalibrationInput;

constexpr std::size_t kPosteriorPoints = 2000; ///< that tables are made of
constexpr double kTableShare = 0.90;           ///< of all intervals
/// True walls under each stress at points of the posterior, and the error in ln of an answer
/// from which they are added to the walls of the study and the fit is made once more (choice).
constexpr std::size_t kCheckedPoints = 12;
constexpr double kLargeMiss = 0.05;

/// A posterior, its points, and further tests at these points: ln of each answer.
struct Taught {
    uq::CalibrationPosterior posterior;
    std::vector<uq::CalibrationPoint> points;
    Eigen::MatrixXd further;
};

/// Further tests under one stress by the tests under all others.
struct LeftOut {
    Eigen::MatrixXd further; ///< empty: no test is under the stress, or no other stress has one
    bool converged = true;   ///< the chains agreed
};

struct CalibrationRun {
    std::vector<AnswerSurrogate> surrogates; ///< of each answer
    uq::AnswerModel model;
    Taught with, without;  ///< discrepancy
    Eigen::MatrixXd prior; ///< ln of each answer at kPosteriorPoints points of the prior
    std::vector<LeftOut> left_out; ///< of each stress
    std::vector<SurrogateMiss>
        miss; ///< of each answer, on walls never used; empty: not checked
    std::vector<SurrogateMiss> first_miss; ///< before they were added; empty: that was enough
};

/// Told of what is going on, with the share that is done.
using CalibrationSeen = std::function<void(double done, const std::string& what)>;

/// The answer depends on study, walls and tests alone, not on the number of threads.
/// @param data its answers get the walls that are added
/// @throws ConfigError, Interrupted
[[nodiscard]] CalibrationRun run_calibration(const PreparedStudy& ready,
                                             const CalibratedInputs& inputs,
                                             CalibrationData& data, int threads,
                                             const CalibrationSeen& seen);

/// The one of both that the study asks for.
[[nodiscard]] const Taught& answer_of(const CalibrationInput& calibration,
                                      const CalibrationRun& run);

/// Median and interval of kTableShare of draws.
struct DrawsSummary {
    double median = 0.0;
    core::Interval interval;
};
[[nodiscard]] DrawsSummary summary_of(std::vector<double> draws);

} // namespace app
