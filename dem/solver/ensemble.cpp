#include "dem/solver/ensemble.hpp"

#include "dem/contact/pack.hpp"
#include "dem/solver/batch.hpp"
#include "dem/solver/solver_lanes.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace dem {

int solver_lanes() { return lanes<Pack>; }

void push_ensemble(const Model& model, const Ensemble& ensemble, const PushPlan& plan,
                   const SolverOptions& options, const Workers& workers)
{
    check(plan, options);
    check(model, options);
    const StepTables tables = step_tables(model);
    const Task task{model, tables, plan, options};
    std::atomic<std::size_t> waiting{0};
    std::mutex one_at_a_time;
    std::exception_ptr trouble;
    const auto next = [&]() -> std::optional<NumberedWall> {
        for (std::size_t number = waiting++; number < ensemble.size; number = waiting++)
            if (std::optional<WallMaterials> materials = ensemble.wall(number)) {
                check(model, *materials);
                return NumberedWall{number, std::move(*materials)};
            } else if (ensemble.open) {
                break;
            }
        return {};
    };
    const auto done = [&](std::size_t number, PushResult&& result) {
        const std::lock_guard lock(one_at_a_time);
        if (trouble)
            std::rethrow_exception(
                trouble); // from another thread; this thread's walls are abandoned too
        try {
            ensemble.done(number, std::move(result));
        } catch (...) {
            trouble = std::current_exception(); // before another thread has its turn
            throw;
        }
    };
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const int threads = workers.threads > 0 ? workers.threads : static_cast<int>(cores);
    const auto teams = static_cast<std::size_t>(threads);
    const int most_lanes = static_cast<int>(
        std::min<std::size_t>(1000, ensemble.size / teams + (ensemble.size % teams != 0)));
    const auto work = [&] {
        try {
            workers.scalar ? run_batch<double>(task, most_lanes, next, done)
                           : run_batch<Pack>(task, most_lanes, next, done);
        } catch (...) {
            const std::lock_guard lock(one_at_a_time);
            if (!trouble) trouble = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> team;
        for (int t = 1; t < threads; ++t) team.emplace_back(work);
        work();
    }
    if (trouble) std::rethrow_exception(trouble);
}

} // namespace dem
