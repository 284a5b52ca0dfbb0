#pragma once
/// How finely a wall is resolved: contact points, zones and modes of its blocks. docs/convergence.md
/// shows the effect.

namespace dem {

enum class FaceRule {
    even,   ///< evenly spaced points, trapezoid areas
    lobatto ///< Gauss-Lobatto points and areas
};

struct Discretisation {
    int contact_points = 5; ///< per face of a half unit, >= 2
    FaceRule face_rule = FaceRule::lobatto;
    int zones_per_interval = 2; ///< block zones between two neighbouring contact points, >= 1
    int block_modes = 12;       ///< per block: 3 rigid, 6 simply deformable, ...; 0 all
    int beam_modes = 15;        ///< of the loading beam; 0 all
    friend bool operator==(const Discretisation&, const Discretisation&) = default;
};

/// Rungs from cheap to exact; error and cost of each: docs/bench/paper_walls.md.
enum class Fidelity {
    rigid,    ///< rigid blocks
    simple,   ///< rigid motion and constant strain
    standard, ///< the default: six modes more
    zones,    ///< all modes: the zones in full
    fine      ///< and more contact points: the reference of ensembles
};

[[nodiscard]] constexpr Discretisation discretisation_of(Fidelity f)
{
    Discretisation d;
    if (f == Fidelity::rigid) d.block_modes = 3;
    if (f == Fidelity::simple) d.block_modes = 6;
    if (f == Fidelity::zones || f == Fidelity::fine) d.block_modes = 0;
    if (f == Fidelity::fine) d.contact_points = 6;
    return d;
}

} // namespace dem
