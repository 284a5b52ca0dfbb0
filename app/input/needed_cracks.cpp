#include "app/input/needed_cracks.hpp"

#include "app/input/prepared_study.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "dem/block/model.hpp"
#include "dem/scene/mechanism/snapshot_reading.hpp"
#include "dem/solver/push.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace app {
namespace {

constexpr double kUnbreakable = 1e12; // [Pa]
constexpr double kCoarse = 0.5;       // accuracy that is enough
constexpr double kLooks = 40.0;       // at the wall, on the way of the push

/// Parallel vertical cracks add to the stiffness, so that these are kept; in place of many
/// pieces there are four.
dem::CrackPattern coarse(const dem::CrackPattern& p)
{
    if (!dem::shares_stiffness(p)) return p;
    return {dem::CrackPattern::Kind::grid, 2, 2};
}

Study coarse_study(Study s)
{
    s.wall.cracks.pattern = coarse(s.wall.cracks.pattern);
    s.wall.cracks.where.clear();
    s.solver.accuracy = std::max(s.solver.accuracy, kCoarse);
    return s;
}

/// Adds the numbers of the units that use their strength.
void add_used(const dem::Snapshot& wall, const dem::CrackMaterial& strength,
              std::set<int>& units)
{
    for (const dem::FaceState& f : wall.faces) {
        if (f.kind != dem::FaceKind::unit_crack) continue;
        const bool used = std::ranges::any_of(f.contacts, [&](const dem::ContactState& c) {
            return dem::strength_used(c, strength) >= kNeededShare;
        });
        if (used) units.insert(wall.blocks[f.block_b].unit);
    }
}

std::set<int> used_units(const Study& study, const dem::Model& model)
{
    dem::PushPlan plan = push_plan(study);
    plan.snapshot_every = push_way(study.load).length / kLooks;
    std::set<int> units;
    for (int level = 0; level < static_cast<int>(study.load.vertical_stress.size()); ++level) {
        const StressLevel at = stress_level(study.load, level);
        const dem::CrackMaterial strength =
            crack_material(study.parameters, study.wall.course_height, at);
        dem::WallMaterials w =
            materials(study.parameters, study.wall.course_height, at, model.layout);
        for (dem::CrackMaterial& c : w.cracks) c.ft = c.cohesion = kUnbreakable;
        const dem::PushResult r = dem::push(model, w, plan, study.solver);
        if (dem::failed(r.outcome))
            throw std::invalid_argument("the coarse push that looks for these units failed; "
                                        "write toe or boxes instead");
        for (const dem::Snapshot& wall : r.snapshots) add_used(wall, strength, units);
        add_used(r.at_end, strength, units);
    }
    return units;
}

} // namespace

std::vector<dem::Region> needed_cracks(const Study& study)
{
    const Study s = coarse_study(study);
    const dem::Model model = model_of({s, layout_of(s, s.source)});
    const std::set<int> used = used_units(s, model);
    std::map<int, dem::Region> whole; // by unit
    for (const dem::Block& b : model.layout.blocks) {
        const dem::Region own{b.x0, b.z0, b.x1, b.z1};
        const auto [at, first] = whole.try_emplace(b.unit, own);
        at->second = dem::join(at->second, own);
    }
    std::vector<dem::Region> boxes;
    int last = -1;
    for (const int unit : used) {
        const dem::Region r = whole.at(unit);
        const bool goes_on = unit == last + 1 && boxes.back().z0 == r.z0 &&
                             boxes.back().z1 == r.z1 && boxes.back().x1 <= r.x0 + 1e-6;
        if (goes_on)
            boxes.back().x1 = r.x1;
        else
            boxes.push_back(r);
        last = unit;
    }
    if (boxes.empty()) boxes.push_back({0.0, 0.0, 1e-3, 1e-3}); // in a corner
    return boxes;
}

} // namespace app
