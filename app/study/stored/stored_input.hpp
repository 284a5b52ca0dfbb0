#pragma once
/// Random inputs of a stored study, in the units that people read.

#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"
#include "uq/marginals/marginal.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace app {

struct StoredInput {
    std::string key;                  ///< "joint.friction_angle"
    std::string unit;                 ///< shown: "deg", "MPa", "-", ...
    double scale = 1.0;               ///< shown value = scale x stored value
    std::size_t first = 0, count = 1; ///< columns of WallRow::inputs; count > 1: per joint ID
    std::optional<uq::Marginal> marginal; ///< as prescribed, in SI; nothing: not known
};

/// Columns "key", or "key.1", "key.2", ... side by side, as one input.
[[nodiscard]] std::vector<StoredInput> stored_inputs(const std::vector<Column>& columns);

/// Value of the input as it is shown; the mean where there is one value per joint.
[[nodiscard]] double shown_value(const StoredInput& input, const WallRow& wall);

} // namespace app
