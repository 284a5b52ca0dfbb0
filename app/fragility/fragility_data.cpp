#include "app/fragility/fragility_data.hpp"

#include "app/output/cells.hpp"

namespace app {

std::vector<fragility::Observation> limits_of(const DriftGroup& group, std::size_t state,
                                              int mode)
{
    std::vector<fragility::Observation> limits;
    for (const DriftWall& w : group.walls)
        if ((mode < 0 || w.mode == mode) && w.limits[state]) limits.push_back(*w.limits[state]);
    return limits;
}

std::string drift_head(const DriftData& data, const std::string& what)
{
    return data.unit.empty() ? what : what + " [" + data.unit + "]";
}

Cell group_cell(const DriftGroup& group)
{
    return group.stress ? Cell(given(*group.stress)) : Cell(group.name);
}

std::string state_name(const DriftState& state)
{
    return state.set.empty() ? state.name : state.set + " " + state.name;
}

std::string counts_text(const DriftData& data)
{
    std::size_t n = 0, failed = 0, missing = 0;
    for (const DriftGroup& g : data.groups) {
        n += g.walls.size();
        failed += g.failed;
        missing += g.missing;
    }
    std::string text = data.source + ": " + std::to_string(n) + " walls";
    if (failed > 0) text += ", " + std::to_string(failed) + " failed";
    if (missing > 0) text += ", " + std::to_string(missing) + " not in this file";
    return text;
}

} // namespace app
