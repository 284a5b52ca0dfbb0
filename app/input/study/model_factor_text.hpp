#pragma once
/// The error of the model as [fragility] gives it: a factor on limit drifts and one on forces.

#include "fragility/limits/model_factor.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace app {

struct FragilityInput;
struct StudyFile;

/// A factor that a study gives: none, that of the tests, or its own.
struct FactorChoice {
    bool tests = false;                          ///< that of the tests
    std::optional<fragility::ModelFactor> given; ///< else none
};

/// "none", "tests", "lognormal(median 0.8, sigma_log 0.4)" or "lognormal(mean 0.87, cov 0.42)".
/// The dispersion that is given holds the doubt of the median.
/// @throws BadValue; for a median not in [0.05, 20] or a dispersion above 3, which were meant
/// in another unit
[[nodiscard]] FactorChoice parse_model_factor(std::string_view text);

/// Such a text of a factor, its median and dispersion with three digits.
[[nodiscard]] std::string model_factor_text(const fragility::ModelFactor& factor);

/// @throws ConfigError at fragility.model_factor or fragility.model_factor_force
void check_model_factors(const FragilityInput& fragility, const StudyFile& source);

} // namespace app
