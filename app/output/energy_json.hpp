#pragma once
/// The energies of a wall in its summary.

#include "app/text/json_text.hpp"
#include "dem/solver/state/energy_parts.hpp"

#include <string>

namespace app {

/// "work_J", "elastic_J", ...; NaN is null.
[[nodiscard]] inline Json energy_json(const dem::Energy& e)
{
    Json all;
    for (const dem::EnergyPart& part : dem::kEnergyParts)
        all[std::string(part.name) + "_J"] = or_null(e.*part.value);
    return all;
}

} // namespace app
