#pragma once
/// The ways to place samples in the unit cube.

namespace uq {

enum class DesignKind {
    monte_carlo,     ///< independent rows
    latin_random,    ///< each stratum of each variable holds one row, at a random place
    latin_centred,   ///< each stratum of each variable holds one row, in its middle
    latin_optimised, ///< as latin_random, with the strata arranged so that no two rows are close
    sobol            ///< scrambled, see uq/designs/sobol.hpp
};

[[nodiscard]] bool is_latin(DesignKind kind);

} // namespace uq
