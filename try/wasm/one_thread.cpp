/// dem/solver/ensemble.cpp of one thread.

#include "dem/contact/pack.hpp"
#include "dem/solver/batch.hpp"
#include "dem/solver/ensemble.hpp"
#include "dem/solver/solver_lanes.hpp"

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
    std::size_t waiting = 0;
    const auto next = [&]() -> std::optional<NumberedWall> {
        while (waiting < ensemble.size) {
            const std::size_t number = waiting++;
            if (std::optional<WallMaterials> materials = ensemble.wall(number)) {
                check(model, *materials);
                return NumberedWall{number, std::move(*materials)};
            }
        }
        return {};
    };
    const auto most = static_cast<int>(ensemble.size);
    workers.scalar ? run_batch<double>(task, most, next, ensemble.done)
                   : run_batch<Pack>(task, most, next, ensemble.done);
}

} // namespace dem
