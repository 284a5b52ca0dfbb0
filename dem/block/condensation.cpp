#include "dem/block/condensation.hpp"

#include "dem/scene/touching.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>

namespace dem {

namespace {

constexpr double kEdgeRounding = 1e-7; // [m] of the coordinates of a level or vertical edge

bool same(double a, double b) { return std::abs(a - b) < kSamePlace; }

/// Edges of a rectangle are either vertical or level, but for rounding.
bool is_vertical(const BlockEdge& e)
{
    return std::abs(e.to.x - e.from.x) < std::abs(e.to.z - e.from.z);
}

Point along(const BlockEdge& e, double s)
{
    return {e.from.x + s * (e.to.x - e.from.x), e.from.z + s * (e.to.z - e.from.z)};
}

/// Zone lines in one direction. They run through the zone corners of the edges; where there are
/// no edges they are evenly spaced.
std::vector<double> grid_lines(const BlockSpec& spec, bool vertical)
{
    const double size = vertical ? spec.height : spec.width;
    std::vector<double> lines{0.0, size};
    for (const BlockEdge& e : spec.edges)
        if (is_vertical(e) == vertical)
            for (const double s : edge_nodes(e.points, spec.zones_per_interval))
                lines.push_back(vertical ? along(e, s).z : along(e, s).x);
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
    if (lines.size() > 2) return lines;
    const int n = std::max(1, static_cast<int>(std::ceil(size / spec.zone_size - 1e-9)));
    lines.resize(n + 1);
    for (int i = 0; i <= n; ++i) lines[i] = size * i / n;
    return lines;
}

std::vector<Point> contact_points(const BlockSpec& spec)
{
    std::vector<Point> points;
    for (const BlockEdge& e : spec.edges)
        for (const double s : e.points.position) {
            const Point p = along(e, s);
            if (std::none_of(points.begin(), points.end(),
                             [p](Point q) { return same_place(p, q); }))
                points.push_back(p);
        }
    return points;
}

int index_of(const std::vector<Point>& points, Point at)
{
    for (std::size_t i = 0; i < points.size(); ++i)
        if (same_place(points[i], at)) return static_cast<int>(i);
    assert(false);
    return -1;
}

/// Whether the support prescribes a displacement of zero at p, in direction 0 (x) or 1 (z).
bool is_held(const BlockSpec& spec, Point p, int direction)
{
    if (is_clamped(spec.motion) && same(p.z, 0.0)) return true;
    if (direction != 0 || !same(p.x, is_held_left(spec.motion) ? 0.0 : spec.width))
        return false;
    return spec.motion == Motion::clamped_bottom_held_right ||
           spec.motion == Motion::clamped_bottom_held_left ||
           (is_hinged(spec.motion) && same(p.z, 0.0));
}

/// Where a node gets its displacement from.
enum class Source : char { inside, edge, held };

struct Trace {
    std::vector<Source> source; ///< of each degree of freedom of the grid
    std::vector<std::vector<std::pair<int, double>>>
        rows;          ///< displacement of edge nodes from that of the points
    Eigen::MatrixXd n; ///< the same of all nodes, once the inside is solved
};

/// Shapes at s of an edge that is straight between its own zone corners. Grid lines that come
/// from other edges must not bend it, or its areas would no longer be the integrals of its
/// shapes.
std::vector<double> straight_shapes(const BlockSpec& spec, const BlockEdge& e, double s)
{
    const std::vector<double> nodes = edge_nodes(e.points, spec.zones_per_interval);
    std::size_t k = 0;
    while (k + 2 < nodes.size() && nodes[k + 1] <= s) ++k;
    std::vector<double> shape = edge_shapes(spec.face_rule, e.points, nodes[k]);
    const std::vector<double> next = edge_shapes(spec.face_rule, e.points, nodes[k + 1]);
    const double w = (s - nodes[k]) / (nodes[k + 1] - nodes[k]);
    for (std::size_t i = 0; i < shape.size(); ++i) shape[i] += w * (next[i] - shape[i]);
    return shape;
}

void trace_edge(const BlockSpec& spec, const BlockEdge& e, const std::vector<Point>& points,
                int node, double s, Trace& t)
{
    const std::vector<double> shape = straight_shapes(spec, e, s);
    for (int d = 0; d < 2; ++d) {
        t.source[2 * node + d] = Source::edge;
        t.rows[2 * node + d].clear(); // a corner lies on two edges, which agree
        for (std::size_t k = 0; k < shape.size(); ++k)
            if (shape[k] != 0.0)
                t.rows[2 * node + d].emplace_back(
                    2 * index_of(points, along(e, e.points.position[k])) + d, shape[k]);
    }
}

/// Where a point lies on an edge, 0 to 1; -1 where it does not lie on it.
double place_on(const BlockEdge& e, Point p)
{
    const double dx = e.to.x - e.from.x, dz = e.to.z - e.from.z;
    const double length = std::hypot(dx, dz);
    double s = 0.0, off = 0.0;
    if (std::abs(dx) < kEdgeRounding) {
        off = p.x - e.from.x;
        s = (p.z - e.from.z) / dz;
    } else if (std::abs(dz) < kEdgeRounding) {
        off = p.z - e.from.z;
        s = (p.x - e.from.x) / dx;
    } else {
        off = ((p.z - e.from.z) * dx - (p.x - e.from.x) * dz) / length;
        s = ((p.x - e.from.x) * dx + (p.z - e.from.z) * dz) / (length * length);
    }
    const double beyond = std::max(-s, s - 1.0) * length;
    return std::abs(off) < kSamePlace && beyond < kSamePlace ? std::clamp(s, 0.0, 1.0) : -1.0;
}

/// A contact point that no node lies at would move without force.
void require_nodes(const Mesh& mesh, const std::vector<Point>& points, const Trace& t)
{
    const auto at = [](Point p, Point q) {
        return std::hypot(p.x - q.x, p.z - q.z) < 2.0 * kSamePlace;
    };
    for (const Point p : points)
        if (std::ranges::none_of(mesh.ring, [&](int n) {
                return t.source[2 * n] == Source::edge && at(p, mesh.nodes[n]);
            }))
            throw std::invalid_argument("no zone has a node at the contact point (" +
                                        std::to_string(p.x) + ", " + std::to_string(p.z) +
                                        ") m from its lower left");
}

Trace trace_nodes(const BlockSpec& spec, const Mesh& mesh, const std::vector<Point>& points)
{
    Trace t;
    t.source.assign(2 * mesh.nodes.size(), Source::inside);
    t.rows.resize(t.source.size());
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const Point p = mesh.nodes[n];
        const int node = static_cast<int>(n);
        for (const BlockEdge& e : spec.edges)
            if (const double s = place_on(e, p); s >= 0.0)
                trace_edge(spec, e, points, node, s, t);
        for (int d = 0; d < 2; ++d)
            if (is_held(spec, p, d) && t.source[2 * n + d] == Source::inside)
                t.source[2 * n + d] = Source::held;
    }
    require_nodes(mesh, points, t);
    return t;
}

std::vector<Point> corners_of(const BlockSpec& spec)
{
    if (!spec.outline.empty()) return spec.outline;
    return {{0.0, 0.0}, {spec.width, 0.0}, {spec.width, spec.height}, {0.0, spec.height}};
}

/// Corners and zone corners along the outline. Where there are no contacts they are evenly
/// spaced.
std::vector<Point> ring_of(const BlockSpec& spec)
{
    std::vector<Point> ring;
    for (std::size_t i = 0; i < spec.outline.size(); ++i) {
        const Point a = spec.outline[i], b = spec.outline[(i + 1) % spec.outline.size()];
        const double length = std::hypot(b.x - a.x, b.z - a.z);
        const BlockEdge side{a, b, {}, 0.0, 0.0};
        std::vector<double> stops{0.0, length};
        for (const BlockEdge& e : spec.edges)
            for (const double s : edge_nodes(e.points, spec.zones_per_interval))
                if (const double at = place_on(side, along(e, s)); at >= 0.0)
                    stops.push_back(at * length);
        std::sort(stops.begin(), stops.end());
        stops.erase(std::unique(stops.begin(), stops.end(), same), stops.end());
        if (!same(stops.back(), length)) stops.push_back(length);
        for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
            const double gap = stops[k + 1] - stops[k];
            const int n =
                std::max(1, static_cast<int>(std::ceil(gap / spec.size_inside() - 1e-9)));
            for (int j = 0; j < n; ++j)
                ring.push_back(along(side, (stops[k] + gap * j / n) / length));
        }
    }
    return ring;
}

