/// Calibration from tests: keys of the study file.

#include "app/input/keys/study_key_table.hpp"

#include <array>

namespace app {
namespace {

constexpr Condition kCalibrated{
    asks<&Study::calibration>([](auto& c) { return !c.inputs.empty(); }),
    "there is no calibration.inputs; write it, or remove this key", true};

// clang-format off
constexpr std::array kCalibrationKeys = {
    Key{.name = "calibration.inputs", .kind = Kind::text, .verbs = "calibrate",
        .derived = {"none"},
        .meaning = "distributions of the study that tests shall teach, between commas, or all; none: a factor of the model alone",
        .field = kAt<&Study::calibration, &CalibrationInput::inputs>},
    Key{.name = "calibration.discrepancy", .kind = Kind::word, .names = kYesNo, .used = kCalibrated, .verbs = "calibrate",
        .meaning = "yes: the model may be wrong under each stress, and the posterior says so (Kennedy and O'Hagan 2001); no: tests scatter about the model",
        .field = kAt<&Study::calibration, &CalibrationInput::discrepancy>},
    Key{.name = "calibration.scatter", .range = {'(', 0, 3, ']'}, .used = kCalibrated, .verbs = "calibrate",
        .meaning = "scale of the half-t priors of discrepancy and scatter of repeats, of ln of what is measured",
        .field = kAt<&Study::calibration, &CalibrationInput::scatter>},
};
// clang-format on

} // namespace

std::span<const Key> calibration_keys() { return kCalibrationKeys; }

} // namespace app
