#include "app/reliability/event.hpp"

namespace app {

uq::ReliabilityProblem asked_problem(const Study& study, Eigen::Index dimension)
{
    uq::ReliabilityProblem p;
    p.event.dimension = dimension;
    p.method = study.reliability.method;
    p.budget = study.reliability.budget;
    p.target_cov = study.reliability.target_cov;
    p.seed = study.uq.seed;
    if (const std::string why = uq::budget_too_small(p.method, p.budget, dimension);
        !why.empty())
        throw error_at(study.source, "reliability.budget", why);
    if (p.method == ReliabilityMethod::sobol && !study.uq.pearson.empty())
        throw error_at(
            study.source, "uq.pearson",
            "has no meaning for reliability.method = sobol: Sobol' indices are shares "
            "of independent inputs; leave it out");
    return p;
}

} // namespace app
