#include "dem/solver/push.hpp"
#include "tests/dem/eigenvalues.hpp"
#include "tests/dem/model_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

using dem::Contact;
using dem::FaceRule;
using dem::Model;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using model_scenes::coarse;
using model_scenes::for_each_contact;
using model_scenes::small_wall;

/// Displacement of a point for unit modes, 2 x modes of the wall.
MatrixXd motion_of(const Model& m, int point)
{
    MatrixXd u = MatrixXd::Zero(2, m.n_modes);
    for (const dem::BlockPlace& place : m.places) {
        const dem::BlockElement& e = m.elements[place.element];
        const int i = point - place.first_point;
        if (i >= 0 && i < static_cast<int>(e.points.size()))
            u.middleCols(place.first_mode, e.phi.cols()) = e.phi.middleRows<2>(2 * i);
    }
    return u; // of the ground: zero
}

VectorXd lambda_of(const Model& m)
{
    VectorXd lambda(m.n_modes);
    for (const dem::BlockPlace& place : m.places) {
        const VectorXd& l = m.elements[place.element].lambda;
        lambda.segment(place.first_mode, l.size()) = l;
    }
    return lambda;
}

/// Elasticity of the blocks and of all contacts, none open, none sliding: modes x modes.
MatrixXd bonded_stiffness(const Model& m, const scenes::Scene& s)
{
    MatrixXd k = lambda_of(m).asDiagonal();
    for_each_contact(m, [&](const Contact& c, bool is_crack) {
        const MatrixXd u = motion_of(m, c.b) - motion_of(m, c.a);
        const Eigen::RowVectorXd normal = c.nx * u.row(0) + c.nz * u.row(1),
                                 shear = c.nz * u.row(0) - c.nx * u.row(1);
        const double kn = is_crack ? s.crack.kn : s.joint.kn,
                     ks = is_crack ? s.crack.ks : s.joint.ks;
        k += c.area * (kn * normal.transpose() * normal + ks * shear.transpose() * shear);
    });
    return k;
}

/// The wall at rest under its vertical load.
dem::Snapshot loaded(const scenes::Scene& s, const dem::Discretisation& d)
{
    const Model m = scenes::model_of(s, d);
    dem::SolverOptions options;
    options.preload_steps = 4000;
    options.preload_unbalance = 0.0; // all of them
    options.steps_per_mm = 1;
    options.unbalance_limit = 0.0;
    dem::PushPlan plan;
    plan.targets = {1e-9};
    plan.snapshot_every = 1.0; // one, before the push
    return dem::push(m, scenes::uniform(s, m), plan, options).snapshots.front();
}

} // namespace

TEST_CASE("model: no motion of a bonded wall is faster than the step allows",
          "[dem][model][repeats]")
{
    // Largest eigenvalue of M^-1 K with M = (lambda + 2)/4: at most 4, where a unit step of the
    // leapfrog is just stable.
    scenes::Scene s = small_wall();
    s.wall.base = GENERATE(dem::Base::fixed, dem::Base::joint);
    s.wall.toe = GENERATE(dem::Toe::held, dem::Toe::free);
    s.wall.bond_offset = GENERATE(0.5, 0.25);
    const Model m = scenes::model_of(
        s, coarse(GENERATE(0, 6), GENERATE(FaceRule::even, FaceRule::lobatto)));
    const VectorXd inv_root_mass = (0.25 * (lambda_of(m).array() + 2.0)).rsqrt();
    const MatrixXd scaled =
        inv_root_mass.asDiagonal() * bonded_stiffness(m, s) * inv_root_mass.asDiagonal();
    const double fastest = eigenvalues(scaled)(m.n_modes - 1);
    CHECK(fastest <= 4.0 * (1 + 1e-12));
    CHECK(fastest > 3.9); // and no mass is there in vain
}

TEST_CASE("model: blocks and joints pass a uniform stress on exactly, whatever their mesh",
          "[dem][model]")
{
    // Problem 7. Without Poisson's ratio and self-weight every contact carries the vertical
    // stress and no shear.
    const auto [base, modes, rule, bond] = GENERATE(table<dem::Base, int, FaceRule, double>(
        {{dem::Base::joint, 6, FaceRule::even, 0.5},
         {dem::Base::joint, 6, FaceRule::lobatto, 0.5},
         {dem::Base::joint, 6, FaceRule::even, 0.25},
         {dem::Base::joint, 0, FaceRule::even, 0.25},
         {dem::Base::joint, 0, FaceRule::lobatto, 0.5},
         {dem::Base::fixed, 6, FaceRule::even, 0.25},
         {dem::Base::fixed, 6, FaceRule::lobatto, 0.5},
         {dem::Base::fixed, 0, FaceRule::even, 0.25},
         {dem::Base::fixed, 0, FaceRule::lobatto, 0.5}}));
    scenes::Scene s = small_wall();
    s.wall.base = base;
    s.wall.bond_offset = bond;
    s.wall.toe = dem::Toe::free;
    s.stone.poisson_ratio = s.beam.material.poisson_ratio = 0.0;
    s.loads.gravity = 0.0;
    const dem::Snapshot wall = loaded(s, coarse(modes, rule));
    for (const dem::FaceState& f : wall.faces)
        for (const dem::ContactState& c : f.contacts) {
            const double expected = f.normal.z == 1.0 ? -s.loads.vertical_stress : 0.0;
            CHECK(std::abs(c.sigma - expected) < 1e-10 * s.loads.vertical_stress);
            CHECK(std::abs(c.tau) < 1e-10 * s.loads.vertical_stress);
        }
}
