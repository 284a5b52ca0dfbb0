#include "dem/solver/ensemble.hpp"

#include "dem/contact/pack.hpp"
#include "dem/solver/batch.hpp"
#include "dem/solver/solver_lanes.hpp"
#include "dem/solver/team.hpp"

#include <atomic>
#include <utility>

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
    Team team;
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
        team.one_at_a_time([&] { ensemble.done(number, std::move(result)); });
    };
    const int most_lanes = lanes_wanted(ensemble.size, workers.threads);
    team.run(workers.threads, [&] {
        workers.scalar ? run_batch<double>(task, most_lanes, next, done)
                       : run_batch<Pack>(task, most_lanes, next, done);
    });
}

} // namespace dem
