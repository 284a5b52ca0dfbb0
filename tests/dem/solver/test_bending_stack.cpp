#include "dem/block/model.hpp"
#include "dem/solver/push.hpp"
#include "scenes/paper_wall.hpp"

#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <cmath>

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Whole units of 0.5 x 0.25 m, one on the other, on a joint, under a beam of the same stone.
scenes::Scene stack(double kn)
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.wall.length = s.wall.unit_length = 0.5;
    s.wall.courses = 8;
    s.wall.course_height = 0.25;
    s.wall.bond_offset = 0.0;
    s.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    s.wall.base = dem::Base::joint;
    s.wall.toe = dem::Toe::free;
    s.beam.height = 0.1;
    s.beam.material = s.stone;
    s.loads.height = 2.1;
    s.joint.kn = kn;
    s.joint.ks = kn / (2.0 * (1.0 + s.stone.poisson_ratio));
    return s;
}

/// Force for a unit displacement of the load line [N/m]: a cantilever after Timoshenko with a
/// spring in each joint.
double closed_form(const scenes::Scene& s)
{
    const double length = s.wall.length, area = length * s.wall.thickness,
                 inertia = area * length * length / 12.0, lever = s.loads.height;
    const double e = s.stone.young_modulus, g = e / (2.0 * (1.0 + s.stone.poisson_ratio));
    double softness = lever * lever * lever / (3.0 * e * inertia) + 1.2 * lever / (g * area);
    for (int joint = 0; joint <= s.wall.courses; ++joint) {
        const double arm = lever - joint * s.wall.course_height;
        softness += arm * arm / (s.joint.kn * inertia) + 1.0 / (s.joint.ks * area);
    }
    return 1.0 / softness;
}

/// Force of the load line for a unit displacement of it, no joint open, none sliding [N/m].
double stiffness_of(const scenes::Scene& s, const dem::Discretisation& d)
{
    const dem::Model m = scenes::model_of(s, d);
    const Index drive = m.n_modes; // one unknown more: the horizontal motion of the beam
    MatrixXd k = MatrixXd::Zero(drive + 1, drive + 1);
    const auto motion = [&](int point) {
        MatrixXd u = MatrixXd::Zero(2, drive + 1);
        for (std::size_t b = 0; b < m.places.size(); ++b) {
            const dem::BlockPlace& place = m.places[b];
            const dem::BlockElement& e = m.elements[place.element];
            const int i = point - place.first_point;
            if (i < 0 || i >= static_cast<int>(e.points.size())) continue;
            u.middleCols(place.first_mode, e.phi.cols()) = e.phi.middleRows<2>(2 * i);
            if (static_cast<int>(b) == m.layout.beam) u(0, drive) = 1.0;
        }
        return u; // of the ground: zero
    };
    for (const dem::BlockPlace& place : m.places) {
        const VectorXd& lambda = m.elements[place.element].lambda;
        k.diagonal().segment(place.first_mode, lambda.size()) += lambda;
    }
    for (const auto* list : {&m.dry, &m.tied})
        for (const dem::Contact& c : *list) {
            const MatrixXd u = motion(c.b) - motion(c.a);
            const Eigen::RowVectorXd opening = c.nx * u.row(0) + c.nz * u.row(1),
                                     slip = c.nz * u.row(0) - c.nx * u.row(1);
            k += c.area * (s.joint.kn * opening.transpose() * opening +
                           s.joint.ks * slip.transpose() * slip);
        }
    const VectorXd across = k.col(drive).head(drive);
    return k(drive, drive) - across.dot(k.topLeftCorner(drive, drive).ldlt().solve(across));
}

} // namespace

TEST_CASE("bending stack: at the default fidelity a stack of whole units is as stiff as a "
          "cantilever after Timoshenko with springs in its joints",
          "[dem][bending_stack]")
{
    const scenes::Scene s = stack(GENERATE(1e9, 1e10, 3e10, 1e11));
    CHECK(stiffness_of(s, {}) == Approx(closed_form(s)).epsilon(0.02));
}

TEST_CASE("bending stack: the modes kept by default leave out nothing that a stack of whole "
          "units needs",
          "[dem][bending_stack]")
{
    const scenes::Scene s = stack(GENERATE(1e9, 1e10, 3e10, 1e11));
    dem::Discretisation zones;
    zones.block_modes = 0;
    CHECK(stiffness_of(s, {}) == Approx(stiffness_of(s, zones)).epsilon(0.002));
}