Mesh mesh_of(const BlockSpec& spec)
{
    if (spec.outline.empty())
        return grid_mesh({grid_lines(spec, false), grid_lines(spec, true)});
    return triangle_mesh(ring_of(spec), spec.size_inside());
}

/// One row of `n` for each row of the grid.
void spread_rows(Eigen::Index columns, Trace& t)
{
    t.n = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(t.rows.size()), columns);
    for (std::size_t r = 0; r < t.rows.size(); ++r)
        for (const auto& [column, shape] : t.rows[r])
            t.n(static_cast<Eigen::Index>(r), column) = shape;
}

/// Fills the rows of the inside nodes from K_II u_I = -K_IE u_E.
void solve_inside(const Eigen::SparseMatrix<double>& k, Trace& t)
{
    std::vector<int> number(t.source.size(), -1);
    int inside = 0;
    for (std::size_t i = 0; i < t.source.size(); ++i)
        if (t.source[i] == Source::inside) number[i] = inside++;
    if (inside == 0) return;

    std::vector<Eigen::Triplet<double>> entries;
    for (int c = 0; c < k.outerSize(); ++c)
        for (Eigen::SparseMatrix<double>::InnerIterator it(k, c); it; ++it)
            if (number[it.row()] >= 0 && number[c] >= 0)
                entries.emplace_back(number[it.row()], number[c], it.value());
    Eigen::SparseMatrix<double> k_inside(inside, inside);
    k_inside.setFromTriplets(entries.begin(), entries.end());

    const Eigen::MatrixXd pull = k * t.n; // the inside rows of t.n are still zero
    Eigen::MatrixXd rhs(inside, t.n.cols());
    for (std::size_t i = 0; i < number.size(); ++i)
        if (number[i] >= 0) rhs.row(number[i]) = -pull.row(static_cast<Eigen::Index>(i));
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(k_inside);
    const Eigen::MatrixXd u = solver.solve(rhs);
    for (std::size_t i = 0; i < number.size(); ++i)
        if (number[i] >= 0) t.n.row(static_cast<Eigen::Index>(i)) = u.row(number[i]);
}

} // namespace

