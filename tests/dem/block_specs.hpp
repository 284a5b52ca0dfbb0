#pragma once
/// Blocks as the wall makes them, for tests of their stiffness and modes.

#include "dem/block/block_element.hpp"

#include <vector>

namespace block_specs {

constexpr double kWidth = 0.1, kHeight = 0.09, kThickness = 0.2; // [m]
constexpr double kJoint = 8e9, kCrack = 8e10;                    // normal stiffness [Pa/m]

/// Contact points of all faces of a block.
struct Mesh {
    dem::FaceRule rule = dem::FaceRule::even;
    int points = 4;
    int zones = 2;
};

inline dem::BlockEdge edge(dem::Point from, dem::Point to, const Mesh& mesh, double kn)
{
    return {from, to, dem::face_points(mesh.rule, mesh.points, mesh.zones), kn, kn / 2.4};
}

/// Without contacts.
inline dem::BlockSpec bare(const Mesh& mesh, double width = kWidth, double height = kHeight)
{
    dem::BlockSpec s;
    s.width = width;
    s.height = height;
    s.thickness = kThickness;
    s.material = {15.5e9, 0.2, 2300.0};
    s.load_height = height;
    s.face_rule = mesh.rule;
    s.zones_per_interval = mesh.zones;
    s.zone_size = 0.02;
    return s;
}

inline dem::BlockEdge bottom(const dem::BlockSpec& s, const Mesh& mesh, double x0, double x1)
{
    return edge({x0 * s.width, 0.0}, {x1 * s.width, 0.0}, mesh, kJoint);
}

inline dem::BlockEdge top(const dem::BlockSpec& s, const Mesh& mesh, double x0, double x1)
{
    return edge({x0 * s.width, s.height}, {x1 * s.width, s.height}, mesh, kJoint);
}

/// One of a pair that makes a unit: bed joints below and above, a head joint on its left, a
/// crack on its right.
inline dem::BlockSpec half_unit(const Mesh& mesh)
{
    dem::BlockSpec s = bare(mesh);
    s.edges = {bottom(s, mesh, 0, 1), top(s, mesh, 0, 1),
               edge({0, 0}, {0, s.height}, mesh, kJoint),
               edge({s.width, 0}, {s.width, s.height}, mesh, kCrack)};
    return s;
}

/// Bed joints alone: a block of a stack.
inline dem::BlockSpec stacked(const Mesh& mesh)
{
    dem::BlockSpec s = bare(mesh);
    s.edges = {bottom(s, mesh, 0, 1), top(s, mesh, 0, 1)};
    return s;
}

/// A half unit that overlaps two blocks below and two above, not where the others meet.
inline dem::BlockSpec quarter_bond(const Mesh& mesh)
{
    dem::BlockSpec s = half_unit(mesh);
    s.edges[0] = bottom(s, mesh, 0, 0.3);
    s.edges[1] = bottom(s, mesh, 0.3, 1);
    s.edges.insert(s.edges.begin() + 2, {top(s, mesh, 0, 0.6), top(s, mesh, 0.6, 1),
                                         edge({0, 0}, {0, s.height}, mesh, kJoint)});
    s.edges.erase(s.edges.begin() + 5);
    return s;
}

/// First course on ground that holds it: no contacts below.
inline dem::BlockSpec on_ground(const Mesh& mesh, dem::Motion motion)
{
    dem::BlockSpec s = half_unit(mesh);
    s.edges.erase(s.edges.begin());
    if (motion == dem::Motion::clamped_bottom_held_right)
        s.edges.pop_back(); // the toe side is free of contacts
    s.motion = motion;
    return s;
}

/// First course on a joint, its toe held sideways.
inline dem::BlockSpec at_toe(const Mesh& mesh)
{
    dem::BlockSpec s = half_unit(mesh);
    s.edges.pop_back();
    s.motion = dem::Motion::held_right_corner;
    return s;
}

/// The loading beam over three blocks.
inline dem::BlockSpec beam(const Mesh& mesh, bool rotation_fixed = false)
{
    dem::BlockSpec s = bare(mesh, 0.3);
    s.edges = {bottom(s, mesh, 0, 1.0 / 3), bottom(s, mesh, 1.0 / 3, 2.0 / 3),
               bottom(s, mesh, 2.0 / 3, 1)};
    s.motion = dem::Motion::driven;
    s.rotation_fixed = rotation_fixed;
    return s;
}

constexpr Mesh kEven = {dem::FaceRule::even, 4, 2};
constexpr Mesh kLobatto = {dem::FaceRule::lobatto, 5, 2};

inline dem::BlockSpec with_modes(dem::BlockSpec spec, int modes)
{
    spec.modes = modes;
    return spec;
}

inline std::vector<dem::BlockSpec> all_motions(const Mesh& mesh)
{
    return {half_unit(mesh),
            stacked(mesh),
            beam(mesh),
            beam(mesh, true),
            at_toe(mesh),
            on_ground(mesh, dem::Motion::clamped_bottom),
            on_ground(mesh, dem::Motion::clamped_bottom_held_right)};
}

inline std::vector<dem::BlockSpec> floating(const Mesh& mesh)
{
    return {half_unit(mesh), quarter_bond(mesh), stacked(mesh)};
}

inline dem::BlockSpec supported(dem::Motion motion, const Mesh& mesh)
{
    return motion == dem::Motion::held_right_corner ? at_toe(mesh) : on_ground(mesh, motion);
}

/// u = a + (b about `centre`), with u_x = b.x dx + c.x dz and u_z = b.z dx + c.z dz.
inline Eigen::VectorXd linear_field(const std::vector<dem::Point>& points, dem::Point centre,
                                    dem::Point a, dem::Point b = {}, dem::Point c = {})
{
    Eigen::VectorXd u(2 * static_cast<Eigen::Index>(points.size()));
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double x = points[p].x - centre.x, z = points[p].z - centre.z;
        u(2 * static_cast<Eigen::Index>(p)) = a.x + b.x * x + c.x * z;
        u(2 * static_cast<Eigen::Index>(p) + 1) = a.z + b.z * x + c.z * z;
    }
    return u;
}

/// The part of u that the modes can follow.
inline Eigen::VectorXd followed(const dem::BlockElement& e, const Eigen::MatrixXd& metric,
                                const Eigen::VectorXd& u)
{
    return e.phi * (e.phi.transpose() * (metric * u));
}

inline double largest(const Eigen::MatrixXd& m)
{
    return m.size() > 0 ? m.cwiseAbs().maxCoeff() : 0.0;
}

} // namespace block_specs
