#pragma once
/// Tables of limit drifts: performance limits, how well the laws fit, the model over all
/// stresses, and the parameters for pelicun.

#include "app/fragility/numbers/fragility_data.hpp"
#include "app/output/table/table.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace app {

/// 5, 16, 50, 84, 95 % drifts per group and limit state, as limit_drifts chooses them; without
/// a fit a bound of the median and a note.
[[nodiscard]] Table performance_table(const DriftData& data);

/// The names of all limit states of the row of this one; nothing where an earlier row has it.
[[nodiscard]] std::string names_of_row(const DriftData& data, std::size_t state);

/// Rows of that table with the severest limit state of each set.
[[nodiscard]] std::vector<std::size_t> severest_rows(const DriftData& data,
                                                     const Table& limits);

/// The own parameters of four laws with standard errors (ln median and dispersion, mean and
/// standard deviation, shape and scale), and their AIC.
[[nodiscard]] Table law_table(const DriftData& data);

/// Kolmogorov-Smirnov, Cramer-von Mises and Anderson-Darling distances of the law chosen, with
/// p-values.
[[nodiscard]] Table fit_table(const DriftData& data);

/// Median and dispersion of lognormal limit drifts as functions of the vertical stress, at the
/// levels and half-way between them; a note where the tests reject the law at one of them.
/// Without stresses: no rows.
[[nodiscard]] Table stress_table(const DriftData& data);

/// One component per group, one limit state column group per limit state of one set, in the
/// order of their medians (of the set, where one is missing): ID, Incomplete, Demand-Type,
/// Demand-Unit, Demand-Offset, Demand-Directional, LS1-Family, LS1-Theta_0 (median [rad]) and
/// LS1-Theta_1 (total dispersion; without a factor of the model that from wall to wall), both
/// as drift_doubt_table has them, LS1-DamageStateWeights, ... Incomplete = 1 where walls
/// without modes or heaps have no lognormal law that describes them, where 84 % of the walls
/// reach a limit state beyond the drift tested (its parameters are empty then), or where drifts
/// have no known unit. No two rows have one ID.
/// Notes (pelicun passes them over): the group, the drift up to which walls were tested, and
/// the parts of the dispersion.
[[nodiscard]] std::string pelicun_csv(const DriftData& data);

/// Limit states that one component can have, and the head of the file.
inline constexpr std::size_t kPelicunStates = 4;
[[nodiscard]] std::string pelicun_head();

} // namespace app
