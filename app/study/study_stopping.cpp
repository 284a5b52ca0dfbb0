#include "app/study/study_stopping.hpp"

#include "app/reading/wall_response.hpp"
#include "app/text/number_text.hpp"
#include "uq/estimates/stopping.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace app {
namespace {

constexpr double kFailed = std::numeric_limits<double>::quiet_NaN();

uq::StoppingRule rule_of(const UqInput& uq)
{
    uq::StoppingRule rule;
    const bool share = uq.stop == kStopAtMixedShare;
    rule.target = share ? uq::StoppingTarget::probability_below : uq::StoppingTarget::mean;
    rule.threshold = 0.5; // of 0: mixed, 1: rocking
    rule.relative = !share;
    rule.half_width = uq.stop_half_width;
    rule.min_n = std::max<std::size_t>(2, static_cast<std::size_t>(uq.samples));
    rule.max_n = std::max(rule.min_n, static_cast<std::size_t>(uq.most_samples));
    return rule;
}

/// Of a wall that gave a result. An ultimate displacement that is only a bound counts with its bound, as in
/// the mean of the paper's tables.
double value_of(const WallReading& wall, const Study& study)
{
    if (study.uq.stop == kStopAtMixedShare)
        return wall.mode == dem::FailureMode::mixed ? 0.0 : 1.0;
    return kWallResponses.at(study.uq.stop).read(wall, study.load.height);
}

} // namespace

StoppingState stopping_state(const StudyWalls& walls)
{
    const uq::StoppingRule rule = rule_of(walls.study.uq);
    StoppingState state;
    for (const StudyLevel& level : walls.levels) {
        std::vector<double> values(level.failed_walls.size(), kFailed);
        for (const StudyWall& w : level.walls)
            values.push_back(value_of(w.reading, walls.study));
        const uq::StoppingDecision d = uq::judge(rule, values);
        state.next = std::max(state.next, static_cast<std::uint32_t>(d.next_n));
        state.remark += stress_text(level.stress) + ": " + std::to_string(values.size()) +
                        " walls, half width " + number(d.half_width, 3) +
                        " (wanted: " + number(rule.half_width, 3) + "), " +
                        std::string(words(d.reason)) + "\n";
    }
    return state;
}

} // namespace app
