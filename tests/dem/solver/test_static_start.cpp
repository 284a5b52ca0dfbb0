#include "dem/block/model.hpp"
#include "dem/solver/static_start.hpp"
#include "dem/solver/step/step.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <Eigen/Dense>

#include <cmath>
#include <limits>
#include <vector>

namespace {

using dem::Model;
using dem::StepTables;
using dem::WallMaterials;
using dem::WallState;
using Eigen::MatrixXd;
using Eigen::VectorXd;

WallState<double> unloaded(const Model& m, const StepTables& t, const WallMaterials& w)
{
    return dem::unloaded<double>(m, t, {&w, 1}, {});
}

/// Adds area k b b^T of a list of contacts to the stiffness of all modes, from the model
/// itself.
template <class Stiffness>
void add_contacts(const Model& m, const std::vector<dem::Contact>& contacts,
                  Stiffness stiffness_of, MatrixXd& k)
{
    for (const dem::Contact& c : contacts) {
        const dem::Face& f = m.layout.faces[c.face];
        VectorXd normal = VectorXd::Zero(m.n_modes), tangential = normal;
        const auto add = [&](int block, int point, double side) {
            if (block == dem::kGround) return;
            const dem::BlockPlace& place = m.places[block];
            const MatrixXd& phi = m.elements[place.element].phi;
            const int row = 2 * (point - place.first_point);
            const auto modes = Eigen::seqN(place.first_mode, phi.cols());
            normal(modes) += side * (c.nx * phi.row(row) + c.nz * phi.row(row + 1));
            tangential(modes) += side * (c.nz * phi.row(row) - c.nx * phi.row(row + 1));
        };
        add(f.a, c.a, -1.0);
        add(f.b, c.b, 1.0);
        const auto [kn, ks] = stiffness_of(c.material);
        k += c.area *
             (kn * normal * normal.transpose() + ks * tangential * tangential.transpose());
    }
}

/// Stiffness of blocks and contacts, all closed, sticking and whole.
MatrixXd stiffness(const Model& m, const WallMaterials& w, const WallState<double>& s)
{
    MatrixXd k = Eigen::Map<const VectorXd>(s.laws.elasticity.data(), m.n_modes).asDiagonal();
    const auto joint = [&](int material) {
        const dem::JointMaterial& j = material == dem::kBaseMaterial   ? w.base_joint
                                      : material == dem::kBeamMaterial ? w.beam_joint
                                                                       : w.joints[material];
        return std::pair{j.kn, j.ks};
    };
    const auto crack = [&](int material) {
        return std::pair{w.cracks[material].kn, w.cracks[material].ks};
    };
    add_contacts(m, m.dry, joint, k);
    add_contacts(m, m.tied, joint, k);
    add_contacts(m, m.cracks, crack, k);
    return k;
}

/// Every contact with its own stiffness.
WallMaterials varied(const scenes::Scene& s, const Model& m)
{
    WallMaterials w = scenes::table5_sample(s, m, 3);
    w.stone.young_modulus *= 1.3;
    w.stone.density *= 1.1;
    for (std::size_t i = 0; i < w.joints.size(); ++i) {
        w.joints[i].kn *= 1.0 + 0.01 * static_cast<double>(i);
        w.joints[i].ks *= 1.0 + 0.02 * static_cast<double>(i);
    }
    for (std::size_t i = 0; i < w.cracks.size(); ++i)
        w.cracks[i].kn *= 1.0 + 0.03 * static_cast<double>(i);
    w.base_joint.kn *= 0.7;
    w.beam_joint.ks *= 1.4;
    return w;
}

std::vector<scenes::Scene> walls()
{
    std::vector<scenes::Scene> all{small_wall::scene(0.15), small_wall::scene(0.75, 4),
                                   small_wall::scene(1.25), small_wall::scene(0.75)};
    all[1].wall.base = dem::Base::joint;
    all[2].wall.base = dem::Base::joint;
    all[2].wall.toe = dem::Toe::free;
    all[2].beam.interface = dem::BeamInterface::joint;
    all[3].loads.vertical_stress = 0.0; // self-weight alone
    return all;
}

bool same(const std::vector<double>& a, const std::vector<double>& b)
{
    bool all = a.size() == b.size();
    for (std::size_t i = 0; all && i < a.size(); ++i) all = bits::same(a[i], b[i]);
    return all;
}

} // namespace

