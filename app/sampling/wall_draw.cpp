#include "app/sampling/wall_draw.hpp"

#include "app/input/study_keys.hpp"

namespace app {
namespace {

bool is_single(const std::vector<double>& values) { return values.size() == 1; }

/// Sets the values of number `id` of all inputs that have one per joint, or per crack.
void set_values(Study& s, const WallDraw& draw, Varies varies, std::size_t id)
{
    for (std::size_t i = 0; i < s.random.size(); ++i) {
        if (s.random[i].varies != varies || is_single(draw.values[i])) continue;
        find_key(s.random[i].key)->field.set(s, {draw.values[i][id]});
    }
}

bool any_spatial(const Study& s, const WallDraw& draw, Varies varies)
{
    for (std::size_t i = 0; i < s.random.size(); ++i)
        if (s.random[i].varies == varies && !is_single(draw.values[i])) return true;
    return false;
}

} // namespace

int values_per_wall(const RandomInput& input, Spatial spatial, const dem::Layout& layout)
{
    if (spatial == Spatial::none) return 1;
    if (input.varies == Varies::by_joint) return layout.n_joints;
    if (input.varies == Varies::by_crack) return layout.n_cracks;
    return 1;
}

dem::WallMaterials wall_materials(const Study& study, const dem::Layout& layout, int level,
                                  const WallDraw& draw)
{
    Study s = study;
    for (std::size_t i = 0; i < s.random.size(); ++i)
        if (is_single(draw.values[i]))
            find_key(s.random[i].key)->field.set(s, {draw.values[i].front()});
    for (const auto& apply : derivations(s)) apply(s);
    dem::WallMaterials wall = materials(s, level, layout.n_joints, layout.n_cracks);
    if (any_spatial(s, draw, Varies::by_joint))
        for (std::size_t k = 0; k < wall.joints.size(); ++k) {
            set_values(s, draw, Varies::by_joint, k);
            wall.joints[k] = joint_material(s, level);
        }
    if (any_spatial(s, draw, Varies::by_crack)) {
        const auto derived = derivations(s, "unit");
        for (std::size_t k = 0; k < wall.cracks.size(); ++k) {
            set_values(s, draw, Varies::by_crack, k);
            for (const auto& apply : derived) apply(s);
            wall.cracks[k] = crack_material(s, level);
        }
    }
    return wall;
}

} // namespace app
