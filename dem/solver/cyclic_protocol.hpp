#pragma once
/// Protocols of pushes to and fro, as lists of displacements to visit: PushPlan::targets.

#include <vector>

namespace dem {

enum class Protocol {
    none, ///< no stages
    fema461, ///< FEMA 461 (2007), 2.9.1: ten amplitudes, each 1.4 times the one before, two cycles each
    iso16670, ///< ISO 16670 (2003), 6.3 (ASTM E2126, method B): 1.25 to 10 % once, 20 to 100 % three times
};

/// An amplitude and how many cycles it has.
struct CyclicStage {
    double amplitude = 0.0; ///< [m], > 0
    int cycles = 1;
};

/// The stages of a protocol; none of Protocol::none.
/// @param largest amplitude of the last stage [m], > 0; ISO's ultimate displacement. ISO's last
/// stage of 120 % is left
/// out: it is for tests that have not failed.
[[nodiscard]] std::vector<CyclicStage> stages_of(Protocol protocol, double largest);

/// The displacements that a push visits in order [m]: to the right, to the left, and so on, and
/// zero at the end. Empty without stages.
[[nodiscard]] std::vector<double> cyclic_targets(const std::vector<CyclicStage>& stages);

} // namespace dem
