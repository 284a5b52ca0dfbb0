#pragma once
/// Where units may crack, as a study says it.

#include "app/input/study.hpp"

namespace app {

/// Reads `unit.cracks` and what belongs to it into Study::wall. The region `toe` is the lower 40 % of the half of the
/// wall that it is pushed towards; of both halves where it is pushed to and fro.
/// @throws ConfigError
void read_unit_cracks(Study& study);

/// Whether any unit may crack.
[[nodiscard]] bool has_cracks(const Study& study);

/// Whether units may crack in a pattern that a condition holds for.
template <class Holds> [[nodiscard]] bool any_pattern(const Study& study, Holds holds)
{
    const dem::UnitCracks& c = study.wall.cracks;
    return holds(c.pattern) || (c.where.has_value() && holds(c.elsewhere));
}

} // namespace app
