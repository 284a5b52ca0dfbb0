#include "app/study/stored_study.hpp"

#include "app/store/store_error.hpp"
#include "app/study/study_identity.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace app {
namespace {

/// Lines about the program, not about the study: their keys have no section.
std::string program_lines(const std::string& identity)
{
    std::istringstream in(identity);
    std::string lines;
    for (std::string line; std::getline(in, line);)
        if (line.substr(0, line.find('=')).find('.') == std::string::npos) lines += line + "\n";
    return lines;
}

bool same_stress(double a, double b)
{
    constexpr double kRounding = 1e-9; // texts have twelve digits
    return std::abs(a - b) <= kRounding * std::max(std::abs(a), std::abs(b));
}

bool same_walls(const StoreHead& head, const Study& study)
{
    return head.seed == study.uq.seed &&
           std::ranges::equal(head.levels, study.load.vertical_stress, same_stress,
                              &StoreLevel::vertical_stress);
}

constexpr const char* kNotOfWalls = "its configuration is not that of its walls";

void check_configuration(const std::filesystem::path& file, const StoreHead& head,
                         const Study& study)
{
    if (!same_walls(head, study))
        damaged(file, kNotOfWalls + std::string(", which have another seed or other stresses"));
    const std::string identity = identity_text(study);
    if (program_lines(identity) != program_lines(head.identity)) return;
    const std::string why = text_difference(head.identity, identity);
    if (!why.empty())
        damaged(file, kNotOfWalls +
                          std::string(" (-: of its walls, +: of the configuration):\n") + why);
}

} // namespace

Study stored_study(const std::filesystem::path& file, const StoreHead& head,
                   std::span<const std::string> overrides)
{
    const StudyFile source = parse_study_text(file.string(), head.configuration);
    Study study = read_study(source);
    check_configuration(file, head, study);
    if (overrides.empty()) return study;
    return read_study(with_overrides(source, overrides));
}

} // namespace app
