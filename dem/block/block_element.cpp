#include "dem/block/block_element.hpp"

#include "dem/block/block_modes.hpp"
#include "dem/block/condensation.hpp"
#include "dem/block/sparse_modes.hpp"
#include "dem/scene/touching.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace dem {

namespace {

Eigen::VectorXd modal_load(const Condensed& c, const Eigen::MatrixXd& phi,
                           const Eigen::VectorXd& nodal)
{
    return phi.transpose() * condense_load(c, nodal);
}

Eigen::VectorXd body_force(const Mesh& mesh, double thickness, int direction)
{
    const Eigen::VectorXd area = nodal_areas(mesh);
    Eigen::VectorXd f = Eigen::VectorXd::Zero(2 * area.size());
    for (Eigen::Index n = 0; n < area.size(); ++n) f(2 * n + direction) = area(n) * thickness;
    return f;
}

/// On the top of a rectangle; outlines carry no load of their own.
Eigen::VectorXd top_pressure(const BlockSpec& spec, const Mesh& mesh)
{
    Eigen::VectorXd f = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(mesh.nodes.size()));
    for (const auto& r : mesh.rectangles) {
        const Point right = mesh.nodes[r[2]], left = mesh.nodes[r[3]];
        if (!same_place(left, {left.x, spec.height})) continue;
        const double half = 0.5 * (right.x - left.x) * spec.thickness;
        f(2 * r[3] + 1) -= half;
        f(2 * r[2] + 1) -= half;
    }
    return f;
}

/// The point about which a support or the drive lets the block turn; else its centre.
Point pivot_of(const BlockSpec& spec)
{
    if (spec.motion == Motion::driven) return {0.5 * spec.width, spec.load_height};
    if (spec.motion == Motion::held_right_corner) return {spec.width, 0.0};
    if (spec.motion == Motion::held_left_corner) return {0.0, 0.0};
    return {0.5 * spec.width, 0.5 * spec.height};
}

Eigen::Index rigid_modes(const BlockSpec& spec)
{
    switch (spec.motion) {
    case Motion::free:
        return 3;
    case Motion::driven:
        return spec.rotation_fixed ? 1 : 2;
    case Motion::held_right_corner:
    case Motion::held_left_corner:
        return 2;
    default:
        return 0;
    }
}

/// Translation and rotation of the pivot in each of the first modes, by least squares. The
/// normal equations serve: each point gives both translations, so that only the size of the
/// block against its distance from the pivot enters.
Eigen::MatrixXd rigid_motions(const BlockElement& e, Eigen::Index modes)
{
    if (modes == 0) return Eigen::MatrixXd(3, 0); // a held block; Eigen solves for at least one
    Eigen::MatrixXd field(e.phi.rows(), 3);
    for (std::size_t p = 0; p < e.points.size(); ++p) {
        const auto row = 2 * static_cast<Eigen::Index>(p);
        field.row(row) << 1.0, 0.0, e.points[p].z - e.pivot.z;
        field.row(row + 1) << 0.0, 1.0, e.pivot.x - e.points[p].x;
    }
    const Eigen::MatrixXd phi = e.phi.leftCols(modes);
    const Eigen::Matrix3d normal = field.transpose() * field;
    return normal.inverse() * (field.transpose() * phi);
}

/// @param load modal load of given loads on the nodes
template <class Load>
void add_loads(const BlockSpec& spec, const Mesh& mesh, const Load& load, BlockElement& e)
{
    e.pivot = pivot_of(spec);
    e.rigid = rigid_motions(e, rigid_modes(spec));
    e.weight = -load(body_force(mesh, spec.thickness, 1));
    e.sway = load(body_force(mesh, spec.thickness, 0));
    e.top_load = load(top_pressure(spec, mesh));
}

BlockElement element_of_many_points(const BlockSpec& spec)
{
    const SparseBlock block = sparse_block(spec);
    const SparseModes modes = sparse_modes(spec, block);
    BlockElement e;
    e.points = block.points;
    e.phi = modes.phi;
    e.lambda = modes.lambda;
    add_loads(
        spec, block.mesh,
        [&](const Eigen::VectorXd& f) -> Eigen::VectorXd {
            return modes.nodes.transpose() * f;
        },
        e);
    const std::vector<int> outline = outline_nodes(spec, block.mesh, block.points);
    e.outline_phi.resize(2 * static_cast<Eigen::Index>(outline.size()), e.phi.cols());
    for (std::size_t o = 0; o < outline.size(); ++o) {
        e.outline.push_back(block.mesh.nodes[outline[o]]);
        e.outline_phi.middleRows(2 * static_cast<Eigen::Index>(o), 2) =
            modes.nodes.middleRows(2 * outline[o], 2);
    }
    return e;
}

} // namespace

BlockElement block_element(const BlockSpec& spec)
{
    if (has_many_points(spec)) return element_of_many_points(spec);
    const Condensed c = condense(spec);
    const BlockModes modes = block_modes(spec, c);

    BlockElement e;
    e.points = c.points;
    e.phi = modes.phi;
    e.lambda = modes.lambda;
    add_loads(
        spec, c.mesh, [&](const Eigen::VectorXd& f) { return modal_load(c, e.phi, f); }, e);
    e.outline = c.outline;
    e.outline_phi = c.outline_from_points * e.phi;
    return e;
}

int find_point(const BlockElement& element, Point at)
{
    const auto away = [at](Point p) { return std::hypot(p.x - at.x, p.z - at.z); };
    const auto nearest = std::ranges::min_element(element.points, {}, away);
    assert(nearest != element.points.end() && away(*nearest) < 2.0 * kSamePlace);
    return static_cast<int>(nearest - element.points.begin());
}

} // namespace dem
