#include "app/study/stored/stored_study.hpp"

#include "app/input/study/study.hpp"
#include "app/input/study_reading.hpp"
#include "app/store/continued_head.hpp"
#include "app/store/hdf5/store_error.hpp"
#include "app/store/record_keys.hpp"
#include "app/study/stored/history_names.hpp"
#include "app/study/stored/study_identity.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>
#include <string_view>

namespace app {
namespace {

/// The configuration has the scale that was found, and whole paths of records; the identity has
/// what was given.
bool is_found_out(std::string_view key)
{
    return key == "load.protocol_scale" ||
           std::ranges::find(kRecordKeys, key) != kRecordKeys.end();
}

std::string without_found_out(const std::string& identity)
{
    std::string text;
    std::istringstream in(identity);
    for (std::string line; std::getline(in, line);)
        if (!is_found_out(trimmed(std::string_view(line).substr(0, line.find('=')))))
            text += line + "\n";
    return text;
}

bool same_stress(double a, double b)
{
    constexpr double kRounding = 1e-9; // texts have twelve digits
    return std::abs(a - b) <= kRounding * std::max(std::abs(a), std::abs(b));
}

bool same_walls(const StoreHead& head, const LoadInput& load, const UqInput& uq)
{
    return head.seed == uq.seed &&
           std::ranges::equal(std::span(head.levels).first(own_levels(head)),
                              load.vertical_stress, same_stress, &StoreLevel::vertical_stress);
}

constexpr const char* kNotOfWalls = "its configuration is not that of its walls";

void check_configuration(const std::filesystem::path& file, const StoreHead& head,
                         const Study& study)
{
    if (!same_walls(head, study.load, study.uq))
        damaged(file, kNotOfWalls + std::string(", which have another seed or other stresses"));
    const std::string own = identity_text(study);
    if (solver_revision(head.identity) != solver_revision(own))
        return; // had other keys; other_revision_text says so
    std::string why = text_difference(without_found_out(without_record_lines(head.identity)),
                                      without_found_out(own));
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
