#pragma once
/// Bayesian calibration of a model against tests, with a discrepancy and a scatter of repeats
/// (Kennedy and O'Hagan 2001; a discrepancy of its own for each answer):
///
///   y_ij = m_i(z) + d_i + e_ij,   d_i ~ N(0, tau_q^2 + v_i(z)),   e_ij ~ N(0, s_q^2 + w_i +
///   error_ij^2)
///
/// y_ij is what test j says of answer i, m_i what the model says at the inputs z, v_i the doubt
/// of a surrogate in place of the model, w_i a scatter of walls that the model itself shows.
/// Answers of one quantity q share tau_q and s_q. z has independent standard normal priors, tau
/// and s half-t ones with four degrees of freedom (Gelman 2006, Bayesian Analysis 1, 515-534).

#include "uq/inference/adaptive_metropolis.hpp"
#include "uq/inference/chain_diagnostics.hpp"
#include "uq/inference/evidence.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace uq {

/// All answers of the model at one point.
struct ModelAnswers {
    Eigen::VectorXd mean;
    Eigen::VectorXd variance; ///< v, >= 0
};
/// Asked from several threads at a time where several calibrations run.
using AnswerModel = std::function<ModelAnswers(const Eigen::VectorXd& z)>;

struct MeasuredAnswer {
    std::size_t answer;    ///< which of the model's, from 0
    double value;          ///< y, such as the ln of a force
    bool at_least = false; ///< right-censored: y is larger
    double error = 0.0;    ///< known standard deviation of the measurement, >= 0
};

struct CalibrationProblem {
    Eigen::Index inputs = 0;           ///< length of z, >= 1
    std::vector<std::size_t> quantity; ///< of each answer, from 0 without gaps
    AnswerModel model;
    std::vector<MeasuredAnswer> tests;
    Eigen::VectorXd own;       ///< w of each answer, >= 0; empty: 0
    bool discrepancy = true;   ///< false: tau is 0
    double prior_scale = 0.25; ///< of the half-t priors of tau and s, which is their mean, > 0
};

/// @throws std::invalid_argument naming what is out of range
void check(const CalibrationProblem& problem);

/// One point of the posterior.
struct CalibrationPoint {
    Eigen::VectorXd z;
    Eigen::VectorXd tau, s; ///< of each quantity
};

/// A chain walks over z and one coordinate for each tau and each s, all of which have standard
/// normal priors.
[[nodiscard]] CalibrationPoint calibration_point(const CalibrationProblem& problem,
                                                 const Eigen::VectorXd& coordinates);

/// ln of the density of the tests at a point, with all its constants. Discrepancies are
/// integrated out.
[[nodiscard]] double log_likelihood(const CalibrationProblem& problem,
                                    const CalibrationPoint& point);

struct CalibrationOptions {
    MetropolisOptions metropolis{.warm_up = 4000, .draws = 8000};
    int longer = 2; ///< times that the chains are made four times as long, until they agree
    bool evidence = true; ///< false: it is 0
};

constexpr double kConvergedRHat = 1.01, kConvergedSize = 400.0; // Vehtari et al. 2021

struct CalibrationPosterior {
    std::vector<Chain> chains; ///< over coordinates
    double r_hat = 0.0;        ///< the worst of all coordinates
    double effective = 0.0;    ///< the smallest of all coordinates
    Evidence evidence{};
};

/// Whether R-hat is at most kConvergedRHat and the effective size at least kConvergedSize.
[[nodiscard]] bool has_converged(const CalibrationPosterior& posterior);

/// The answer depends on problem and options alone.
/// @throws std::invalid_argument as check, or if the density is zero wherever chains may start
[[nodiscard]] CalibrationPosterior calibrate(const CalibrationProblem& problem,
                                             const CalibrationOptions& options = {});

/// `n` points of the posterior, evenly over all chains.
/// @param n >= 1
[[nodiscard]] std::vector<CalibrationPoint>
calibration_points(const CalibrationProblem& problem, const CalibrationPosterior& posterior,
                   std::size_t n);

/// Further tests, a row for each point and a column for each answer: the model with its
/// discrepancy, which the tests of the same answer have shown in part, and a repeat. Row k has
/// random numbers of its own, a function of seed and k.
[[nodiscard]] Eigen::MatrixXd further_tests(const CalibrationProblem& problem,
                                            const std::vector<CalibrationPoint>& points,
                                            std::uint64_t seed);

} // namespace uq
