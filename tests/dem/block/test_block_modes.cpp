#include "dem/block/block_element.hpp"
#include "dem/block/block_modes.hpp"
#include "dem/block/condensation.hpp"
#include "dem/block/sparse_modes.hpp"
#include "tests/dem/block_specs.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace block_specs;
using dem::BlockElement;
using dem::BlockSpec;
using dem::Motion;
using dem::Point;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST_CASE("block modes: modes are orthogonal in the contacts' stiffness and in the block's own",
          "[dem][block_modes]")
{
    const Mesh mesh = GENERATE(as<Mesh>{}, kEven, kLobatto);
    const int modes = GENERATE(0, 3, 4, 6, 12);
    for (const BlockSpec& spec : all_motions(mesh)) {
        const dem::Condensed c = dem::condense(spec);
        const BlockElement e = dem::block_element(with_modes(spec, modes));
        const MatrixXd metric = dem::contact_metric(spec, c);
        CHECK(largest(e.phi.transpose() * metric * e.phi -
                      MatrixXd::Identity(e.phi.cols(), e.phi.cols())) < 1e-10);
        const MatrixXd stiffness = e.phi.transpose() * c.stiffness * e.phi;
        const MatrixXd expected = e.lambda.asDiagonal();
        CHECK(largest(stiffness - expected) < 1e-9 * std::max(1.0, largest(e.lambda)));
        if (e.lambda.size() > 0) CHECK(e.lambda.minCoeff() >= 0.0);
    }
}

TEST_CASE("block modes: six modes of a supported block follow every linear field its support "
          "lets pass",
          "[dem][block_modes]")
{
    const Motion motion = GENERATE(Motion::clamped_bottom, Motion::clamped_bottom_held_right,
                                   Motion::held_right_corner);
    const BlockSpec spec =
        with_modes(supported(motion, GENERATE(as<Mesh>{}, kEven, kLobatto)), GENERATE(6, 9, 0));
    const BlockElement e = dem::block_element(spec);
    const MatrixXd metric = dem::contact_metric(spec, dem::condense(spec));
    const Point corner{spec.width, 0.0};
    std::vector<VectorXd> fields = {
        linear_field(e.points, corner, {}, {}, {0, 1})}; // stretched upwards
    if (motion != Motion::clamped_bottom_held_right)
        fields.push_back(linear_field(e.points, corner, {}, {}, {1, 0}));
    if (motion == Motion::held_right_corner)
        fields.push_back(linear_field(e.points, corner, {}, {1, 0}));
    for (const VectorXd& u : fields)
        CHECK(largest(followed(e, metric, u) - u) < 1e-9 * largest(u));
}

TEST_CASE("block modes: six modes carry a uniform stress exactly", "[dem][block_modes]")
{
    const Mesh mesh = GENERATE(as<Mesh>{}, kEven, kLobatto);
    const int modes = GENERATE(6, 7, 12, 0);
    const auto [b, c] = GENERATE(table<Point, Point>(
        {{{1, 0}, {0, 0}}, {{0, 0}, {0, 1}}, {{0, 0}, {1, 0}}, {{0.3, 2}, {1, -2}}}));
    for (const BlockSpec& spec : floating(mesh)) {
        const dem::Condensed con = dem::condense(spec);
        const BlockElement e = dem::block_element(with_modes(spec, modes));
        const VectorXd u = linear_field(con.points, {}, {}, b, c), f = con.stiffness * u;
        // Loaded by f, the modes take the strain of u: the same forces, the same work.
        VectorXd q = e.phi.transpose() * f;
        for (Index i = 0; i < q.size(); ++i) q(i) = e.lambda(i) > 0 ? q(i) / e.lambda(i) : 0.0;
        const VectorXd answer = e.phi * q;
        CHECK(answer.dot(f) == Approx(u.dot(f)).epsilon(1e-10));
        CHECK(largest(con.stiffness * answer - f) < 1e-9 * largest(f));
    }
}

TEST_CASE(
    "block modes: eight modes of a rectangle between bed joints carry a linear stress exactly",
    "[dem][block_modes]")
{
    BlockSpec spec =
        with_modes(stacked(GENERATE(as<Mesh>{}, kEven, kLobatto)), GENERATE(8, 12, 0));
    spec.begins_with_bending = true;
    const dem::Condensed con = dem::condense(spec);
    const BlockElement e = dem::block_element(spec);
    VectorXd u(2 * static_cast<Index>(con.points.size())); // sigma_z = E x
    for (std::size_t p = 0; p < con.points.size(); ++p) {
        const double x = con.points[p].x - 0.5 * spec.width, z = con.points[p].z;
        u.segment<2>(2 * static_cast<Index>(p))
            << -0.5 * (z * z + spec.material.poisson_ratio * x * x),
            x * z;
    }
    const VectorXd missed = u - followed(e, dem::contact_metric(spec, con), u);
    CHECK(largest(missed) < 1e-9 * largest(u));
}

