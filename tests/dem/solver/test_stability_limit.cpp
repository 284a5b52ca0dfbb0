#include "dem/block/model.hpp"
#include "dem/solver/static_start.hpp"
#include "dem/solver/step/stability_limit.hpp"
#include "dem/solver/step/step.hpp"
#include "scenes/paper_wall.hpp"
#include "tests/dem/eigenvalues.hpp"

#include <catch2/catch.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

dem::Discretisation with_modes(int block_modes)
{
    dem::Discretisation d;
    d.contact_points = 3;
    d.block_modes = block_modes;
    return d;
}

scenes::Scene small_wall()
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.wall.courses = 3;
    s.wall.length = 0.5;
    s.loads.height = 0.35;
    return s;
}

/// Every joint and crack with its own stiffness, over `decades` decades about the scene's.
dem::WallMaterials random_stiffness(const scenes::Scene& s, const dem::Model& m, double decades,
                                    unsigned seed)
{
    std::mt19937_64 random(seed);
    const auto factor = [&] {
        return std::pow(10.0, decades * (static_cast<double>(random()) * 0x1p-64 - 0.5));
    };
    dem::WallMaterials w = scenes::uniform(s, m);
    const auto change = [&](auto& material) {
        material.kn *= factor();
        material.ks *= factor();
    };
    std::for_each(w.joints.begin(), w.joints.end(), change);
    std::for_each(w.cracks.begin(), w.cracks.end(), change);
    change(w.base_joint);
    change(w.beam_joint);
    w.stone.young_modulus *= factor();
    return w;
}

/// Largest eigenvalue of M^-1 K, from the model alone.
double dense_eigenvalue(const dem::Model& m, const dem::WallMaterials& w,
                        const dem::WallState<double>& s)
{
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(m.n_modes, m.n_modes);
    for (int i = 0; i < m.n_modes; ++i) k(i, i) = s.laws.elasticity[i];
    const auto add = [&](const dem::Contact& c, double kn, double ks) {
        Eigen::MatrixXd du = Eigen::MatrixXd::Zero(2, m.n_modes);
        const dem::Face& f = m.layout.faces[c.face];
        for (const auto& [block, point, sign] :
             {std::tuple{f.a, c.a, -1.0}, std::tuple{f.b, c.b, 1.0}}) {
            if (block == dem::kGround) continue;
            const dem::BlockPlace& place = m.places[block];
            const Eigen::MatrixXd& phi = m.elements[place.element].phi;
            const int row = 2 * (point - place.first_point);
            const auto x = phi.row(row), z = phi.row(row + 1);
            du.row(0).segment(place.first_mode, phi.cols()) += sign * (c.nx * x + c.nz * z);
            du.row(1).segment(place.first_mode, phi.cols()) += sign * (c.nz * x - c.nx * z);
        }
        k += c.area *
             (kn * du.row(0).transpose() * du.row(0) + ks * du.row(1).transpose() * du.row(1));
    };
    for (const auto* list : {&m.dry, &m.tied})
        for (const dem::Contact& c : *list) {
            const dem::JointMaterial& j = c.material == dem::kBaseMaterial ? w.base_joint
                                          : c.material == dem::kBeamMaterial
                                              ? w.beam_joint
                                              : w.joints[c.material];
            add(c, j.kn, j.ks);
        }
    for (const dem::Contact& c : m.cracks)
        add(c, w.cracks[c.material].kn, w.cracks[c.material].ks);
    const Eigen::VectorXd root =
        Eigen::Map<const Eigen::VectorXd>(s.laws.inv_mass.data(), m.n_modes).cwiseSqrt();
    return eigenvalues(root.asDiagonal() * k * root.asDiagonal()).maxCoeff();
}

/// Energy residual of a wall that gets a small random push under its vertical load and is left
/// alone.
double residual_after(int steps, const dem::Model& m, const dem::WallMaterials& w,
                      const dem::SolverOptions& o)
{
    const dem::StepTables t = dem::step_tables(m);
    dem::WallState<double> s = dem::unloaded<double>(m, t, {&w, 1}, o);
    REQUIRE(dem::solve_preload(t, s));
    std::mt19937_64 random(1);
    for (double& v : s.v) v = 1e-6 * (static_cast<double>(random()) * 0x1p-64 - 0.5);
    for (int i = 0; i < steps; ++i) dem::step<double>(t, o, {}, s);
    return std::abs(dem::energy_of(t, s, 0).residual());
}

/// Options whose step is `fraction` of the measured limit of the wall.
dem::SolverOptions at_fraction_of_limit(const dem::Model& m, const dem::WallMaterials& w,
                                        dem::SolverOptions o, double fraction)
{
    o.step_fraction = 1.0;
    o.step_fraction = fraction / dem::step_over_limit(m, w, o);
    return o;
}