TEST_CASE("static start: is the linear solution of the closed, sticking, uncracked wall",
          "[dem][static_start]")
{
    for (const scenes::Scene& scene : walls()) {
        const Model m = small_wall::model(scene);
        const StepTables t = dem::step_tables(m);
        const WallMaterials w = varied(scene, m);
        WallState<double> s = unloaded(m, t, w);
        REQUIRE(solve_preload(t, s));
        const MatrixXd k = stiffness(m, w, s);
        const VectorXd load = Eigen::Map<const VectorXd>(s.laws.load.data(), m.n_modes);
        const VectorXd exact = k.ldlt().solve(load);
        const VectorXd error = Eigen::Map<const VectorXd>(s.q.data(), m.n_modes) - exact;
        REQUIRE(load.norm() > 0.0);
        CHECK(std::sqrt(error.dot(k * error) / exact.dot(k * exact)) < 1e-7);
    }
}

TEST_CASE("static start: stresses are those of the openings, within what the laws allow",
          "[dem][static_start]")
{
    int cut = 0;
    for (const scenes::Scene& scene : walls()) {
        const Model m = small_wall::model(scene);
        const StepTables t = dem::step_tables(m);
        WallMaterials w = varied(scene, m);
        for (dem::JointMaterial& j : w.joints) j.tan_phi *= 0.1; // slippery: some must slide
        WallState<double> s = unloaded(m, t, w);
        REQUIRE(solve_preload(t, s));
        for (const dem::ContactRun& run : t.dry)
            for (int k = run.first; k < run.first + run.count; ++k) {
                const double sigma = s.stress[2 * k], tau = s.stress[2 * k + 1];
                const auto& law = s.laws.dry[run.law];
                REQUIRE(bits::same(sigma, dem::dry_stress(law, s.u_n[k])));
                REQUIRE(std::abs(tau) <= -sigma * law.tan_phi);
                cut += std::abs(tau) == -sigma * law.tan_phi;
            }
        for (const dem::ContactRun& run : t.tied)
            for (int k = run.first; k < run.first + run.count; ++k)
                REQUIRE(s.stress[2 * k] == s.laws.tied[run.law].kn * s.u_n[k]);
        for (const dem::ContactRun& run : t.cracks)
            for (int k = run.first; k < run.first + run.count; ++k)
                REQUIRE(s.stress[2 * k] == s.laws.cracks[run.law].kn * s.u_n[k]);
        for (const double du : s.du) REQUIRE(du == 0.0); // ready for a step
    }
    CHECK(cut > 20);
}

TEST_CASE("static start: the wall rests within 100 steps, and its ledger stays closed",
          "[dem][static_start]")
{
    for (const scenes::Scene& scene : walls()) {
        const Model m = small_wall::model(scene);
        const StepTables t = dem::step_tables(m);
        WallState<double> s = unloaded(m, t, scenes::table5_sample(scene, m, 3));
        REQUIRE(solve_preload(t, s));
        const dem::Energy start = energy_of(t, s, 0);
        CHECK(start.work == start.elastic);
        CHECK(start.work > 0.0);
        CHECK(start.residual() == 0.0);
        for (int i = 0; i < 100; ++i) dem::step<double>(t, {}, {1.0, 0.0}, s);
        CHECK(dem::unbalanced_ratio(s, 0) < 1e-4);
        CHECK(std::abs(energy_of(t, s, 0).residual()) < 1e-9);
        CHECK(energy_of(t, s, 0).elastic == Approx(start.elastic).epsilon(1e-3));
    }
}

