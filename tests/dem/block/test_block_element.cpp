#include "dem/block/block_element.hpp"
#include "dem/block/block_modes.hpp"
#include "dem/block/condensation.hpp"
#include "tests/dem/block_specs.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace block_specs;
using dem::BlockElement;
using dem::BlockSpec;
using dem::Motion;
using dem::Point;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST_CASE("block element: the contact metric is the stiffness of the contacts with their other "
          "side held",
          "[dem][block_element]")
{
    const BlockSpec spec = half_unit(GENERATE(as<Mesh>{}, kEven, kLobatto));
    const dem::Condensed c = dem::condense(spec);
    const MatrixXd metric = dem::contact_metric(spec, c);
    const double w = spec.width, h = spec.height, t = spec.thickness, kn = kJoint,
                 crack = kCrack;
    // Two bed joints, a head joint and a crack, whole faces: work of uniform motions.
    const VectorXd right = linear_field(c.points, {}, {1, 0}),
                   up = linear_field(c.points, {}, {0, 1});
    CHECK(right.dot(metric * right) ==
          Approx(t * (2 * w * kn / 2.4 + h * kn + h * crack)).epsilon(1e-12));
    CHECK(up.dot(metric * up) ==
          Approx(t * (2 * w * kn + h * kn / 2.4 + h * crack / 2.4)).epsilon(1e-12));
    CHECK(std::abs(right.dot(metric * up)) < 1e-12 * up.dot(metric * up));
}

TEST_CASE("block element: rigid motions of a floating block are modes without any elasticity",
          "[dem][block_element]")
{
    const Mesh mesh = GENERATE(as<Mesh>{}, kEven, kLobatto);
    const int modes = GENERATE(0, 3, 6, 12);
    for (const BlockSpec& spec : floating(mesh)) {
        const BlockElement e = dem::block_element(with_modes(spec, modes));
        const MatrixXd metric = dem::contact_metric(spec, dem::condense(spec));
        for (int i = 0; i < 3; ++i) CHECK(e.lambda(i) == 0.0);
        if (modes == 3) CHECK(e.phi.cols() == 3);
        for (Index i = 3; i < e.lambda.size(); ++i) CHECK(e.lambda(i) > 1e-3);
        for (const VectorXd& u :
             {linear_field(e.points, {}, {1, 0}), linear_field(e.points, {}, {0, 1}),
              linear_field(e.points, {}, {}, {0, 1}, {-1, 0})})
            CHECK(largest(followed(e, metric, u) - u) < 1e-12 * largest(u));
    }
}

TEST_CASE("block element: a driven beam lifts, and turns about its load line unless it is held",
          "[dem][block_element]")
{
    const int modes = GENERATE(0, 3, 6, 15);
    const bool fixed = GENERATE(false, true);
    BlockSpec spec = with_modes(beam(kEven, fixed), modes);
    spec.load_height = GENERATE(0.0, 0.03, kHeight);
    const BlockElement e = dem::block_element(spec);
    const MatrixXd metric = dem::contact_metric(spec, dem::condense(spec));
    const VectorXd up = linear_field(e.points, {}, {0, 1});
    const VectorXd turn =
        linear_field(e.points, {0.5 * spec.width, spec.load_height}, {}, {0, -1}, {1, 0});
    CHECK(largest(followed(e, metric, up) - up) < 1e-12);
    if (!fixed) CHECK(largest(followed(e, metric, turn) - turn) < 1e-12 * largest(turn));

    const int rigid = fixed ? 1 : 2;
    for (int i = 0; i < rigid; ++i) CHECK(e.lambda(i) == 0.0);
    if (modes > 3) CHECK(e.lambda(rigid) > 1e-6);
    if (modes > 0) CHECK(e.phi.cols() == modes - 3 + rigid);
    if (modes == 0) CHECK(e.phi.cols() == e.phi.rows() - 3 + rigid);
    if (fixed) // nothing turns, not even in part
        for (Index i = 0; i < rigid; ++i)
            CHECK(largest(e.phi.col(i) - e.phi(1, i) * up) < 1e-12 * largest(e.phi));
}

TEST_CASE("block element: supported points do not move", "[dem][block_element]")
{
    const int modes = GENERATE(0, 6, 12);
    const Mesh mesh = GENERATE(as<Mesh>{}, kEven, kLobatto);
    const BlockSpec spec =
        with_modes(supported(GENERATE(Motion::clamped_bottom, Motion::clamped_bottom_held_right,
                                      Motion::held_right_corner),
                             mesh),
                   modes);
    const dem::Condensed c = dem::condense(spec);
    const BlockElement e = dem::block_element(spec);
    for (Index row = 0; row < e.phi.rows(); ++row)
        if (c.held[row]) CHECK(largest(e.phi.row(row)) == 0.0);
    const auto held = std::count(c.held.begin(), c.held.end(), true);
    const int lost = spec.motion == Motion::held_right_corner ? 1 : 3;
    CHECK(e.phi.cols() == (modes == 0 ? e.phi.rows() - held : modes - lost));
    if (lost == 3) CHECK(e.lambda(0) > 1e-3);
}

