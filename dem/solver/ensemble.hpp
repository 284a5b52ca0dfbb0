#pragma once
/// Pushes many walls of one model, as fast as the machine allows.
///
/// Lanes. A processor register holds several doubles: 2, 4 or 8 with SSE2, AVX2 or AVX-512
/// (pack.hpp). Each of its places is a lane. The solver is written over Real = Pack, so that
/// one step advances one wall in every lane: lane 2 of every position, velocity and stress
/// belongs to the same wall. All lanes do the same arithmetic with different numbers. This
/// works because the walls of a model share their blocks, contacts and modes, and differ in
/// their materials and loads only. Nothing is gathered or scattered between walls, and no wall
/// waits for another within a step.
///
/// Walls. A batch (batch.hpp) is one register of walls with one array per quantity (WallState).
/// Model and StepTables keep once all that the walls share. A WallRun stands beside each
/// lane: it is the bookkeeping of one push (its drive, its curve, its verdict) and touches its
/// own lane only. As soon as a wall is done, its result is handed out and the next wall of the
/// ensemble takes the lane, so that the lanes stay full until the ensemble runs out of walls. A
/// lane without a wall is at rest and costs what the others cost. Where there are fewer walls
/// than lanes, each thread takes fewer lanes, so that the other threads have work as well.
///
/// Threads. Each thread has a batch of its own and takes the number of its next wall from a
/// common counter; `Ensemble::wall` makes the materials of that wall in the thread that will
/// push it. Batches share nothing else. Results are handed over one at a time under a lock, in
/// the order in which walls finish. An exception in any thread stops the ensemble: every thread
/// leaves its walls at the next result, and the first exception is thrown to the caller.
///
///   thread 0   lane 0   wall 0 -----> wall 6 --------> wall 9 ...
///              lane 1   wall 1 -> wall 4 -----------> wall 8 ...
///   thread 1   lane 0   wall 2 ---> wall 5 ---------------------> ...
///              lane 1   wall 3 ---------> wall 7 -------> wall 10 ...
///
/// Clocks. Every wall has a clock of its own (Drive): vertical load first, until the wall is at
/// rest, then the push. One step of the batch is one step of every clock, but the steps mean
/// different things: while one wall settles its neighbour may be at 12 mm, and each drive slows
/// down for its own wall when that one is out of balance. The time step is 1 for all walls; a
/// wall that needs a smaller step gets larger fictitious masses instead and starts again
/// (WallRun::reduce_step). There is no other coupling between lanes.
///
/// Same bits. Each lane does exactly what plain doubles would do, in the same order; fused
/// multiply-adds are written out (pack.hpp). A wall therefore has the same bits whatever its
/// lane, its neighbours, the width of the registers and the number of threads, and push() gives
/// these bits as well.

#include "dem/solver/push.hpp"

#include <cstddef>
#include <functional>
#include <optional>

namespace dem {

struct Ensemble {
    std::size_t size = 0; ///< number of walls
    /// Makes the materials of a wall, 0 <= number < size. It is called from any thread when the
    /// wall is about to run, so that an ensemble of any size needs no more memory than the
    /// walls that are running. If it returns nothing, the wall is passed over, and `done` is
    /// not called for it.
    std::function<std::optional<WallMaterials>(std::size_t number)> wall;
    /// Takes each result as soon as it is there, one at a time, in no particular order.
    std::function<void(std::size_t number, PushResult&&)> done;
    /// Walls may come while others run: if `wall` returns nothing, the lane asks again a little
    /// later. The ensemble ends when no wall runs.
    bool open = false;
};

struct Workers {
    int threads = 0;     ///< 0 takes one per core
    bool scalar = false; ///< one wall at a time per thread; the same bits, for comparison
};

/// @throws std::invalid_argument as check() does, and whatever `wall` or `done` throw. Walls
/// that are
/// being pushed are then abandoned.
void push_ensemble(const Model& model, const Ensemble& ensemble, const PushPlan& plan,
                   const SolverOptions& options = {}, const Workers& workers = {});

} // namespace dem