TEST_CASE("static start: settlement and peak are those of the load brought on by a ramp",
          "[dem][static_start]")
{
    for (const scenes::Scene& scene :
         {small_wall::scene(0.15, 4), small_wall::scene(0.75, 4), small_wall::scene(1.25, 4)}) {
        const Model m = small_wall::model(scene);
        const WallMaterials w = scenes::table5_sample(scene, m, 0);
        dem::SolverOptions o;
        o.preload_unbalance = 1e-6;
        const dem::PushResult solved = dem::push(m, w, small_wall::to(0.004), o);
        o.preload = dem::Preload::ramped;
        const dem::PushResult ramped = dem::push(m, w, small_wall::to(0.004), o);
        REQUIRE(solved.settled);
        REQUIRE(ramped.settled);
        CHECK(solved.settlement == Approx(ramped.settlement).epsilon(1e-5));
        CHECK(scenes::peak_force(solved) == Approx(scenes::peak_force(ramped)).epsilon(2e-3));
    }
}

TEST_CASE("static start: a wall that cannot be solved is left unloaded", "[dem][static_start]")
{
    const Model m = small_wall::model();
    const StepTables t = dem::step_tables(m);
    WallMaterials w = scenes::uniform(small_wall::scene(), m);
    const double infinite = std::numeric_limits<double>::infinity();
    SECTION("a joint without end to its stiffness") { w.joints[4].kn = infinite; }
    SECTION("a crack") { w.cracks[2].ks = infinite; }
    SECTION("the beam's joint") { w.beam_joint.kn = infinite; }
    SECTION("a beam on next to nothing") { w.beam_joint.kn = 1e-300; }
    WallState<double> s = unloaded(m, t, w);
    const WallState<double> before = s;
    CHECK_FALSE(solve_preload(t, s));
    CHECK(same(s.q, before.q));
    CHECK(same(s.v, before.v));
    CHECK(same(s.u_n, before.u_n));
    CHECK(same(s.stress, before.stress));
    CHECK(same(s.du, before.du));
    CHECK(same(s.laws.load, before.laws.load));
    CHECK(s.work == 0.0);
}

TEST_CASE("static start: a wall without load is solved at zero", "[dem][static_start]")
{
    scenes::Scene scene = small_wall::scene();
    scene.loads = {0.0, scene.loads.height, 0.0};
    const Model m = small_wall::model(scene);
    const StepTables t = dem::step_tables(m);
    WallState<double> s = unloaded(m, t, scenes::uniform(scene, m));
    CHECK(solve_preload(t, s));
    for (const double q : s.q) REQUIRE(q == 0.0);
    CHECK(s.work == 0.0);
}

TEST_CASE(
    "static start: copied into a lane, the wall is there and its neighbours are as before",
    "[dem][static_start][pack]")
{
    const scenes::Scene scene = small_wall::scene();
    const Model m = small_wall::model(scene);
    const StepTables t = dem::step_tables(m);
    const WallMaterials w = varied(scene, m);
    WallState<double> one = unloaded(m, t, w);
    REQUIRE(solve_preload(t, one));
    for (int lane = 0; lane < dem::lanes<dem::Pack>; ++lane) {
        auto pack = dem::unloaded<dem::Pack>(m, t, {&w, 1}, {});
        dem::copy_to_lane(one, lane, pack);
        const auto check = [&](const std::vector<double>& alone, const auto& together) {
            for (std::size_t k = 0; k < alone.size(); ++k)
                for (int i = 0; i < dem::lanes<dem::Pack>; ++i)
                    REQUIRE(bits::same(together[k][i], i == lane ? alone[k] : 0.0));
        };
        check(one.q, pack.q);
        check(one.u_n, pack.u_n);
        check(one.stress, pack.stress);
        check({one.work}, std::vector{pack.work});
    }
}
