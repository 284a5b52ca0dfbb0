#pragma once
/// The choices that the paper leaves open in its contact laws (contact_law.hpp).

namespace dem {

enum class ContactLaw {
    coupled,  ///< Table 2
    uncoupled ///< tension and shear damage apart (Fig. 7)
};

/// A crack that opened and closes again.
enum class Unloading {
    secant, ///< to the origin: closed at u_n = 0
    elastic ///< with k_n, by the increments of Table 1: propped at what did not spring back
};

} // namespace dem