/// A rigid block fixed to the ground under a rigid beam that can only go up and down.
scenes::Scene one_degree_of_freedom()
{
    scenes::Scene s = scenes::monolith(0.2, 0.1, 0.5e6, 1e10);
    s.wall.base = dem::Base::fixed;
    s.beam.rotation = dem::BeamRotation::fixed;
    return s;
}

} // namespace

TEST_CASE("stability limit: the largest eigenvalue is that of the dense matrix",
          "[dem][stability_limit]")
{
    scenes::Scene s = small_wall();
    s.wall.base = GENERATE(dem::Base::fixed, dem::Base::joint);
    const dem::Model m = scenes::model_of(s, with_modes(GENERATE(3, 12)));
    const dem::WallMaterials w = random_stiffness(s, m, GENERATE(0.0, 3.0), 7);
    const dem::SolverOptions o;
    const dem::StepTables t = dem::step_tables(m);
    dem::WallState<double> state = dem::unloaded<double>(m, t, {&w, 1}, o);
    const double dense = std::sqrt(dense_eigenvalue(m, w, state));
    const double found = dem::largest_frequency(t, state);
    CHECK(found == Approx(dense).epsilon(1e-3));
    CHECK(found <= dense * (1.0 + 1e-9));
    CHECK(dem::step_over_limit(m, w, o) == 0.5 * std::sqrt(1.0 + o.damping_factor) * found);
    CHECK(
        std::all_of(state.stress.begin(), state.stress.end(), [](double x) { return x == 0; }));
}

TEST_CASE("stability limit: one degree of freedom has the frequency worked out by hand",
          "[dem][stability_limit]")
{
    // k = 1 (phi^T C phi = 1 and the block does not move), m = (0 + 2)/4 (1 + gamma)/f^2.
    const scenes::Scene s = one_degree_of_freedom();
    dem::Discretisation d = with_modes(3);
    d.beam_modes = 3;
    const dem::Model m = scenes::model_of(s, d);
    REQUIRE(m.n_modes == 1);
    dem::SolverOptions o;
    o.step_fraction = 0.7;
    CHECK(dem::step_over_limit(m, scenes::uniform(s, m), o) ==
          Approx(0.7 / std::sqrt(2.0)).epsilon(1e-9));
}

TEST_CASE(
    "stability limit: a step at the proven bound is never above it, whatever the stiffness",
    "[dem][stability_limit]")
{
    scenes::Scene s = small_wall();
    s.wall.base = GENERATE(dem::Base::fixed, dem::Base::joint);
    s.wall.bond_offset = GENERATE(0.5, 0.3);
    s.beam.rotation = GENERATE(dem::BeamRotation::free, dem::BeamRotation::fixed);
    const dem::Model m = scenes::model_of(s, with_modes(GENERATE(3, 6, 0)));
    dem::SolverOptions o;
    o.step_fraction = 1.0;
    for (unsigned seed = 0; seed < 5; ++seed)
        for (const double decades : {0.1, 1.0, 4.0})
            CHECK(dem::step_over_limit(m, random_stiffness(s, m, decades, seed), o) <=
                  1.0 + 1e-12);
}

TEST_CASE("stability limit: the bound is sharp within 1 % for the wall of the paper",
          "[dem][stability_limit]")
{
    const scenes::Scene s = scenes::paper_wall(0.50);
    const dem::Model m = scenes::model_of(
        s, dem::discretisation_of(GENERATE(dem::Fidelity::rigid, dem::Fidelity::standard)));
    const dem::SolverOptions o;
    for (const dem::WallMaterials& w : {scenes::uniform(s, m), scenes::table5_sample(s, m, 1),
                                        scenes::table5_sample(s, m, 2)})
        CHECK(dem::step_over_limit(m, w, o) > 0.99 * o.step_fraction);
}

TEST_CASE("stability limit: just below it a damped wall stays quiet, just above it blows up",
          "[dem][stability_limit]")
{
    const bool one = GENERATE(true, false);
    const scenes::Scene s = one ? one_degree_of_freedom() : small_wall();
    dem::Discretisation d = with_modes(3);
    if (one) d.beam_modes = 3;
    const dem::Model m = scenes::model_of(s, d);
    const dem::WallMaterials w = scenes::uniform(s, m);
    dem::SolverOptions o;
    o.damping = GENERATE(dem::Damping::combined, dem::Damping::local);
    o.damping_factor = GENERATE(0.0, 0.5, 0.8);
    CHECK(residual_after(2000, m, w, at_fraction_of_limit(m, w, o, 0.998)) < 0.01);
    CHECK(!(residual_after(2000, m, w, at_fraction_of_limit(m, w, o, 1.002)) < 0.01));
}
