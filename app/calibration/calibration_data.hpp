#pragma once
/// Tests and walls of a study as the data of a calibration.

#include "app/calibration/calibrated_inputs.hpp"
#include "app/calibration/calibration_surrogate.hpp"
#include "app/calibration/measured_tests.hpp"
#include "app/calibration/tested_quantity.hpp"
#include "app/study/stored/study_walls.hpp"
#include "uq/inference/calibration.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace app {

struct StudyFile;

/// A quantity under a stress.
struct CalibratedAnswer {
    std::size_t kind = 0;  ///< in CalibrationData::quantities
    std::size_t level = 0; ///< of the study
    double stress = 0.0;   ///< [Pa]
    AnswerPoints points{};
};

/// A value of a test that is used.
struct UsedTest {
    std::size_t test = 0;   ///< in the list of tests
    std::size_t answer = 0; ///< in CalibrationData::answers
    double value = 0.0;     ///< shown value
    bool at_least = false;
    double error = 0.0; ///< relative
};

struct CalibrationData {
    std::vector<TestedQuantity> quantities; ///< that were measured
    std::vector<CalibratedAnswer> answers;
    std::vector<UsedTest> tests;
    std::vector<std::string> remarks; ///< walls and values that are left out: sentences
};

/// Walls that outlast their push, as a share of those of a level, up to which they count with
/// the displacement at its end (choice). With more of them the tests of the drop are left out.
constexpr double kMostOutlasting = 0.1;

/// @throws ConfigError where a stress has too few walls with an answer, where no test is left,
/// or where no answer varies from wall to wall
/// @param walls with their curves (Keep::everything)
/// @param quantities that the table of the tests may have
[[nodiscard]] CalibrationData calibration_data(const StudyFile& source,
                                               const CalibratedInputs& inputs,
                                               const StudyWalls& walls,
                                               const std::vector<TestedQuantity>& quantities,
                                               const std::vector<MeasuredTest>& tests);

} // namespace app
