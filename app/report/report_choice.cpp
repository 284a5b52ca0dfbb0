#include "app/report/report_choice.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace app {
namespace {

using Groups = std::map<std::pair<std::uint32_t, bool>, std::vector<std::size_t>>;

/// The first of each group, the second of each, and so on.
std::vector<std::size_t> in_turns(const Groups& groups, std::size_t most)
{
    std::vector<std::size_t> chosen;
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

std::vector<std::size_t> walls_to_list(const ReportStudy& study, std::size_t most)
{
    Groups groups;
    for (std::size_t i = 0; i < study.walls.size(); ++i)
        groups[{study.walls[i].row.key.level, false}].push_back(i);
    std::vector<std::size_t> listed = in_turns(groups, most);
    std::sort(listed.begin(), listed.end());
    return listed;
}

std::vector<std::size_t> walls_to_show(const ReportStudy& study,
                                       const std::vector<std::size_t>& listed, std::size_t most)
{
    Groups groups;
    for (const std::size_t i : listed) {
        const ReportWall& w = study.walls.at(i);
        if (!w.failed) groups[{w.row.key.level, w.rocking}].push_back(i);
    }
    return in_turns(groups, most);
}

} // namespace app
