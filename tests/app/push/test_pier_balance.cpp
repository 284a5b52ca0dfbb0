/// Hand checks of piers: shear and axial force of each against the equilibrium of cuts.

#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "app/study/pushed/wall_openings.hpp"
#include "dem/scene/geometry/polygon.hpp"
#include "tests/app/push_scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using app::Study;

/// The farmhouse of the trial: a door, a window, random lengths, mortar.
constexpr const char* kHouse = R"([wall]
length = 3.0 m
courses = 9
course_height = 0.30 m
unit_length = 0.6 m
unit_length_cov = 0.15
thickness = 0.5 m
base = joint
toe = free
openings = 0.3 m, 0 m, 0.9 m, 2.1 m; 1.8 m, 0.9 m, 0.8 m, 1.2 m
[lintel]
young_modulus = 10 GPa
density = 600 kg/m3
[stone]
young_modulus = 15.5 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
wall_modulus = 1200 MPa
friction_angle = 31 deg
cohesion = 0.05 MPa
tensile_strength = 0.05 MPa
fracture_energy = 10 N/m
[unit]
tensile_strength = 3.7 MPa
fracture_energy = 110 N/m
friction_angle = 35 deg
[beam]
height = 0.2 m
young_modulus = 30 GPa
density = 2500 kg/m3
[load]
vertical_stress = 0.20 MPa
max_displacement = 60 mm
[fragility]
limit_states = paper, ntc, ec8
[solver]
fidelity = simple
)";

/// A wall pushed, with its snapshots at all curve points.
struct Pushed {
    app::PushedWall wall;
    std::vector<dem::Snapshot> shots;
};

Pushed pushed(const Study& study)
{
    dem::PushPlan plan = app::push_plan(study);
    plan.snapshot_every = plan.record_every; // handed on by those who watch the piers
    Pushed p{scenes::pushed(study, plan), {}};
    p.shots = p.wall.result.snapshots;
    return p;
}

/// Levels of bed joints within a pier.
std::vector<double> levels_of(const dem::Layout& layout, const dem::Region& pier)
{
    std::set<double> levels;
    constexpr double kInside = 1e-3; // [m]
    for (const dem::Block& b : layout.blocks) {
        const dem::Point middle = dem::centre_of(b);
        if (middle.x > pier.x0 && middle.x < pier.x1 && b.z1 > pier.z0 + kInside &&
            b.z1 < pier.z1 - kInside)
            levels.insert(std::round(b.z1 * 1e6) * 1e-6);
    }
    return {levels.begin(), levels.end()};
}

/// One pier, cut at each of its bed joints.
struct CutPier {
    dem::PierProbe probe;
    std::vector<double> weight; ///< of the pier above each cut [N]
};

std::vector<CutPier> cut_piers(const Study& study, const dem::Layout& layout,
                               const dem::Piers& piers)
{
    std::vector<CutPier> all;
    for (const dem::Pier& p : piers.piers) {
        dem::Piers cuts;
        std::vector<double> weight;
        for (const double z : levels_of(layout, p.at)) {
            cuts.piers.push_back({p.at, z, p.storey});
            weight.push_back(0.0);
            for (const dem::Block& b : layout.blocks) {
                const dem::Point middle = dem::centre_of(b);
                if (middle.x > p.at.x0 && middle.x < p.at.x1 && middle.z > z &&
                    middle.z < p.at.z1)
                    weight.back() += area_of(b) * layout.thickness * study.load.gravity *
                                     study.parameters.stone.density;
            }
        }
        REQUIRE(cuts.piers.size() >= 2);
        all.push_back({dem::PierProbe(layout, cuts), weight});
    }
    return all;
}

/// Largest misses at one moment, as shares of the largest shear, and of the largest axial
/// force, that the pier has there in any cut, or of 5 % of the wall's where that is more. Those
/// of a pier that never carries so much are shares of the wall's: it governs nothing.
struct Misses {
    double shear = 0.0, normal = 0.0;
};

Misses misses_of(const app::PierInstant& cuts, const std::vector<double>& weight, bool carries,
                 double wall_shear, double wall_normal)
{
    const double least = carries ? 0.05 : 1.0;
    std::vector<double> shear, normal;
    for (std::size_t c = 0; c < weight.size(); ++c) {
        shear.push_back(cuts.piers[c].force.shear);
        normal.push_back(cuts.piers[c].force.normal - weight[c]);
    }
    const auto spread = [](const std::vector<double>& v, double at_least) {
        const auto [low, high] = std::ranges::minmax(v);
        return (high - low) / std::max({std::abs(low), std::abs(high), at_least});
    };
    return {spread(shear, least * wall_shear), spread(normal, least * wall_normal)};
}

