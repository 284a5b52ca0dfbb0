#pragma once
/// Records and walls crossed: each wall under each record. The scatter of ln capacity is split
/// into what records, walls and their interaction have, and the median gets an interval that
/// knows of all three.

#include "core/interval.hpp"

#include <Eigen/Dense>

namespace fragility {

/// y = mean + record + wall + interaction, all independent with mean 0 (random effects).
struct VarianceSplit {
    double mean = 0.0;                 ///< of all cells
    double records = 0.0, walls = 0.0; ///< variances, unbiased, thus below 0 now and then
    double interaction = 0.0;          ///< with what is left
    double total = 0.0;                ///< their sum
    double mean_error = 0.0;           ///< standard error of the mean
    double freedom = 0.0;              ///< of that error (Satterthwaite 1946)
};

/// @param y a row for each record, a column for each wall, two of each or more; finite
/// @throws std::invalid_argument
[[nodiscard]] VarianceSplit variance_split(const Eigen::MatrixXd& y);

/// Interval of the mean, with records and walls both as samples: a few walls under many records
/// tell little of all walls.
/// @param confidence in (0, 1)
[[nodiscard]] core::Interval mean_interval(const VarianceSplit& split,
                                           double confidence = 0.95);

} // namespace fragility
