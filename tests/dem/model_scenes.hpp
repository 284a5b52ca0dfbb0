#pragma once
/// A wall of few blocks and its contacts, for tests of the model.

#include "dem/block/model.hpp"
#include "scenes/paper_wall.hpp"

namespace model_scenes {

/// Two units by three courses.
inline scenes::Scene small_wall()
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.wall.length = 0.4;
    s.wall.courses = 3;
    s.loads.height = 0.4;
    return s;
}

inline dem::Discretisation coarse(int block_modes, dem::FaceRule rule = dem::FaceRule::even)
{
    dem::Discretisation d;
    d.contact_points = 3;
    d.zones_per_interval = 1;
    d.face_rule = rule;
    d.block_modes = d.beam_modes = block_modes;
    return d;
}

template <class F> void for_each_contact(const dem::Model& m, F&& f)
{
    for (const auto* list : {&m.dry, &m.tied, &m.cracks})
        for (const dem::Contact& c : *list) f(c, list == &m.cracks);
}

} // namespace model_scenes
