#include "app/study/stored/study_identity.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/study/distribution_text.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/sampling/study_rows.hpp"
#include "app/store/store_head.hpp"
#include "app/text/number_text.hpp"
#include "dem/solver/solver_revision.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace app {
namespace {

/// Keys of no consequence for a wall; what a material gives stands at its own keys.
constexpr std::array<std::string_view, 8> kFree = {"wall.material",
                                                   "uq.samples",
                                                   "uq.audit",
                                                   "uq.stop",
                                                   "uq.stop_half_width",
                                                   "uq.most_samples",
                                                   "output.snapshot_every",
                                                   "output.paraview"};

/// The text with numbers as short as they can be and without blanks beside commas, semicolons
/// and brackets.
std::string with_short_numbers(const std::string& text)
{
    constexpr std::string_view kDivides = ",;()";
    const auto divides = [&](char c) { return kDivides.find(c) != std::string_view::npos; };
    const auto in_word = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
    };
    std::string out;
    const char* const end = text.data() + text.size();
    for (const char* at = text.data(); at != end;) {
        double value = 0.0;
        const bool word = !out.empty() && in_word(out.back());
        const auto [after, error] = std::from_chars(at, end, value);
        if (!word && *at != '-' && *at != 'i' && *at != 'n' && error == std::errc{}) {
            out += number(value, 17);
            at = after;
        } else if (*at == ' ') {
            if (!out.empty() && out.back() != ' ' && !divides(out.back())) out += ' ';
            ++at;
        } else {
            if (divides(*at) && out.ends_with(' ')) out.pop_back();
            out += *at++;
        }
    }
    return out;
}

std::string value_of(const Key& key, const Study& study)
{
    if (key.name == "wall.outlines" && is_drawn(study.geometry))
        return outlines_mark(study.geometry);
    if (is_together(study.uq, key.name)) // in the order of the rows
        return with_short_numbers(find_entry(study.source, key.name)->value);
    const bool random = std::ranges::count(study.random, key.name, &RandomInput::key) > 0;
    const bool named = key.name == "wall.layer_stones"; // layers can have numbers for names
    if (key.kind == Kind::text && !named) return with_short_numbers(value_text(key, study));
    return random ? canonical_distribution(find_entry(study.source, key.name)->value, key.unit)
                  : value_text(key, study);
}

} // namespace

std::string identity_text(const Study& study)
{
    std::string text = std::string(kRevisionKey) + std::to_string(dem::kSolverRevision) + "\n";
    for (const Key& key : study_keys()) {
        if (!is_used(key, study)) continue;
        if (std::ranges::count(kFree, key.name) > 0) continue;
        const std::string_view section = section_of(key.name);
        // How a wall has moved is read, and stored, where the force came down to this share.
        const bool stored =
            key.name == "fragility.ultimate_share" && push_plan(study).drop > 0.0;
        if (section == "reliability" || section == "calibration" ||
            (section == "fragility" && !stored))
            continue;
        if (is_drawn(study.geometry) && says_how_a_file_is_read(key))
            continue; // its outlines stand for it
        const std::string value = value_of(key, study);
        if (!value.empty()) text += std::string(key.name) + " = " + value + "\n";
    }
    const bool moved_toe = study.load.direction != Direction::left &&
                           in_courses(study.geometry) && study.wall.toe == dem::Toe::held &&
                           study.wall.toe_at_left;
    return moved_toe ? text + "wall.toe_at_left = yes\n" : text;
}

} // namespace app
