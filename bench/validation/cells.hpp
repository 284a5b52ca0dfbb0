#pragma once
/// Cells of the tables: a mean or a share with its interval of 95 %.

#include "app/output/table/table.hpp"
#include "bench/validation/level_statistics.hpp"

namespace bench {

/// Half the width of a 95 % interval over the standard deviation of a normal law.
constexpr double kZ = 1.959963984540054;

/// "15.1 [14.4, 15.9]"; one wall has no interval, no wall nothing.
[[nodiscard]] app::Cell with_interval(const Sample& s, int decimals);

/// "32 [28, 36]": k of n [%], Wilson's interval.
[[nodiscard]] app::Cell share_cell(std::size_t k, std::size_t n);

} // namespace bench
