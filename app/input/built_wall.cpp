#include "app/input/built_wall.hpp"

#include "app/input/unit_cracks.hpp"
#include "app/input/units.hpp"
#include "app/text/words.hpp"
#include "dem/scene/bond.hpp"
#include "dem/scene/layout.hpp"
#include "dem/scene/rubble.hpp"

#include <string_view>
#include <utility>
#include <vector>

namespace app {
namespace {

/// Where each course has a height of its own, their number and mean follow.
void read_course_heights(Study& study)
{
    dem::WallGeometry& wall = study.wall;
    if (wall.course_heights.empty()) return;
    wall.courses = static_cast<int>(wall.course_heights.size());
    wall.course_height = dem::top_of_course(wall, wall.courses) / wall.courses;
}

/// Fills the wall with stones.
void read_rubble(Study& study)
{
    constexpr double kMostStones = 10000; // whose generation takes a minute
    const dem::WallGeometry& wall = study.wall;
    if (wall.courses * (wall.length / wall.unit_length) > kMostStones)
        throw error_at(study.source, "wall.unit_length",
                       "makes a wall of more than 10000 stones; write larger ones, or draw "
                       "the wall");
    for (dem::Outline& outline :
         dem::rubble({wall.length, dem::top_of_course(wall, wall.courses), wall.unit_length,
                      wall.course_height, wall.seed}))
        study.geometry.units.push_back({std::move(outline), 0});
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
        static_cast<void>(dem::lay_out(study.wall, 0.0));
    });
}

} // namespace

void read_built_wall(Study& study)
{
    if (study.geometry.rubble)
        read_rubble(study);
    else
        read_course_heights(study);
    read_unit_cracks(study);
    read_openings(study);
}

} // namespace app
