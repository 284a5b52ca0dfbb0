/// curve_hash: all bits of the curves of a fixed ensemble as one number, through packs and one
/// wall at a time; then those of walls of rubble, in mortar and of many dry stones, and of
/// joints that close between cracks of mixed modes. The numbers must not depend on compiler,
/// flags, register or threads (tests/same_bits.sh).

#include "dem/block/model.hpp"
#include "dem/contact/pack.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/rubble.hpp"
#include "dem/solver/ensemble.hpp"
#include "scenes/paper_wall.hpp"

#include <bit>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <utility>
#include <vector>

namespace {

/// FNV-1a, byte by byte from the lowest.
class Hash {
  public:
    void add(std::uint64_t x)
    {
        for (int byte = 0; byte < 8; ++byte)
            value_ = (value_ ^ ((x >> (8 * byte)) & 0xff)) * 0x100000001b3ULL;
    }
    void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

void add(const dem::PushResult& r, Hash& hash)
{
    hash.add(static_cast<std::uint64_t>(r.outcome));
    hash.add(static_cast<std::uint64_t>(r.cost.steps));
    hash.add(r.settlement);
    for (const dem::CurvePoint& p : r.curve)
        for (const double x : {p.displacement, p.force, p.base_shear, p.unbalance,
                               p.energy.work, p.energy.kinetic, p.energy.elastic,
                               p.energy.friction, p.energy.fracture, p.energy.damping})
            hash.add(x);
}

struct Case {
    dem::Fidelity fidelity;
    dem::ContactLaw law;
    dem::Damping damping;
    dem::Kinematics kinematics = dem::Kinematics::small;
};

/// Two samples at each of three stresses.
std::vector<dem::WallMaterials> walls_of(const dem::Model& model)
{
    std::vector<dem::WallMaterials> walls;
    for (const double stress : {0.15, 0.75, 1.25})
        for (const int sample : {0, 1})
            walls.push_back(scenes::table5_sample(scenes::paper_wall(stress), model, sample));
    return walls;
}

std::vector<dem::PushResult> pushed(const dem::Model& model,
                                    const std::vector<dem::WallMaterials>& walls, const Case& c,
                                    double way, bool scalar)
{
    std::vector<dem::PushResult> results(walls.size());
    dem::Ensemble ensemble;
    ensemble.size = walls.size();
    ensemble.wall = [&](std::size_t i) { return walls[i]; };
    ensemble.done = [&](std::size_t i, dem::PushResult&& r) { results[i] = std::move(r); };
    dem::PushPlan plan;
    plan.targets = {way};
    dem::SolverOptions o;
    o.steps_per_mm = 50;
    o.accuracy = 0.2;
    o.law = c.law;
    o.damping = c.damping;
    o.kinematics = c.kinematics;
    dem::push_ensemble(model, ensemble, plan, o, {.scalar = scalar});
    return results;
}

void add_case(const Case& c, Hash& packs, Hash& scalar)
{
    const dem::Model model =
        scenes::model_of(scenes::paper_wall(0.75), dem::discretisation_of(c.fidelity));
    const std::vector<dem::WallMaterials> walls = walls_of(model);
    for (const dem::PushResult& r : pushed(model, walls, c, 0.008, false)) add(r, packs);
    for (const dem::PushResult& r : pushed(model, walls, c, 0.008, true)) add(r, scalar);
}

/// Joints with mortar between some seventeen stones.
dem::Model rubble_model(const scenes::Scene& s)
{
    dem::DrawnWall wall;
    for (dem::Outline& stone : dem::rubble({.stone_length = 0.3, .stone_height = 0.2}))
        wall.units.push_back({std::move(stone), 0});
    wall.unit_length = 0.3;
    dem::Layout layout = dem::drawn_layout(wall, s.beam.height);
    layout.mortar = true;
    return dem::discretise(layout, s.stone, s.beam, s.loads, {s.joint, s.crack},
                           dem::discretisation_of(dem::Fidelity::simple));
}

/// So many dry stones that the matrix of each is stored once.
void add_many_stones(Hash& packs, Hash& scalar)
{
    scenes::Scene s = scenes::paper_wall(0.50);
    dem::DrawnWall wall;
    for (dem::Outline& stone : dem::rubble({.length = 2.2}))
        wall.units.push_back({std::move(stone)});
    const dem::Model model = dem::discretise(dem::drawn_layout(wall, s.beam.height), s.stone,
                                             s.beam, s.loads, {s.joint, s.crack});
    const std::vector<dem::WallMaterials> walls{scenes::table5_spatial_sample(s, model, 0),
                                                scenes::table5_spatial_sample(s, model, 1)};
    for (const dem::Kinematics k : {dem::Kinematics::small, dem::Kinematics::finite}) {
        const Case c{dem::Fidelity::standard, dem::ContactLaw::coupled, dem::Damping::combined,
                     k};
        for (const dem::PushResult& r : pushed(model, walls, c, 0.001, false)) add(r, packs);
        for (const dem::PushResult& r : pushed(model, walls, c, 0.001, true)) add(r, scalar);
    }
}

void add_rubble(Hash& packs, Hash& scalar)
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.joint.ft = 0.1e6;
    s.joint.cohesion = 0.15e6;
    s.joint.fracture_energy = 10.0;
    const dem::Model model = rubble_model(s);
    std::vector<dem::WallMaterials> walls;
    for (const int sample : {0, 1}) walls.push_back(scenes::table5_sample(s, model, sample));
    const Case c{dem::Fidelity::simple, dem::ContactLaw::coupled, dem::Damping::combined};
    for (const dem::PushResult& r : pushed(model, walls, c, 0.004, false)) add(r, packs);
    for (const dem::PushResult& r : pushed(model, walls, c, 0.004, true)) add(r, scalar);
}

/// Joints that close and lose energy, cracks of mixed modes.
void add_closing(Hash& packs, Hash& scalar)
{
    for (const dem::Closure closure : {dem::Closure::hyperbolic, dem::Closure::exponential}) {
        scenes::Scene s = scenes::paper_wall(0.75);
        s.closure = closure;
        s.joint.closing = {4.87e9, 0.154e-3, 0.2, 487e9};
        s.crack.envelope = dem::Envelope::hyperbolic;
        s.crack.shear_fracture_energy = 1000.0;
        dem::Model model = scenes::model_of(s, dem::discretisation_of(dem::Fidelity::simple));
        model.layout.mixed_mode = true;
        const std::vector<dem::WallMaterials> walls{scenes::table5_sample(s, model, 0),
                                                    scenes::table5_sample(s, model, 1)};
        for (const dem::Kinematics k : {dem::Kinematics::small, dem::Kinematics::finite}) {
            const Case c{dem::Fidelity::simple, dem::ContactLaw::coupled,
                         dem::Damping::combined, k};
            for (const dem::PushResult& r : pushed(model, walls, c, 0.002, false))
                add(r, packs);
            for (const dem::PushResult& r : pushed(model, walls, c, 0.002, true))
                add(r, scalar);
        }
    }
}

} // namespace

int main()
try {
    using enum dem::Fidelity;
    using enum dem::ContactLaw;
    Hash packs, scalar;
    for (const Case& c : {Case{simple, coupled, dem::Damping::combined},
                          Case{simple, uncoupled, dem::Damping::local},
                          Case{standard, coupled, dem::Damping::combined}})
        add_case(c, packs, scalar);
    std::printf("packs  %016llx  %d lanes\n", static_cast<unsigned long long>(packs.value()),
                dem::lanes<dem::Pack>);
    std::printf("scalar %016llx\n", static_cast<unsigned long long>(scalar.value()));
    Hash rubble_packs, rubble_scalar;
    add_rubble(rubble_packs, rubble_scalar);
    add_many_stones(rubble_packs, rubble_scalar);
    add_closing(rubble_packs, rubble_scalar);
    std::printf("rubble %016llx\n", static_cast<unsigned long long>(rubble_packs.value()));
    const bool same =
        packs.value() == scalar.value() && rubble_packs.value() == rubble_scalar.value();
    return same ? 0 : 1;
} catch (const std::exception& e) {
    std::fprintf(stderr, "curve_hash: %s\n", e.what());
    return 1;
}
