#pragma once
/// Inputs of a study that tests shall teach, in coordinates with independent standard normal
/// priors.

#include "uq/marginals/marginal.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace app {

struct CalibrationInput;
struct Sampling;
struct Study;
struct StudyFile;

struct CalibratedInput {
    std::string key, unit;   ///< unit in which people read it: "deg"; empty: none
    double scale = 1.0;      ///< shown value / value in SI
    std::size_t place = 0;   ///< in Study::random
    uq::Marginal marginal{}; ///< in SI
};

struct CalibratedInputs {
    std::vector<CalibratedInput> inputs;
    Eigen::MatrixXd factor; ///< lower; times its transpose it is the correlation of the normal
                            ///< images
    bool all = false;       ///< the study has no other random input
};

/// The distributions that calibration.inputs names.
/// @throws ConfigError where it names something else, an input that varies inside a wall or is
/// correlated with one that is not named, or where the study has too few walls to learn so many
[[nodiscard]] CalibratedInputs calibrated_inputs(const CalibrationInput& calibration,
                                                 const Sampling& sampling,
                                                 const StudyFile& source);

/// Walls of each stress from which so many inputs can be learned: 5 for each, and at least 10
/// (choice).
[[nodiscard]] int fewest_walls(std::size_t inputs);

/// @param values in SI, in the order of the inputs
[[nodiscard]] Eigen::VectorXd to_coordinates(const CalibratedInputs& inputs,
                                             const Eigen::VectorXd& values);
/// And back.
[[nodiscard]] Eigen::VectorXd to_values(const CalibratedInputs& inputs,
                                        const Eigen::VectorXd& coordinates);

} // namespace app
