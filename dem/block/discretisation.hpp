#pragma once
/// How finely a wall is resolved: contact points, zones and modes of its blocks.
/// docs/bench/accuracy/convergence.md shows the effect.

namespace dem {

enum class FaceRule {
    even,   ///< evenly spaced points, trapezoid areas
    lobatto ///< Gauss-Lobatto points and areas
};

struct Discretisation {
    int contact_points = 5; ///< per face of a half unit, >= 2
    FaceRule face_rule = FaceRule::lobatto;
    int zones_per_interval = 2; ///< block zones between two neighbouring contact points, >= 1
    int block_modes = 12;       ///< per block: 3 is rigid, 6 adds constant strains; 0 keeps all
    int beam_modes = 15;        ///< of the loading beam; 0 keeps all
    friend bool operator==(const Discretisation&, const Discretisation&) = default;
};

/// A ladder from cheap to exact. docs/bench/accuracy/paper_walls.md gives the error and cost of
/// each rung.
enum class Fidelity {
    rigid,    ///< rigid blocks
    simple,   ///< rigid motion and constant strain
    standard, ///< six modes more, in long blocks those of bending among them; the default
    zones,    ///< all modes, that is the zones in full
    fine      ///< more contact points as well: the reference for ensembles
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
