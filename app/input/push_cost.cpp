#include "app/input/push_cost.hpp"

#include "app/input/keys/study_keys.hpp"
#include "dem/block/contact_count.hpp"

namespace app {
namespace {

/// The walls of the paper take 1.5 to 3 times the steps of the fastest drive at 1 %, 7 to 26
/// times at 0.1 %.
double expected_steps(const LoadInput& load, const dem::SolverOptions& o)
{
    constexpr double kTwice = 0.015; // accuracy that takes twice the steps of the fastest drive
    const double slower = o.unbalance_limit > 0.0 ? kTwice / o.accuracy : 0.0;
    return 1e3 * push_way(load).length * o.steps_per_mm * (1.0 + slower);
}

} // namespace

double expected_updates(const LoadInput& load, const dem::Discretisation& discretisation,
                        const dem::SolverOptions& solver, const dem::Layout& layout)
{
    return expected_steps(load, solver) *
           static_cast<double>(dem::contact_count(layout, discretisation));
}

} // namespace app
