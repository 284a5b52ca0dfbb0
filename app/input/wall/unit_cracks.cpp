#include "app/input/wall/unit_cracks.hpp"

#include "app/input/study/study.hpp"
#include "app/input/study/units.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "dem/scene/layout.hpp"
#include "dem/scene/piece_count.hpp"
#include "dem/scene/touching.hpp"

#include <charconv>
#include <stdexcept>
#include <string_view>

namespace app {
namespace {

using CrackKind = dem::CrackPattern::Kind;

constexpr std::string_view kNeeded = "needed";
constexpr double kToeHeight = 0.4;                          // of the wall
constexpr int kMostPieces = 100;                            // along either side of a unit
constexpr double kSmallestCell = 1e-3, kLargestCell = 10.0; // [m]

[[noreturn]] void refuse_pattern(std::string_view text)
{
    throw BadValue(
        in_quotes(text) +
        " is not a pattern; write none, mid, thirds, grid(4, 4), diagonals or voronoi(40 mm)");
}

/// Text between the brackets of "NAME(...)"; nothing if the text does not begin with the name.
std::string_view arguments(std::string_view text, std::string_view name)
{
    if (!text.starts_with(name) || !text.ends_with(")")) return {};
    const std::string_view rest = trimmed(text.substr(name.size()));
    return rest.starts_with("(") ? rest.substr(1, rest.size() - 2) : std::string_view{};
}

int parse_pieces(std::string_view text)
{
    int n = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    if (error != std::errc{} || end != text.data() + text.size() || n < 1 || n > kMostPieces)
        throw BadValue(in_quotes(text) +
                       " is not a number of pieces; write a whole number from 1 to " +
                       std::to_string(kMostPieces));
    return n;
}

dem::CrackPattern parse_pattern(std::string_view text)
{
    text = trimmed(text);
    if (text == "none") return {CrackKind::none};
    if (text == "mid") return {CrackKind::mid};
    if (text == "thirds") return {CrackKind::grid, 3, 1};
    if (text == "diagonals") return {CrackKind::diagonals};
    if (const std::string_view in = arguments(text, "grid"); !in.empty()) {
        const std::vector<std::string_view> n = split(in, ",");
        if (n.size() != 2) refuse_pattern(text);
        return {CrackKind::grid, parse_pieces(n[0]), parse_pieces(n[1])};
    }
    if (const std::string_view in = arguments(text, "voronoi"); !in.empty()) {
        const double size = parse_quantity(in, "m");
        if (!(size >= kSmallestCell && size <= kLargestCell))
            throw BadValue("cells of " + in_quotes(in) +
                           " are not pieces of units; write 1 mm to 10 m");
        return {CrackKind::voronoi, 1, 1, size};
    }
    refuse_pattern(text);
}

dem::Region toe_of(const Masonry& masonry, const LoadInput& load)
{
    const dem::Region all = wall_extent(masonry);
    const double middle = 0.5 * (all.x0 + all.x1);
    const int direction = push_way(load).direction;
    return {direction > 0 ? middle : all.x0, all.z0, direction < 0 ? middle : all.x1,
            all.z0 + kToeHeight * (all.z1 - all.z0)};
}

dem::Region parse_box(std::string_view text)
{
    const std::vector<std::string_view> v = split(text, ",");
    if (v.size() != 4)
        throw BadValue(in_quotes(text) +
                       " is not a region; write toe, needed, or x, z, width and height: "
                       "\"0.5 m, 0 m, 0.5 m, 0.4 m\"");
    const double x = parse_quantity(v[0], "m"), z = parse_quantity(v[1], "m"),
                 width = parse_quantity(v[2], "m"), height = parse_quantity(v[3], "m");
    if (!(width > 0.0 && height > 0.0))
        throw BadValue(in_quotes(text) + " has no area; width and height must be above 0 m");
    return {x, z, x + width, z + height};
}

std::vector<dem::Region> parse_regions(std::string_view text, const Masonry& masonry,
                                       const LoadInput& load)
{
    if (trimmed(text) == kNeeded) return {}; // all, until it is found out
    if (trimmed(text) == "toe") return {toe_of(masonry, load)};
    std::vector<dem::Region> regions;
    for (const std::string_view box : split(text, ";")) regions.push_back(parse_box(box));
    return regions;
}

/// "0.5 m, 0 m, 0.5 m, 0.4 m; ..."
std::string regions_text(const std::vector<dem::Region>& regions)
{
    std::string text;
    for (const dem::Region& r : regions) {
        text += text.empty() ? "" : "; ";
        for (const double x : {r.x0, r.z0, r.x1 - r.x0}) text += number(x, 9) + " m, ";
        text += number(r.z1 - r.z0, 9) + " m";
    }
    return text;
}

/// A drawn wall has whole units only where their length is given, rubble none.
void keep_possible(const GeometryInput& geometry, const StudyFile& source, std::string_view key,
                   dem::CrackPattern& pattern)
{
    const bool whole_units =
        in_courses(geometry) ||
        (!geometry.rubble && find_entry(source, "wall.unit_length") != nullptr);
    if (pattern.kind != CrackKind::mid || whole_units) return;
    if (find_entry(source, key) != nullptr)
        throw error_at(
            source, key,
            geometry.rubble
                ? "mid needs whole units, and rubble has none; write thirds, grid(2, 2), ..."
                : "mid needs whole units; give wall.unit_length, by which whole units of a "
                  "drawn "
                  "wall are known, or write thirds, grid(2, 2), ...");
    pattern = {CrackKind::none};
}

} // namespace

CrackPatterns crack_patterns(const Masonry& masonry, const StudyFile& source)
{
    if (masonry.cracks.cut_nothing) return {{CrackKind::none}, {CrackKind::none}};
    CrackPatterns p{{masonry.cracks.in_units ? CrackKind::mid : CrackKind::none},
                    {masonry.cracks.in_units ? CrackKind::mid : CrackKind::none}};
    if (!masonry.cracks.pattern.empty()) {
        if (!masonry.cracks.in_units)
            throw error_at(source, "unit.cracks",
                           "wall.unit_cracks = no says that units have no cracks; remove one "
                           "of the two keys");
        read_at(source, "unit.cracks",
                [&] { p.pattern = parse_pattern(masonry.cracks.pattern); });
    }
    if (!masonry.cracks.elsewhere.empty())
        read_at(source, "unit.cracks_elsewhere",
                [&] { p.elsewhere = parse_pattern(masonry.cracks.elsewhere); });
    else if (trimmed(masonry.cracks.where) == kNeeded)
        p.elsewhere = {CrackKind::none};
    keep_possible(masonry.geometry, source, "unit.cracks", p.pattern);
    keep_possible(masonry.geometry, source, "unit.cracks_elsewhere", p.elsewhere);
    return p;
}

void read_unit_cracks(Study& study)
{
    const CrackPatterns p = crack_patterns(study, study.source);
    study.wall.cracks.pattern = p.pattern;
    study.wall.cracks.elsewhere = p.elsewhere;
    if (!study.cracks.where.empty())
        read_at(study.source, "unit.cracks_where", [&] {
            study.wall.cracks.where = parse_regions(study.cracks.where, study, study.load);
        });
}

void check_pieces_of_units(const Masonry& masonry, const StudyFile& source)
{
    constexpr double kMostPieces = 1e5;
    const dem::UnitCracks& cracks = masonry.wall.cracks;
    if (!any_pattern(masonry, source, [](const dem::CrackPattern& p) {
            return p.kind == CrackKind::grid || p.kind == CrackKind::voronoi;
        }))
        return;                // few pieces of each unit
    Masonry regular = masonry; // random lengths may not be possible, which is told later
    regular.wall.length_cov = 0.0;
    const dem::Layout whole = whole_units(regular, source);
    double within = 0.0, elsewhere = 0.0;
    for (int k = 0; k < whole.beam; ++k) {
        const dem::Block& b = whole.blocks[static_cast<std::size_t>(k)];
        const dem::CrackPattern& pattern = dem::pattern_at(cracks, dem::centre_of(b));
        (&pattern == &cracks.pattern ? within : elsewhere) +=
            dem::piece_count(dem::corners_of(b), pattern, masonry.wall.unit_length);
    }
    if (within + elsewhere <= kMostPieces) return;
    throw error_at(source, within >= elsewhere ? "unit.cracks" : "unit.cracks_elsewhere",
                   "makes about " + fixed(within + elsewhere, 0) +
                       " pieces of units; write larger cells or fewer pieces, or "
                       "unit.cracks_where for a part of the wall, so that there are at most "
                       "100000");
}

bool asks_for_needed_cracks(const Masonry& masonry, const StudyFile& source)
{
    return trimmed(masonry.cracks.where) == kNeeded && has_cracks(masonry, source);
}

void put_cracks(const std::vector<dem::Region>& boxes, Study& study)
{
    study.wall.cracks.where = boxes;
    study.cracks.where = regions_text(boxes);
    if (study.cracks.elsewhere.empty()) study.cracks.elsewhere = "none";
}

bool has_cracks(const Masonry& masonry, const StudyFile& source)
{
    return any_pattern(masonry, source,
                       [](const dem::CrackPattern& p) { return p.kind != CrackKind::none; });
}

} // namespace app
