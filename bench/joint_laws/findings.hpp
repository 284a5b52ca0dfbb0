#pragma once
/// Sentences with which docs/joint_laws.md begins, made of the numbers of its tables.

#include "bench/joint_laws/law_tables.hpp"

#include <span>
#include <string>
#include <vector>

namespace bench {

/// Studies in the order of kJointLaws, without those that were not run.
struct LawRuns {
    NamedStudies random, mean;
    /// One law each: as in `mean`, then at other speeds and finer.
    std::vector<NamedStudies> mean_checks;
    /// One law each: fewer walls as in `random`, then the same more slowly and finer.
    std::vector<NamedStudies> random_checks;
    /// Walls with mean values by largest stiffness and by closure loss; one speed and
    /// discretisation each, its default first.
    std::vector<NamedStudies> limits, losses;
};

/// Sentences of which each needs its runs, else it is left out.
[[nodiscard]] std::vector<std::string> findings(const LawRuns& runs,
                                                std::span<const TestedWall> tests);

} // namespace bench
