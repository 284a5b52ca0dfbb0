#include "app/fragility/numbers/answer_table.hpp"
#include "app/report/report_parts.hpp"
#include "app/text/json_text.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace app {
namespace {

constexpr std::size_t kMostAnswers = 6; ///< stresses: more hide the picture below

std::vector<std::size_t> shown_levels(std::size_t n)
{
    std::vector<std::size_t> shown;
    const std::size_t most = std::min(n, kMostAnswers);
    for (std::size_t i = 0; i < most; ++i)
        shown.push_back(most == 1 ? 0 : i * (n - 1) / (most - 1));
    return shown;
}

} // namespace

Json answers_json(const StudyWalls& study, const DriftData& data)
{
    const Table table = answer_table(study, data);
    const ShownTable people = shown(table);
    Json rows = Json::array();
    const std::vector<std::size_t> levels = shown_levels(people.rows.size());
    for (const std::size_t l : levels) rows.push_back(people.rows[l]);
    std::string note = table.caption;
    if (levels.size() < study.levels.size())
        note += " " + std::to_string(levels.size()) + " of " +
                std::to_string(study.levels.size()) +
                " stresses; the sections below have all of them.";
    return {{"head", people.head}, {"rows", rows}, {"note", note}};
}

} // namespace app
