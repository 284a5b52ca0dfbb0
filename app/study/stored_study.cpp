#include "app/study/stored_study.hpp"

#include "app/store/store_error.hpp"
#include "app/study/study_identity.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

namespace app {
namespace {

/// The configuration has the scale that was found, the identity that it was looked for.
constexpr std::string_view kFoundOut = "load.protocol_scale";

/// An identity by what its lines are about.
struct IdentityLines {
    std::string program; ///< keys without a section
    std::string study;   ///< all others but kFoundOut
};

IdentityLines lines_of(const std::string& identity)
{
    IdentityLines lines;
    std::istringstream in(identity);
    for (std::string line; std::getline(in, line);) {
        const std::string_view key = trimmed(std::string_view(line).substr(0, line.find('=')));
        if (key == kFoundOut) continue;
        (key.find('.') == std::string::npos ? lines.program : lines.study) += line + "\n";
    }
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
    const IdentityLines stored = lines_of(head.identity), own = lines_of(identity_text(study));
    if (stored.program != own.program) return;
    std::string why = text_difference(stored.study, own.study);
    if (!why.empty()) why.pop_back(); // the end of the last line
    if (!why.empty())
        damaged(file, kNotOfWalls +
                          std::string(" (-: of its walls, +: of the configuration):\n") + why);
}

} // namespace

Study stored_study(const std::filesystem::path& file, const StoreHead& head,
                   std::span<const std::string> overrides, Purpose purpose)
{
    const StudyFile source = parse_study_text(file.string(), head.configuration);
    Study study = read_study(source, purpose);
    check_configuration(file, head, study);
    if (overrides.empty()) return study;
    return read_study(with_overrides(source, overrides), purpose);
}

} // namespace app
