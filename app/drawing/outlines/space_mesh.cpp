#include "app/drawing/outlines/space_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>

namespace app {
namespace {

constexpr double kFlat = 1e-6; // of a mesh's size: what counts as one plane

struct Span {
    double low = 0.0, high = 0.0;
    [[nodiscard]] double length() const { return high - low; }
};

Span span_along(const SpaceMesh& mesh, std::size_t axis)
{
    Span span{mesh.points.front()[axis], mesh.points.front()[axis]};
    for (const auto& p : mesh.points) {
        span.low = std::min(span.low, p[axis]);
        span.high = std::max(span.high, p[axis]);
    }
    return span;
}

double size_of(const SpaceMesh& mesh)
{
    return std::max({span_along(mesh, 0).length(), span_along(mesh, 1).length(),
                     span_along(mesh, 2).length()});
}

bool is_flat(const SpaceMesh& mesh, std::size_t axis)
{
    return span_along(mesh, axis).length() <= kFlat * size_of(mesh);
}

/// Every point lies in the front or in the back.
bool is_prism(const SpaceMesh& mesh, std::size_t axis)
{
    const Span span = span_along(mesh, axis);
    const double width = kFlat * size_of(mesh);
    return std::ranges::all_of(mesh.points, [&](const auto& p) {
        return p[axis] - span.low <= width || span.high - p[axis] <= width;
    });
}

/// The outline of faces that share sides; empty if it is not one ring.
std::vector<int> outline_of(const std::vector<std::vector<int>>& faces)
{
    std::map<std::pair<int, int>, int> sides;
    for (const auto& face : faces)
        for (std::size_t i = 0; i < face.size(); ++i)
            ++sides[{face[i], face[(i + 1) % face.size()]}];
    std::map<int, int> next;
    std::size_t n = 0;
    for (const auto& [side, times] : sides) {
        if (sides.contains({side.second, side.first})) continue;
        next[side.first] = side.second;
        ++n;
    }
    if (n == 0 || next.size() != n) return {};
    std::vector<int> ring;
    for (int at = next.begin()->first; ring.size() <= n;) {
        ring.push_back(at);
        const auto found = next.find(at);
        if (found == next.end()) return {};
        at = found->second;
        if (at == ring.front()) break;
    }
    return ring.size() == n ? ring : std::vector<int>{};
}

/// The corners in the wall's plane; `up` is the axis that becomes z.
RawOutline flat_outline(const DrawingFrame& frame, const SpaceMesh& mesh,
                        std::span<const int> ring, std::size_t up)
{
    RawOutline outline{{}, mesh.layer, mesh.line};
    for (const int i : ring) {
        const auto& p = mesh.points[i];
        outline.corners.push_back(checked_point(frame, mesh.line, p[0], p[up]));
    }
    return outline;
}

std::vector<int> front_of(const SpaceMesh& mesh, std::size_t axis)
{
    const double front = span_along(mesh, axis).low + kFlat * size_of(mesh);
    std::vector<std::vector<int>> faces;
    for (const auto& face : mesh.faces) {
        const bool in_front =
            std::ranges::all_of(face, [&](int i) { return mesh.points[i][axis] <= front; });
        if (in_front) faces.push_back(face);
    }
    return outline_of(faces);
}

void add_flat(RawDrawing& drawing, const std::vector<SpaceMesh>& meshes, std::size_t axis,
              double snap)
{
    const std::size_t up = axis == 1 ? 2 : 1;
    for (const SpaceMesh& mesh : meshes)
        for (const auto& face : mesh.faces)
            add_outline(drawing, flat_outline(drawing.frame, mesh, face, up), true, snap);
    drawing.notes.push_back(std::string("The meshes lie in the ") + (up == 2 ? "x-z" : "x-y") +
                            " plane; each of their faces is a block.");
}

void add_prisms(RawDrawing& drawing, const std::vector<SpaceMesh>& meshes, std::size_t axis,
                double snap)
{
    const std::size_t up = axis == 1 ? 2 : 1;
    for (const SpaceMesh& mesh : meshes) {
        const std::vector<int> ring = front_of(mesh, axis);
        if (ring.size() < 3) {
            refuse(drawing.frame, mesh.line,
                   std::string("the front of this mesh is not one face, nor faces that share "
                               "sides; give it "
                               "as {\"outline\": [[x, ") +
                       (up == 2 ? "z" : "y") + "], ...]}");
        }
        add_outline(drawing, flat_outline(drawing.frame, mesh, ring, up), true, snap);
    }
    drawing.notes.push_back(
        std::string("The meshes are prisms along ") + (axis == 1 ? "y" : "z") +
        "; the front of each is a block, in the " + (up == 2 ? "x-z" : "x-y") + " plane.");
}

} // namespace

void add_meshes(RawDrawing& drawing, const std::vector<SpaceMesh>& meshes, double snap)
{
    if (meshes.empty()) return;
    const auto all = [&](auto is, std::size_t axis) {
        return std::ranges::all_of(meshes,
                                   [&](const SpaceMesh& mesh) { return is(mesh, axis); });
    };
    for (const std::size_t axis : {std::size_t{1}, std::size_t{2}})
        if (all(is_flat, axis)) return add_flat(drawing, meshes, axis, snap);
    for (const std::size_t axis : {std::size_t{1}, std::size_t{2}})
        if (all(is_prism, axis)) return add_prisms(drawing, meshes, axis, snap);
    for (const SpaceMesh& mesh : meshes) {
        if (is_prism(mesh, 1)) continue;
        refuse(drawing.frame, mesh.line,
               "a mesh is neither flat (all y equal, or all z equal) nor a prism along y or z; "
               "a wall in its plane "
               "has blocks of constant thickness");
    }
    refuse(drawing.frame, meshes.front().line,
           "the meshes are not all flat, nor all prisms; give all the same way");
}

} // namespace app
