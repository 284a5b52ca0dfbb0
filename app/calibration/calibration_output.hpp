#pragma once
/// Files and words of a calibration of inputs.

#include "app/calibration/calibration_run.hpp"
#include "app/output/table/table.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Everything that the verb writes is made of this.
struct CalibrationReport {
    const Study* study;
    const CalibratedInputs* inputs;
    const std::vector<MeasuredTest>* tests;
    const CalibrationData* data;
    const CalibrationRun* run;
};

/// An input before and after the tests, in its shown unit.
struct InputChange {
    DrawsSummary prior, with, without; ///< discrepancy
    DrawsSummary asked;                ///< the one of both that the study asks for
    /// Normal score of the median of that one: standard deviations of the prior.
    double moved = 0.0;
    double width_left = 1.0; ///< its interval over that of the prior [-]
};
[[nodiscard]] InputChange input_change(const CalibrationReport& r, std::size_t input);

/// "joint.friction_angle [deg]"
[[nodiscard]] std::string with_unit(std::string_view name, std::string_view unit);

/// Rows by input: prior and posterior, median and interval, and how much narrower it became.
[[nodiscard]] Table teaching_table(const CalibrationReport& r);

/// Rows by quantity and stress: one further wall, by the prior, with all tests, without the
/// discrepancy, and by the tests under all other stresses.
[[nodiscard]] Table further_wall_table(const CalibrationReport& r);

/// Rows by test: measured, and what is predicted of it without the tests of its stress.
[[nodiscard]] Table test_table(const CalibrationReport& r);

/// Rows by quantity: discrepancy and scatter of repeats, and the error of the surrogates.
[[nodiscard]] Table scatter_table(const CalibrationReport& r);

/// ln of the evidence with and without a discrepancy.
[[nodiscard]] Table evidence_table(const CalibrationReport& report);

/// The points of the posterior: inputs in their units, discrepancy and scatter.
[[nodiscard]] Table posterior_table(const CalibrationReport& r);

/// Densities of all inputs, in standard deviations of their priors.
[[nodiscard]] std::string density_picture(const CalibrationReport& r);

/// Tests and further walls over the stress.
/// @param kind in CalibrationData::quantities
[[nodiscard]] std::string further_wall_picture(const CalibrationReport& r, std::size_t kind);

/// The answer in sentences: which inputs the tests teach.
[[nodiscard]] std::string answer_text(const CalibrationReport& r);

/// Convergence, evidence, checks and what is left out, in sentences.
[[nodiscard]] std::string doubt_text(const CalibrationReport& r);

/// A study file whose calibrated inputs have the posterior's draws, row by row, and whose
/// factors of the model are those of a stress that was not tested.
/// @param source of the tests, for its comment
[[nodiscard]] std::string posterior_study(const CalibrationReport& r,
                                          const std::string& source);

} // namespace app
