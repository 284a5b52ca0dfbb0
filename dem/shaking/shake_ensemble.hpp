#pragma once
/// Shakes many walls of one model, one in each lane of a register, in several threads.
///
/// Lanes, threads and their rules are those of dem/solver/ensemble.hpp: histories differ in
/// their walls, records, intensities and time steps, each has a clock of its own, and a history
/// has the same bits whatever its lane, its neighbours, the width of the registers and the
/// number of threads. shake() gives these bits as well.

#include "dem/shaking/shake.hpp"
#include "dem/solver/ensemble.hpp"

#include <cstddef>
#include <functional>
#include <optional>

namespace dem {

struct HistoryInput {
    WallMaterials materials;
    ShakePlan plan;
};

struct ShakenEnsemble {
    std::size_t size = 0; ///< number of histories
    bool damps = false;   ///< whether they have contact damping: all of them or none
    /// Makes a history, 0 <= number < size; called from any thread when it is about to run. If
    /// it returns nothing, the history is passed over, and `done` is not called for it.
    std::function<std::optional<HistoryInput>(std::size_t number)> history;
    /// Takes each result as soon as it is there, one at a time, in no particular order.
    std::function<void(std::size_t number, ShakeResult&&)> done;
};

/// @throws std::invalid_argument as shake() does or where contact damping is not as `damps`
/// says, and whatever `history`, `done` or the progress of a plan throw. Histories that are
/// running are then abandoned.
void shake_ensemble(const Model& model, const ShakenEnsemble& ensemble,
                    const SolverOptions& options = {}, const Workers& workers = {});

} // namespace dem