TEST_CASE("block element: a block whose corner is held sideways lifts and turns about it, "
          "whatever its modes",
          "[dem][block_element]")
{
    const int modes = GENERATE(0, 3, 4, 5, 6, 12);
    BlockSpec spec = with_modes(at_toe(GENERATE(as<Mesh>{}, kEven, kLobatto)), modes);
    if (GENERATE(false, true))
        spec.edges.resize(1); // one stone alone: shear moves none of its points
    const BlockElement e = dem::block_element(spec);
    REQUIRE(e.phi.allFinite());
    REQUIRE(e.lambda.allFinite());
    const MatrixXd metric = dem::contact_metric(spec, dem::condense(spec));
    const Point corner{spec.width, 0.0};
    for (const VectorXd& u : {linear_field(e.points, {}, {0, 1}),
                              linear_field(e.points, corner, {}, {0, -1}, {1, 0})})
        CHECK(largest(followed(e, metric, u) - u) < 1e-9 * largest(u));
    CHECK(e.lambda(1) < 1e-9);
    if (modes != 3) CHECK(e.lambda(2) > 1e-3);
}

TEST_CASE("block element: body forces and top pressure have the resultants of the block",
          "[dem][block_element]")
{
    const int modes = GENERATE(0, 3, 6);
    for (const BlockSpec& spec : floating(GENERATE(as<Mesh>{}, kEven, kLobatto))) {
        const BlockElement e = dem::block_element(with_modes(spec, modes));
        const MatrixXd metric = dem::contact_metric(spec, dem::condense(spec));
        const auto work = [&](const VectorXd& load, const VectorXd& u) {
            return load.dot(e.phi.transpose() * (metric * u));
        };
        const Point centre{0.5 * spec.width, 0.5 * spec.height};
        const VectorXd right = linear_field(e.points, centre, {1, 0}),
                       up = linear_field(e.points, centre, {0, 1}),
                       turn = linear_field(e.points, centre, {}, {0, 1}, {-1, 0});
        const double volume = spec.width * spec.height * spec.thickness,
                     top = spec.width * spec.thickness;
        CHECK(work(e.weight, up) == Approx(-volume).epsilon(1e-10)); // downwards
        CHECK(work(e.sway, right) == Approx(volume).epsilon(1e-10)); // to the right
        CHECK(work(e.top_load, up) == Approx(-top).epsilon(1e-10));
        CHECK(std::abs(work(e.weight, right)) < 1e-10 * volume);
        CHECK(std::abs(work(e.sway, up)) < 1e-10 * volume);
        CHECK(std::abs(work(e.top_load, right)) < 1e-10 * top);
        for (const VectorXd& load : {e.weight, e.sway})
            CHECK(std::abs(work(load, turn)) < 1e-10 * volume);
        CHECK(std::abs(work(e.top_load, turn)) < 1e-10 * top);
    }
}

TEST_CASE("block element: a uniform stress under a top pressure is carried without bending",
          "[dem][block_element]")
{
    // Pressure on top, reaction on the bottom face: work of both on any mode is that of the
    // strain energy.
    BlockSpec spec = half_unit(kEven);
    spec.material.poisson_ratio = 0.0;
    spec.edges.erase(spec.edges.begin() + 1); // nothing on top: the beam
    const dem::Condensed c = dem::condense(spec);
    const BlockElement e = dem::block_element(with_modes(spec, GENERATE(0, 6)));
    const double pressure = 1e6;
    const VectorXd u =
        linear_field(c.points, {}, {}, {}, {0, -pressure / spec.material.young_modulus});
    const VectorXd q = e.phi.transpose() * (dem::contact_metric(spec, c) * u);
    VectorXd reaction = VectorXd::Zero(c.stiffness.rows());
    for (std::size_t i = 0; i < spec.edges[0].points.position.size(); ++i) {
        const Point at{spec.edges[0].points.position[i] * spec.width, 0.0};
        reaction(2 * dem::find_point(e, at) + 1) =
            pressure * spec.edges[0].points.weight[i] * spec.width * spec.thickness;
    }
    const VectorXd elastic = e.lambda.cwiseProduct(q);
    const VectorXd balance = pressure * e.top_load + e.phi.transpose() * reaction - elastic;
    CHECK(largest(balance) < 1e-10 * largest(pressure * e.top_load));
}

TEST_CASE("block element: points on the outline move as the contact points they are",
          "[dem][block_element]")
{
    for (const BlockSpec& spec : all_motions(kEven)) {
        const BlockElement e = dem::block_element(with_modes(spec, GENERATE(0, 6)));
        REQUIRE(e.outline_phi.rows() == 2 * static_cast<Index>(e.outline.size()));
        for (std::size_t o = 0; o < e.outline.size(); ++o)
            for (std::size_t p = 0; p < e.points.size(); ++p)
                if (dem::same_place(e.outline[o], e.points[p]))
                    CHECK(largest(e.outline_phi.middleRows<2>(2 * static_cast<Index>(o)) -
                                  e.phi.middleRows<2>(2 * static_cast<Index>(p))) <
                          1e-11 * largest(e.phi));
    }
}

TEST_CASE("block element: contact points are found by their place", "[dem][block_element]")
{
    const BlockElement e = dem::block_element(quarter_bond(kLobatto));
    for (std::size_t p = 0; p < e.points.size(); ++p)
        CHECK(dem::find_point(e, e.points[p]) == static_cast<int>(p));
    CHECK(dem::find_point(e, {e.points[3].x + 1e-9, e.points[3].z - 1e-9}) ==
          3); // but for rounding
}
