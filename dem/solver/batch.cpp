#include "dem/solver/batch.hpp"

#include "dem/solver/thread_time.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace dem {

namespace {

/// A free lane asks for a wall again after so many steps, some milliseconds.
constexpr int kAskEvery = 64; // choice

/// Puts the next wall into a free lane, if there is one.
template <class Real>
std::optional<WallRun> start(const Task& task,
                             const std::function<std::optional<NumberedWall>()>& next, int lane,
                             WallState<Real>& state)
{
    std::optional<NumberedWall> wall = next();
    if (!wall) return {};
    WallRun run(task, wall->number, std::move(wall->materials));
    run.load(state, lane);
    return run;
}

} // namespace

template <class Real>
void run_batch(const Task& task, int most_lanes,
               const std::function<std::optional<NumberedWall>()>& next,
               const std::function<void(std::size_t number, PushResult&&)>& done)
{
    WallState<Real> state = empty_lanes<Real>(task.model, task.tables, task.options.kinematics);
    std::array<std::optional<WallRun>, lanes<Real>> runs;
    int running = 0;
    for (int i = 0; i < std::min(most_lanes, lanes<Real>); ++i) {
        runs[i] = start(task, next, i, state);
        running += runs[i].has_value();
    }
    double last = thread_seconds();
    const auto share_time = [&] {
        const double now = thread_seconds();
        const double each = (now - last) / running;
        for (auto& run : runs)
            if (run) run->spend(each);
        last = now;
    };
    const auto fill_free_lanes = [&] {
        for (int i = 0; i < std::min(most_lanes, lanes<Real>); ++i)
            if (!runs[i])
                if (std::optional<WallRun> run = start(task, next, i, state)) {
                    share_time();
                    runs[i] = std::move(run);
                    ++running;
                }
    };
    for (long long steps = 1; running > 0; ++steps) {
        StepInput<Real> in{Real(0.0), Real(0.0),
                           Real(0.0)}; // a lane without a wall stays at rest
        for (int i = 0; i < lanes<Real>; ++i)
            if (runs[i]) {
                const WallRun::Input one = runs[i]->next(dem::lane(state.top_force, i));
                set_lane(in.load_factor, i, one.load_factor);
                set_lane(in.drive, i, one.drive);
                set_lane(in.held, i, one.held);
            }
        step(task.tables, task.options, in, state);
        for (int i = 0; i < lanes<Real>; ++i) {
            if (!runs[i] || runs[i]->look(state, i)) continue;
            share_time();
            done(runs[i]->number(), runs[i]->finish(state, i));
            clear_lane(task.tables, i, state);
            runs[i] = start(task, next, i, state);
            running -= !runs[i].has_value();
        }
        if (steps % kAskEvery == 0 && running > 0 &&
            running < std::min(most_lanes, lanes<Real>))
            fill_free_lanes();
    }
}

template void run_batch<double>(const Task&, int,
                                const std::function<std::optional<NumberedWall>()>&,
                                const std::function<void(std::size_t, PushResult&&)>&);
template void run_batch<Pack>(const Task&, int,
                              const std::function<std::optional<NumberedWall>()>&,
                              const std::function<void(std::size_t, PushResult&&)>&);

} // namespace dem
