#pragma once

namespace fragility {

/// Outcome of a regression on counts. Anything but `converged` comes with a reason and no
/// numbers.
enum class ModelOutcome {
    converged,
    no_data,
    invalid_value, ///< NaN, negative counts, sizes that do not match
    no_contrast,   ///< all walls in one category, or all at one value of the covariate
    absent_mode,   ///< a category that never occurs: its coefficients run away
    collinear,     ///< a covariate is a combination of the others (or constant)
    separated,   ///< covariates tell the categories apart without error: coefficients run away
    wrong_slope, ///< exceedance falls with intensity: no fragility curve
    not_converged
};

} // namespace fragility
