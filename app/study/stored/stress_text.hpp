#pragma once
/// A vertical stress for people.

#include <string>

namespace app {

/// "0.75 MPa"; two decimals where they are exact. @param stress [Pa]
[[nodiscard]] std::string stress_text(double stress);

} // namespace app
