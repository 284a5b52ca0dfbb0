#include "dem/block/mesh.hpp"

#include "dem/block/triangle.hpp"

#include "dem/scene/geometry/polygon.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace dem {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Side = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Vertex, Side>,
    CGAL::No_constraint_intersection_tag>;

constexpr double kFlat =
    1e-7; // area over the square of the size, of triangles between points of one straight side
constexpr double kClear = 0.6; // of the size: points inside stay as far from the outline

/// Points of a triangular lattice inside the outline.
std::vector<Point> lattice(std::span<const Point> ring, double size)
{
    const auto by_x = [](Point a, Point b) { return a.x < b.x; };
    const auto by_z = [](Point a, Point b) { return a.z < b.z; };
    const auto [left, right] = std::ranges::minmax_element(ring, by_x);
    const auto [low, high] = std::ranges::minmax_element(ring, by_z);
    const double row_height = 0.5 * std::sqrt(3.0) * size;
    const int rows = static_cast<int>((high->z - low->z) / row_height),
              columns = static_cast<int>((right->x - left->x) / size) + 1;
    const double z0 = 0.5 * (low->z + high->z - rows * row_height),
                 x0 = 0.5 * (left->x + right->x - columns * size);
    std::vector<Point> inside;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const Point p{x0 + (i + (j % 2 == 0 ? 0.0 : 0.5)) * size, z0 + j * row_height};
            if (!is_inside(ring, p)) continue;
            double nearest = size;
            for (std::size_t k = 0; k < ring.size(); ++k)
                nearest = std::min(
                    nearest, distance_to_segment(p, ring[k], ring[(k + 1) % ring.size()]));
            if (nearest >= kClear * size) inside.push_back(p);
        }
    return inside;
}

Triangulation triangulate(const std::vector<Point>& points, std::size_t on_ring)
{
    Triangulation t;
    std::vector<Triangulation::Vertex_handle> vertices;
    for (std::size_t i = 0; i < points.size(); ++i) {
        vertices.push_back(t.insert({points[i].x, points[i].z}));
        vertices.back()->info() = static_cast<int>(i);
    }
    if (t.number_of_vertices() != points.size())
        throw std::invalid_argument("an outline visits a point twice");
    try {
        for (std::size_t i = 0; i < on_ring; ++i)
            t.insert_constraint(vertices[i], vertices[(i + 1) % on_ring]);
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
        throw std::invalid_argument("an outline crosses itself");
    }
    return t;
}

/// Points of one side are on a line but for rounding, which can leave triangles between them.
bool is_flat(const std::array<Point, 3>& c)
{
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        longest =
            std::max(longest, std::hypot(c[(i + 1) % 3].x - c[i].x, c[(i + 1) % 3].z - c[i].z));
    return triangle_area(c) < kFlat * longest * longest;
}

std::vector<std::array<int, 3>> triangles_inside(const Triangulation& t,
                                                 std::span<const Point> ring,
                                                 const std::vector<Point>& points)
{
    std::vector<std::array<int, 3>> inside;
    for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f) {
        std::array<int, 3> n{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
        if (is_flat({points[n[0]], points[n[1]], points[n[2]]})) continue;
        const Point middle{(points[n[0]].x + points[n[1]].x + points[n[2]].x) / 3.0,
                           (points[n[0]].z + points[n[1]].z + points[n[2]].z) / 3.0};
        if (is_inside(ring, middle)) inside.push_back(n);
    }
    for (auto& n : inside)
        std::rotate(n.begin(), std::min_element(n.begin(), n.end()), n.end());
    std::ranges::sort(inside);
    return inside;
}

/// Index of the node in the middle between two nodes.
int middle_node(int a, int b, std::map<std::pair<int, int>, int>& known, Mesh& m)
{
    const auto [at, fresh] =
        known.try_emplace(std::minmax(a, b), static_cast<int>(m.nodes.size()));
    if (fresh)
        m.nodes.push_back(
            {0.5 * (m.nodes[a].x + m.nodes[b].x), 0.5 * (m.nodes[a].z + m.nodes[b].z)});
    return at->second;
}

} // namespace

Mesh triangle_mesh(std::span<const Point> ring, double size)
{
    Mesh m;
    m.nodes.assign(ring.begin(), ring.end());
    const std::vector<Point> more = lattice(ring, size);
    m.nodes.insert(m.nodes.end(), more.begin(), more.end());
    const Triangulation t = triangulate(m.nodes, ring.size());
    std::map<std::pair<int, int>, int> middles;
    for (const auto& n : triangles_inside(t, ring, m.nodes)) {
        std::array<int, 6> nodes{n[0], n[1], n[2]};
        for (std::size_t k = 0; k < 3; ++k)
            nodes[3 + k] = middle_node(n[k], n[(k + 1) % 3], middles, m);
        m.triangles.push_back(nodes);
    }
    const int corners = static_cast<int>(ring.size());
    for (int i = 0; i < corners; ++i) {
        m.ring.push_back(i);
        m.ring.push_back(middle_node(i, (i + 1) % corners, middles, m));
    }
    return m;
}

} // namespace dem
