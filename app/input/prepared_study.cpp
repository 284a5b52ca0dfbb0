#include "app/input/prepared_study.hpp"

#include "app/input/needed_cracks.hpp"
#include "app/input/protocol_scale.hpp"
#include "app/input/study_checks.hpp"
#include "app/input/wall/built_wall.hpp"
#include "app/input/wall/unit_cracks.hpp"
#include "app/input/wall/wall_geometry.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace app {
namespace {

/// Only openings make a wall in courses that cannot be laid.
dem::Layout laid_out(const Masonry& masonry, const StudyFile& source)
{
    const bool openings = !masonry.wall.openings.empty();
    return read_at(source, openings ? "wall.openings" : geometry_key(masonry.geometry),
                   [&] { return layout_of(masonry, source); });
}

void find_needed_cracks(PreparedStudy& ready)
{
    if (!asks_for_needed_cracks(ready.study, ready.study.source)) return;
    const auto boxes = read_at(ready.study.source, "unit.cracks_where",
                               [&] { return needed_cracks(ready.study); });
    put_cracks(boxes, ready.study);
    ready.layout = laid_out(ready.study, ready.study.source);
}

} // namespace

PreparedStudy lay_again(Study study)
{
    grow_rubble(study);
    if (!is_drawn(study.geometry)) check_pieces_of_units(study, study.source);
    dem::Layout layout = laid_out(study, study.source);
    check_blocks(study, study.source, layout);
    if (!is_drawn(study.geometry) && study.wall.base == dem::Base::fixed && !study.beam.present)
        require_joints(study.geometry, study.source, layout);
    return {std::move(study), std::move(layout)};
}

PreparedStudy prepare(Study study)
{
    PreparedStudy ready = lay_again(std::move(study));
    find_needed_cracks(ready);
    scale_protocol(ready);
    return ready;
}

PreparedStudy in_layout(Study study, std::uint32_t seed)
{
    study.wall.seed = seed;
    study.geometry.layouts = 1;
    std::vector<Entry>& entries = study.source.entries;
    std::erase_if(entries, [](const Entry& e) {
        return e.key == "wall.layouts" || e.key == "wall.seed";
    });
    entries.push_back({"wall.seed", std::to_string(seed)}); // as --set
    return lay_again(std::move(study));
}

dem::Model model_of(const PreparedStudy& ready)
{
    const Study& study = ready.study;
    const Parameters& p = study.parameters;
    const double h = study.wall.course_height;
    const StressLevel first = stress_level(study.load, 0);
    return read_at(study.source, geometry_key(study.geometry), [&] {
        return dem::discretise(ready.layout, p.stone, study.beam, loads(study.load, 0),
                               {joint_material(p, h, first), crack_material(p, h, first)},
                               study.discretisation);
    });
}

} // namespace app