TEST_CASE("block modes: all modes together are the condensed stiffness", "[dem][block_modes]")
{
    const Mesh mesh = GENERATE(as<Mesh>{}, kEven, kLobatto);
    for (const BlockSpec& spec : floating(mesh)) {
        const dem::Condensed c = dem::condense(spec);
        const BlockElement e = dem::block_element(spec);
        REQUIRE(e.phi.cols() == e.phi.rows());
        const MatrixXd metric = dem::contact_metric(spec, c), to_points = metric * e.phi;
        const MatrixXd stiffness = to_points * e.lambda.asDiagonal() * to_points.transpose();
        CHECK(largest(stiffness - c.stiffness) < 1e-10 * largest(c.stiffness));
    }
}

TEST_CASE("block modes: fewer modes are stiffer, step by step", "[dem][block_modes]")
{
    const Mesh mesh = GENERATE(as<Mesh>{}, kEven, kLobatto);
    for (const BlockSpec& spec : all_motions(mesh)) {
        const Index points = static_cast<Index>(dem::condense(spec).points.size());
        VectorXd f(2 * points); // any load
        for (Index i = 0; i < f.size(); ++i)
            f(i) = std::sin(1.0 + 7.0 * static_cast<double>(i));
        const auto work = [&](int modes) { // done by f on the block on its contacts
            const BlockElement e = dem::block_element(with_modes(spec, modes));
            return ((e.phi.transpose() * f).array().square() / (e.lambda.array() + 1.0)).sum();
        };
        double before = 0.0;
        const double all = work(0);
        for (const int modes : {3, 4, 5, 6, 8, 12, 16}) {
            const double now = work(modes);
            CHECK(now >= before * (1 - 1e-12));
            CHECK(now <= all * (1 + 1e-12));
            before = now;
        }
        CHECK(work(5) < work(12));
        CHECK(work(12) < all);
    }
}

TEST_CASE("block modes: modes kept are nested: what few can do, more can", "[dem][block_modes]")
{
    for (const BlockSpec& spec : floating(kEven)) {
        const MatrixXd metric = dem::contact_metric(spec, dem::condense(spec));
        for (const auto& [few, more] : {std::pair{3, 4}, {4, 6}, {6, 9}, {9, 0}}) {
            const BlockElement a = dem::block_element(with_modes(spec, few)),
                               b = dem::block_element(with_modes(spec, more));
            for (Index i = 0; i < a.phi.cols(); ++i)
                CHECK(largest(followed(b, metric, a.phi.col(i)) - a.phi.col(i)) <
                      1e-9 * largest(a.phi.col(i)));
        }
    }
}

TEST_CASE("block modes: beyond the linear fields the softest modes are kept",
          "[dem][block_modes]")
{
    const int modes = 14;
    for (const BlockSpec& spec : all_motions(GENERATE(as<Mesh>{}, kEven, kLobatto))) {
        const MatrixXd metric = dem::contact_metric(spec, dem::condense(spec));
        const BlockElement all = dem::block_element(spec),
                           few = dem::block_element(with_modes(spec, modes));
        for (Index i = 0; i < modes - 8; ++i) { // at most eight are linear fields
            const VectorXd missed = all.phi.col(i) - followed(few, metric, all.phi.col(i));
            CHECK(missed.dot(metric * missed) <
                  0.01 * (1 + 1e-9)); // of 1: nearly spanned by the linear fields
        }
    }
}

TEST_CASE("block modes: without a dense matrix the same modes are found as with one",
          "[dem][block_modes]")
{
    const int modes = GENERATE(3, 6, 15);
    std::vector<BlockSpec> specs = all_motions(kLobatto);
    specs.push_back(beam(kLobatto, false)); // long and soft in bending
    specs.back().width = 4.0;
    const double longer = 4.0 / beam(kLobatto, false).width;
    for (dem::BlockEdge& e : specs.back().edges)
        for (double* const x : {&e.from.x, &e.to.x}) *x *= longer;
    const bool bending = GENERATE(false, true);
    for (const BlockSpec& plain : specs) {
        BlockSpec spec = with_modes(plain, modes);
        spec.begins_with_bending = bending && spec.motion == Motion::free;
        const dem::Condensed c = dem::condense(spec);
        const dem::BlockModes dense = dem::block_modes(spec, c);
        const dem::SparseModes sparse = dem::sparse_modes(spec, dem::sparse_block(spec));
        REQUIRE(sparse.phi.cols() == dense.phi.cols());
        CHECK(largest(sparse.lambda - dense.lambda) <
              1e-7 * std::max(1.0, largest(dense.lambda)));
        // equal up to the signs and the turning of modes of one stiffness: what they span is
        // the same
        const MatrixXd metric = dem::contact_metric(spec, c);
        const MatrixXd across = dense.phi.transpose() * metric * sparse.phi;
        CHECK(largest(across * across.transpose() -
                      MatrixXd::Identity(across.rows(), across.rows())) < 1e-6);
        CHECK(largest(c.nodes_from_points * sparse.phi - sparse.nodes) <=
              1e-7 * largest(sparse.nodes));
    }
}