std::vector<int> outline_nodes(const BlockSpec& spec, const Mesh& mesh,
                               const std::vector<Point>& points)
{
    const std::vector<Point> corners = corners_of(spec);
    const auto is_one_of = [](const std::vector<Point>& list, Point p) {
        return std::any_of(list.begin(), list.end(), [p](Point q) { return same_place(p, q); });
    };
    std::vector<int> kept;
    for (const int n : mesh.ring)
        if (is_one_of(corners, mesh.nodes[n]) || is_one_of(points, mesh.nodes[n]))
            kept.push_back(n);
    return kept;
}

bool same_place(Point a, Point b) { return same(a.x, b.x) && same(a.z, b.z); }

Condensed condense(const BlockSpec& spec)
{
    Condensed c;
    c.mesh = mesh_of(spec);
    c.points = contact_points(spec);
    const Eigen::SparseMatrix<double> k = mesh_stiffness(c.mesh, spec.thickness, spec.material);
    Trace trace = trace_nodes(spec, c.mesh, c.points);
    spread_rows(2 * static_cast<Eigen::Index>(c.points.size()), trace);
    solve_inside(k, trace);
    c.nodes_from_points = trace.n;
    const Eigen::MatrixXd forces = k * trace.n;
    c.stiffness = trace.n.transpose() * forces;
    c.stiffness = (0.5 * (c.stiffness + c.stiffness.transpose())).eval();
    for (const Point p : c.points)
        for (int d = 0; d < 2; ++d) c.held.push_back(is_held(spec, p, d));

    const std::vector<int> outline = outline_nodes(spec, c.mesh, c.points);
    c.outline_from_points.resize(2 * static_cast<Eigen::Index>(outline.size()), trace.n.cols());
    for (std::size_t o = 0; o < outline.size(); ++o) {
        c.outline.push_back(c.mesh.nodes[outline[o]]);
        for (int d = 0; d < 2; ++d)
            c.outline_from_points.row(2 * static_cast<Eigen::Index>(o) + d) =
                trace.n.row(2 * outline[o] + d);
    }
    return c;
}

SparseBlock sparse_block(const BlockSpec& spec)
{
    SparseBlock b;
    b.mesh = mesh_of(spec);
    b.points = contact_points(spec);
    const Trace trace = trace_nodes(spec, b.mesh, b.points);
    const int outer = 2 * static_cast<int>(b.points.size());
    std::vector<Eigen::Triplet<double>> entries;
    int column = outer;
    for (std::size_t r = 0; r < trace.source.size(); ++r) {
        for (const auto& [c, shape] : trace.rows[r])
            entries.emplace_back(static_cast<int>(r), c, shape);
        if (trace.source[r] == Source::inside)
            entries.emplace_back(static_cast<int>(r), column++, 1.0);
    }
    b.nodes.resize(static_cast<int>(trace.source.size()), column);
    b.nodes.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> k = mesh_stiffness(b.mesh, spec.thickness, spec.material);
    b.stiffness = Eigen::SparseMatrix<double>(b.nodes.transpose()) * k * b.nodes;
    for (const Point p : b.points)
        for (int d = 0; d < 2; ++d) b.held.push_back(is_held(spec, p, d));
    return b;
}

Eigen::VectorXd condense_load(const Condensed& c, const Eigen::VectorXd& nodal)
{
    return c.nodes_from_points.transpose() * nodal;
}

} // namespace dem
