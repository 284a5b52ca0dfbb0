#pragma once
/// Ranges of the values of keys, those that several keys or a list in a value share.

namespace app {

/// Closed '[' ']' or open '(' ')' at either end, in the unit of the key.
struct Range {
    char left = '(';
    double low = 0.0;
    double high = 0.0;
    char right = ')';
};

// The ends of the ranges are beyond any wall: they catch a wrong power of ten.
inline constexpr Range kHeight{'[', 0.001, 10, ']'};   // [m]
inline constexpr Range kModulus{'(', 0, 1000, ']'};    // [GPa]
inline constexpr Range kPoisson{'[', 0, 0.5, ')'};     // [-]
inline constexpr Range kDensity{'[', 0, 20000, ']'};   // [kg/m3]
inline constexpr Range kAngle{'[', 0, 90, ')'};        // [deg]
inline constexpr Range kStrength{'[', 0, 1000, ']'};   // [MPa]
inline constexpr Range kFactor{'(', 0, 1000, ']'};     // [-]
inline constexpr Range kShearEnergy{'(', 0, 1e6, ']'}; // [N/m]

} // namespace app
