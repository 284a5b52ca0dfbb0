#include "app/push/pushed_picture.hpp"

#include "app/output/picture/wall_svg.hpp"
#include "app/study/stored/study_walls.hpp"

namespace app {

std::string pushed_picture(const dem::Beam& beam, const LoadInput& load,
                           const dem::Layout& layout, const PushedWall& w)
{
    WallPictureText text;
    text.title = "Wall under " + stress_text(w.vertical_stress);
    text.tints = stone_tints(layout);
    if (push_way(load).direction == 0) text.peak_name = "At the largest force";
    if (beam.present) text.vertical_load = stress_text(w.vertical_stress);
    text.load_height = w.loads.height;
    const dem::PushResult& r = w.result;
    // A wall that comes down under its vertical load has no peak.
    const dem::Snapshot& peak = r.at_peak.blocks.empty() ? r.at_end : r.at_peak;
    return wall_picture(peak, r.at_end, text);
}

} // namespace app
