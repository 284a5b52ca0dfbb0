#pragma once
/// The choices that the paper leaves open in its contact laws (contact_law.hpp), and those
/// beside them.

namespace dem {

enum class ContactLaw {
    coupled,  ///< damage in tension and damage in shear weaken each other (Table 2)
    uncoupled ///< each weakens its own strength only (Fig. 7)
};

/// How a crack that has opened closes again.
enum class Unloading {
    secant, ///< straight to the origin, so that it is closed at u_n = 0
    elastic ///< with k_n, by the increments of Table 1, so that it stays propped open
};

/// How the stiffness of dry joints grows with the pressure p on them (closure.hpp).
enum class Closure {
    linear,     ///< it does not
    hyperbolic, ///< p = k_0 w / (1 - w / V_m) of the closure w (Bandis, Lumsden and Barton 1983)
    exponential ///< p = k_0 V_m (exp(w / V_m) - 1)
};

/// The shear strength of a crack in tension.
enum class Envelope {
    coulomb,   ///< c - sigma tan(phi)
    hyperbolic ///< a smooth curve from (0, c) to (f_t, 0) (mixed_crack.hpp)
};

} // namespace dem
