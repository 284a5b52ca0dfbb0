#pragma once
/// Gauss-Legendre rules on [-1, 1] (Abramowitz and Stegun, table 25.4), as constants: to work
/// them out at compile time takes a header of 100 000 lines.

#include <array>
#include <cstddef>

namespace fragility {

/// The positive half of an even number of nodes, ascending; the other half mirrors it. The rule
/// is exact for polynomials of a degree below four times as many as stand here.
template <std::size_t Half> struct GaussRule {
    std::array<double, Half> node;   ///< in (0, 1)
    std::array<double, Half> weight; ///< > 0; they sum to 1
};

inline constexpr GaussRule<8> kGauss16{
    {0.095012509837637441, 0.28160355077925892, 0.45801677765722737, 0.61787624440264377,
     0.755404408355003, 0.86563120238783176, 0.9445750230732326, 0.98940093499164994},
    {0.18945061045506847, 0.18260341504492361, 0.16915651939500254, 0.14959598881657671,
     0.12462897125553386, 0.095158511682492786, 0.062253523938647873, 0.027152459411754121}};

} // namespace fragility
