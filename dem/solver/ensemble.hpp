#pragma once
/// Many walls of one model, as fast as the machine allows: a register of walls per thread.

#include "dem/solver/push.hpp"

#include <cstddef>
#include <functional>
#include <optional>

namespace dem {

struct Ensemble {
    std::size_t size = 0; ///< number of walls
    /// Materials of a wall, 0 <= number < size. Called from any thread, when its turn comes, so
    /// that an ensemble of any size needs no more memory than what is running.
    /// Nothing: the wall is passed over, and `done` is not called for it.
    std::function<std::optional<WallMaterials>(std::size_t number)> wall;
    /// Takes each result when it is there, one at a time, in no order.
    std::function<void(std::size_t number, PushResult&&)> done;
};

struct Workers {
    int threads = 0;     ///< 0: one per core
    bool scalar = false; ///< one wall at a time per thread: same bits, for comparison
};

/// A wall has the same bits whatever its lane, its neighbours, the width of the registers and the
/// number of threads.
/// @throws std::invalid_argument as check(); whatever `wall` or `done` throw. Walls on their way are
/// then left.
void push_ensemble(const Model& model, const Ensemble& ensemble, const PushPlan& plan,
                   const SolverOptions& options = {}, const Workers& workers = {});

} // namespace dem
