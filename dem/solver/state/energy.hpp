#pragma once
/// The energy balance of a wall: work = kinetic + elastic + friction + fracture +
/// crushing + damping.

namespace dem {

/// All in joules, from the unloaded state.
struct Energy {
    double work = 0.0;     ///< by the drive, the vertical load and self-weight
    double kinetic = 0.0;  ///< of the fictitious masses
    double elastic = 0.0;  ///< blocks and contacts
    double friction = 0.0; ///< slip under friction, and joints that close with a loss
    double fracture = 0.0; ///< tension softening, and cohesion lost in shear
    double crushing = 0.0; ///< of contacts under compression
    double damping = 0.0;
    /// Energy that the drive of the push has put into weight and vertical load, which rise as a
    /// wall rocks; negative where they have sunk, as those of a wall that crushes. It is in
    /// `work` already, with the opposite sign.
    double lifted = 0.0;
    /// The part of `friction` that joints lose as they close.
    double closing = 0.0;
    /// The part of the work of the drive that the wall has not lost: it can give it back.
    [[nodiscard]] double stored() const { return kinetic + elastic + lifted; }
    [[nodiscard]] double passed() const; ///< all energy that passed through the wall
    /// The part of the work that is not accounted for, as a share of passed() [-].
    [[nodiscard]] double residual() const;
};

} // namespace dem
