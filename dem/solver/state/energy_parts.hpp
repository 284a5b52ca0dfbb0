#pragma once
/// The energies of a wall by name, for whoever lists them.

#include "dem/solver/state/energy.hpp"

#include <array>
#include <string_view>

namespace dem {

struct EnergyPart {
    std::string_view name;
    double Energy::*value; ///< [J]
};

inline constexpr std::array kEnergyParts = {
    EnergyPart{"work", &Energy::work},         EnergyPart{"elastic", &Energy::elastic},
    EnergyPart{"friction", &Energy::friction}, EnergyPart{"fracture", &Energy::fracture},
    EnergyPart{"crushing", &Energy::crushing}, EnergyPart{"damping", &Energy::damping},
    EnergyPart{"kinetic", &Energy::kinetic},   EnergyPart{"lifted", &Energy::lifted}};

} // namespace dem
