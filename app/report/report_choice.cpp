#include "app/report/report_choice.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace app {
namespace {

using Groups = std::map<std::pair<std::uint32_t, dem::FailureMode>, WallList>;

/// The first of each group, the second of each, and so on.
WallList in_turns(const Groups& groups, std::size_t most)
{
    WallList chosen;
    bool any = true;
    for (std::size_t turn = 0; any && chosen.size() < most; ++turn) {
        any = false;
        for (const auto& [key, walls] : groups) {
            if (turn >= walls.size() || chosen.size() >= most) continue;
            chosen.push_back(walls[turn]);
            any = true;
        }
    }
    return chosen;
}

} // namespace

std::size_t walls_in_page(std::size_t blocks)
{
    return std::max(kFewestFilmed, kMostFilmedBlocks / std::max<std::size_t>(1, blocks));
}

WallList walls_to_list(const StudyWalls& study, std::size_t most)
{
    Groups groups;
    for (const StudyWall* w : all_walls(study)) groups[{w->key.level, {}}].push_back(w);
    WallList listed = in_turns(groups, most);
    std::ranges::sort(listed,
                      [](const StudyWall* a, const StudyWall* b) { return a->key < b->key; });
    return listed;
}

WallList walls_to_show(const WallList& listed, std::size_t most)
{
    Groups groups;
    for (const StudyWall* w : listed)
        if (!w->failed) groups[{w->key.level, w->reading.mode}].push_back(w);
    return in_turns(groups, most);
}

} // namespace app
