#include "dem/solver/cyclic_protocol.hpp"

#include <cmath>

namespace dem {

std::vector<CyclicStage> stages_of(Protocol protocol, double largest)
{
    std::vector<CyclicStage> stages;
    if (protocol == Protocol::fema461) {
        constexpr int kStages = 10;
        constexpr double kGrowth = 1.4;
        for (int i = 1; i <= kStages; ++i)
            stages.push_back({largest * std::pow(kGrowth, i - kStages), 2});
    } else if (protocol == Protocol::iso16670) {
        for (const double percent : {1.25, 2.5, 5.0, 7.5, 10.0})
            stages.push_back({largest * percent / 100.0, 1});
        for (const double percent : {20.0, 40.0, 60.0, 80.0, 100.0})
            stages.push_back({largest * percent / 100.0, 3});
    }
    return stages;
}

std::vector<double> cyclic_targets(const std::vector<CyclicStage>& stages)
{
    std::vector<double> targets;
    for (const CyclicStage& stage : stages)
        for (int i = 0; i < stage.cycles; ++i) {
            targets.push_back(stage.amplitude);
            targets.push_back(-stage.amplitude);
        }
    if (!targets.empty()) targets.push_back(0.0);
    return targets;
}

} // namespace dem
