#pragma once

namespace dem {

/// Walls that one thread of the solver moves at once: those that a register of it holds
/// (contact/pack.hpp). What includes pack.hpp itself sees its own registers, which may be
/// others than the solver's.
[[nodiscard]] int solver_lanes();

} // namespace dem