/// Forces as piers are read with.
app::PierHistory calm_history(const Study& study, const dem::PierProbe& probe,
                              const std::vector<dem::Snapshot>& shots)
{
    app::PierHistory history;
    for (const dem::Snapshot& shot : shots) history.push_back(app::pier_instant(probe, shot));
    return app::calmed(history, app::kCalm * study.load.height);
}

/// Where each limit state of the wall, and of each pier, is reached [m].
std::vector<double> moments_of(const app::PushedWall& w)
{
    std::vector<double> at;
    for (const auto& limit : w.reading.limits)
        if (is_observed(limit)) at.push_back(limit.displacement);
    for (const app::PierReading& p : w.piers)
        for (const app::PierCap& cap : p.caps)
            if (is_observed(cap.wall)) at.push_back(cap.wall.displacement);
    return at;
}

void check_cuts(const Study& study)
{
    const Pushed p = pushed(study);
    REQUIRE(p.shots.size() > 100);
    const dem::Layout layout = layout_of(study, study.source);
    const dem::PierProbe probe(layout,
                               dem::piers_of(app::wall_openings(study), wall_extent(study)));
    const std::vector<CutPier> piers = cut_piers(study, layout, probe.piers());
    const app::PierHistory whole = calm_history(study, probe, p.shots);
    std::vector<app::PierHistory> cuts;
    for (const CutPier& pier : piers) cuts.push_back(calm_history(study, pier.probe, p.shots));
    double wall_shear = 0.0, wall_normal = 0.0;
    for (const app::PierInstant& now : whole)
        wall_shear = std::max(wall_shear, std::abs(now.base_shear));
    for (const dem::PierState& pier : whole.front().piers) wall_normal += pier.force.normal;

    const auto check = [&](std::size_t k, const char* what) {
        double shear = 0.0, normal = 0.0;
        for (std::size_t i = 0; i < piers.size(); ++i) {
            INFO(what << ", " << 1e3 * whole[k].displacement << " mm, pier " << i + 1);
            const Misses m = misses_of(cuts[i][k], piers[i].weight, p.wall.piers[i].carries,
                                       wall_shear, wall_normal);
            CHECK(m.shear < 0.005);
            CHECK(m.normal < 0.005);
            shear += whole[k].piers[i].force.shear;
            normal += whole[k].piers[i].force.normal;
        }
        INFO(what << ", " << 1e3 * whole[k].displacement << " mm");
        CHECK(std::abs(shear - whole[k].base_shear) < 0.005 * wall_shear);
        CHECK(std::abs(normal - wall_normal) < 0.005 * wall_normal);
    };
    const auto peak = std::ranges::max_element(
        whole, {}, [](const app::PierInstant& now) { return std::abs(now.force); });
    check(static_cast<std::size_t>(peak - whole.begin()), "peak");
    const double way = push_way(study.load).direction;
    for (std::size_t i = 0; i < piers.size(); ++i) {
        CHECK(p.wall.piers.at(i).facts.normal_at_peak == peak->piers[i].force.normal);
        CHECK(p.wall.piers.at(i).facts.shear_at_peak == way * peak->piers[i].force.shear);
    }
    for (const double at : moments_of(p.wall)) {
        const auto now = std::ranges::min_element(whole, {}, [&](const app::PierInstant& x) {
            return std::abs(std::abs(x.displacement) - at);
        });
        check(static_cast<std::size_t>(now - whole.begin()), "limit state");
    }
}

Study read(const std::string& name, std::vector<std::string> overrides)
{
    const std::string facade = std::string(DRYSTONE_SOURCE_DIR) + "/configs/facade.ini";
    const app::StudyFile file = name == "house" ? app::parse_study_text("house.ini", kHouse)
                                                : app::read_study_file(facade);
    return app::read_study(app::with_overrides(file, overrides));
}

} // namespace

TEST_CASE(
    "pier balance: at the peak and at every limit state, shear and axial force of each pier "
    "of the farmhouse are those of every cut through it within 0.5 %",
    "[slow][app][pier_balance]")
{
    check_cuts(read("house", {std::string("load.direction=") + GENERATE("right", "left")}));
}

TEST_CASE("pier balance: so are those of configs/facade.ini", "[slow][app][pier_balance]")
{
    check_cuts(read("facade", {std::string("load.direction=") + GENERATE("right", "left"),
                               "fragility.limit_states=paper, ntc, ec8"}));
}
