#pragma once
/// The choices that the paper leaves open in its contact laws (contact_law.hpp).

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

} // namespace dem
