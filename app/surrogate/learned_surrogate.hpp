#pragma once
/// A surrogate that was kept in a file: walls that were never run.

#include "fragility/modes/mode_model.hpp"
#include "uq/marginals/marginal.hpp"
#include "uq/surrogates/gaussian_process.hpp"
#include "uq/surrogates/polynomial_chaos.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct LearnedInput {
    std::string key, unit;   ///< unit in which people read it
    double scale = 1.0;      ///< shown value / value in SI
    uq::Marginal marginal{}; ///< in SI
    uq::PolynomialFamily family = uq::PolynomialFamily::hermite; ///< of its coordinate
};

/// Failure modes of one stress.
struct LearnedModes {
    std::vector<std::string> names; ///< "rocking"
    fragility::ModeModel model;     ///< in the coordinates
    std::vector<std::string> doubts;
};

/// The better surrogate of one stress.
struct LearnedLevel {
    double stress = 0.0;             ///< [Pa]
    std::vector<std::string> doubts; ///< why it is not to be trusted; empty: it is
    Eigen::VectorXd least, most;     ///< of each input on the walls learned from, in SI
    std::optional<uq::PolynomialChaos> chaos;
    std::optional<uq::GaussianProcess> process; ///< one of both, or none
    double rmse = 0.0;                 ///< of walls left out, shown unit of the response
    double inflation = 1.0;            ///< of the variance of the process, uq::inflation_of()
    std::optional<LearnedModes> modes; ///< nothing: the walls gave no model of them
};

struct LearnedSurrogate {
    std::string path, study;
    std::string study_sum;      ///< check sum of the configuration of the study
    std::string response, unit; ///< "peak_force", "kN"
    double scale = 1.0;         ///< of the response: shown value / value in SI
    std::vector<LearnedInput> inputs;
    std::vector<LearnedLevel> levels;
};

/// @param path of the surrogate.json that `drystone surrogate` wrote
/// @throws ConfigError if there is no such file, or it is damaged or another one
[[nodiscard]] LearnedSurrogate read_surrogate(const std::string& path);

/// Whether a file is meant as one: its name ends so.
[[nodiscard]] bool is_surrogate_file(std::string_view path);

/// Coordinates in which a surrogate sees its inputs. @param x in SI, walls x inputs
/// @throws BadValue where a value is not finite or the number of columns is another one
[[nodiscard]] Eigen::MatrixXd surrogate_coordinates(const LearnedSurrogate& s,
                                                    const Eigen::MatrixXd& x);

/// Walls that were never run; the response in SI.
struct SurrogateAnswers {
    Eigen::VectorXd mean;
    /// Doubt of one wall. Process: with its noise, times the root of the inflation. Chaos: its
    /// error on walls left out, wherever the wall lies.
    Eigen::VectorXd sd;
    Eigen::VectorXi outside; ///< number of inputs beyond those of the walls learned from
};

/// @param x in SI, walls x inputs
/// @throws BadValue as surrogate_coordinates, std::runtime_error if the level has no surrogate
[[nodiscard]] SurrogateAnswers predict(const LearnedSurrogate& s, const LearnedLevel& level,
                                       const Eigen::MatrixXd& x);

/// Probabilities of the modes, walls x modes in the order of LearnedModes::names.
struct ModeAnswers {
    Eigen::MatrixXd probability;
    Eigen::MatrixXd sd; ///< standard errors
};

/// @param x in SI, walls x inputs
/// @throws BadValue as surrogate_coordinates, std::runtime_error if the level has no modes
[[nodiscard]] ModeAnswers predict_modes(const LearnedSurrogate& s, const LearnedLevel& level,
                                        const Eigen::MatrixXd& x);

} // namespace app
