#include "app/input/wall/built_wall.hpp"

#include "app/input/study/study.hpp"
#include "app/input/study/units.hpp"
#include "app/input/wall/unit_cracks.hpp"
#include "app/text/words.hpp"
#include "dem/scene/bond.hpp"
#include "dem/scene/rubble.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace app {
namespace {

/// The shortest unit or header [m].
double shortest_unit(const Masonry& masonry, const StudyFile& source)
{
    if (masonry.geometry.rubble || masonry.wall.bond == dem::Bond::shifted)
        return masonry.wall.unit_length;
    const bool given = find_entry(source, "wall.header_length") != nullptr;
    return std::min(masonry.wall.unit_length,
                    given ? masonry.wall.header_length : 0.5 * masonry.wall.unit_length);
}

/// Where each course has a height of its own, their number and mean follow.
void read_course_heights(Study& study)
{
    dem::WallGeometry& wall = study.wall;
    if (wall.course_heights.empty()) return;
    wall.courses = static_cast<int>(wall.course_heights.size());
    wall.course_height = dem::top_of_course(wall, wall.courses) / wall.courses;
}

/// Before anything is laid.
void check_number(const Masonry& masonry, const StudyFile& source)
{
    constexpr double kMostUnits = 1e5;
    if (unit_count(masonry, source) > kMostUnits)
        throw error_at(source,
                       shortest_unit(masonry, source) < masonry.wall.unit_length
                           ? "wall.header_length"
                           : "wall.unit_length",
                       "makes a wall of more than 100000 units; write larger ones");
}

/// Before any stone grows.
void check_stones(const Masonry& masonry, const StudyFile& source)
{
    constexpr double kMostStones = 10000; // half a second to lay; pushing them takes days
    if (unit_count(masonry, source) > kMostStones)
        throw error_at(source, "wall.unit_length",
                       "makes a wall of more than 10000 stones; write larger ones, or draw "
                       "the wall");
}

/// "x, z, width, height; ...", each with its unit.
void read_openings(Study& study)
{
    if (study.geometry.openings.empty()) return;
    read_at(study.source, "wall.openings", [&] {
        for (const std::string_view part : split(study.geometry.openings, ";")) {
            const std::vector<std::string_view> v = split(part, ",");
            if (v.size() != 4)
                throw BadValue(
                    in_quotes(part) +
                    " is not an opening; write x, z, width and height: \"0.4 m, 0 m, "
                    "0.6 m, 1.2 m\"");
            study.wall.openings.push_back({parse_quantity(v[0], "m"), parse_quantity(v[1], "m"),
                                           parse_quantity(v[2], "m"),
                                           parse_quantity(v[3], "m")});
        }
        study.geometry.layers = {"lintel"}; // as which `scene` draws and exports them
    });
}

} // namespace

double unit_count(const Masonry& masonry, const StudyFile& source)
{
    return masonry.wall.courses * (masonry.wall.length / shortest_unit(masonry, source));
}

void read_built_wall(Study& study)
{
    if (!study.geometry.rubble) read_course_heights(study);
    check_number(study, study.source);
    if (study.geometry.rubble) check_stones(study, study.source);
    read_unit_cracks(study);
    read_openings(study);
}

void grow_rubble(Masonry& masonry)
{
    if (!masonry.geometry.rubble) return;
    const dem::WallGeometry& wall = masonry.wall;
    masonry.geometry.units.clear();
    for (dem::Outline& outline :
         dem::rubble({wall.length, dem::top_of_course(wall, wall.courses), wall.unit_length,
                      wall.course_height, wall.seed}))
        masonry.geometry.units.push_back({std::move(outline), 0});
}

} // namespace app
