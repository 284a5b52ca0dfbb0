#include "app/sampling/wall_draw.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/study/units.hpp"
#include "app/text/number_text.hpp"

#include <cmath>
#include <numeric>
#include <string>

namespace app {
namespace {

bool is_single(const std::vector<double>& values) { return values.size() == 1; }

/// Sets the values of joint or crack number `id`.
void set_values(std::span<const RandomInput> random, const WallDraw& draw, Varies varies,
                std::size_t id, Parameters& p)
{
    for (std::size_t i = 0; i < random.size(); ++i)
        if (random[i].varies == varies && !is_single(draw.values[i]))
            random[i].place(p) = draw.values[i][id];
}

bool any_spatial(std::span<const RandomInput> random, const WallDraw& draw, Varies varies)
{
    for (std::size_t i = 0; i < draw.values.size(); ++i)
        if (random[i].varies == varies && !is_single(draw.values[i])) return true;
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

std::vector<int> sites_of(std::span<const RandomInput> inputs, Spatial spatial,
                          const dem::Layout& layout)
{
    std::vector<int> sites;
    for (const RandomInput& input : inputs)
        sites.push_back(values_per_wall(input, spatial, layout));
    return sites;
}

WallDraw draw_of(std::span<const int> sites, std::span<const double> values)
{
    const auto wanted = std::accumulate(sites.begin(), sites.end(), std::size_t{0});
    if (values.size() != wanted)
        throw BadValue(std::to_string(values.size()) + " values; the wall takes " +
                       std::to_string(wanted));
    WallDraw draw;
    for (const int n : sites) {
        draw.values.emplace_back(values.begin(), values.begin() + n);
        values = values.subspan(n);
    }
    return draw;
}

WallDraw checked_draw(std::span<const RandomInput> inputs, std::span<const int> sites,
                      std::span<const double> values)
{
    WallDraw draw = draw_of(sites, values);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const Key& key = *find_key(inputs[i].key);
        for (const double x : draw.values[i])
            if (!in_range(x, key))
                throw BadValue(inputs[i].key + " = " +
                               (std::isfinite(x) ? number(x, 17) : std::to_string(x)) + " " +
                               std::string(si_unit(key.unit)) +
                               " is out of range; must be in " + allowed_values(key));
    }
    return draw;
}

dem::WallMaterials wall_materials(const Masonry& masonry, std::span<const RandomInput> random,
                                  StressLevel at, const dem::Layout& layout,
                                  const WallDraw& draw)
{
    const double h = masonry.wall.course_height;
    Parameters p = masonry.parameters;
    for (std::size_t i = 0; i < draw.values.size(); ++i)
        if (is_single(draw.values[i])) random[i].place(p) = draw.values[i].front();
    for (const ParameterRule& rule : masonry.rules) rule.apply(p, h);
    dem::WallMaterials wall = materials(p, h, at, layout);
    // Keys of one joint say nothing about cracks.
    const auto own = [&](Varies varies, std::size_t id) {
        Parameters of = p;
        set_values(random, draw, varies, id, of);
        for (const ParameterRule& rule : masonry.rules)
            if (rule.varies == varies) rule.apply(of, h);
        return of;
    };
    if (any_spatial(random, draw, Varies::by_joint))
        for (std::size_t k = 0; k < wall.joints.size(); ++k)
            wall.joints[k] = joint_material(own(Varies::by_joint, k), h, at);
    if (any_spatial(random, draw, Varies::by_crack))
        for (std::size_t k = 0; k < wall.cracks.size(); ++k)
            wall.cracks[k] =
                crack_material(own(Varies::by_crack, k), h, at, dem::own_stiffness(layout, k));
    return wall;
}

} // namespace app
