#include "dem/scene/mechanism/snapshot_reading.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

/// The largest value of the contacts of a wall; 0 if none is larger.
template <class Value> double largest_of(const Snapshot& wall, Value value)
{
    double found = 0.0;
    for (const FaceState& face : wall.faces)
        for (const ContactState& c : face.contacts) found = std::max(found, value(face, c));
    return found;
}

} // namespace

double compression_of(const FaceState& face)
{
    double force = 0.0;
    for (const ContactState& c : face.contacts) force += std::max(0.0, -c.sigma) * c.area;
    return force;
}

double largest_compression(const Snapshot& wall)
{
    double found = 0.0;
    for (const FaceState& face : wall.faces) found = std::max(found, compression_of(face));
    return found;
}

double largest_displacement(const Snapshot& wall)
{
    double found = 0.0;
    for (const BlockState& block : wall.blocks)
        for (const Point& u : block.displacement) found = std::max(found, std::hypot(u.x, u.z));
    return found;
}

double largest_movement(const Snapshot& wall)
{
    return largest_of(wall, [](const FaceState&, const ContactState& c) {
        return std::max(c.opening, std::abs(c.slip));
    });
}

bool slides(const ContactState& c, double threshold)
{
    return c.opening <= threshold && std::abs(c.slip) > threshold;
}

double largest_slip(const Snapshot& wall, double threshold)
{
    return largest_of(wall, [=](const FaceState& face, const ContactState& c) {
        return face.kind != FaceKind::unit_crack && slides(c, threshold) ? std::abs(c.slip)
                                                                         : 0.0;
    });
}

bool is_cracked_through(const FaceState& face)
{
    return !face.contacts.empty() &&
           std::ranges::all_of(face.contacts,
                               [](const ContactState& c) { return c.damage >= 1.0; });
}

bool any_crushed(const Snapshot& wall)
{
    return largest_of(wall, [](const FaceState&, const ContactState& c) { return c.crushed; }) >
           0.0;
}

std::optional<double> toe_stress(const Snapshot& wall, Base base)
{
    std::optional<double> most;
    for (const FaceState& face : wall.faces) {
        const bool can_open = base != Base::fixed
                                  ? face.kind == FaceKind::base_joint
                                  : face.kind == FaceKind::bed_joint && face.block_a >= 0 &&
                                        wall.blocks.at(face.block_a).course == 1;
        if (!can_open) continue;
        for (const ContactState& c : face.contacts)
            most = std::max(most.value_or(0.0), -c.sigma);
    }
    return most;
}

std::optional<SlidJoint> slid_joint(const Snapshot& wall, double share)
{
    SlidJoint found;
    for (const FaceState& face : wall.faces) {
        if (face.contacts.size() < 2) continue;
        const Point from = face.contacts.front().at, to = face.contacts.back().at;
        const double length = std::hypot(to.x - from.x, to.z - from.z);
        for (const ContactState& c : face.contacts)
            if (c.sigma < 0.0 && std::abs(c.slip) > std::max(share * length, found.slip))
                found = {length, std::abs(c.slip)};
    }
    if (found.slip > 0.0) return found;
    return {};
}

double beam_slip(const Snapshot& wall)
{
    return largest_of(wall, [](const FaceState& face, const ContactState& c) {
        return face.kind == FaceKind::beam_joint && c.sigma < 0.0 ? std::abs(c.slip) : 0.0;
    });
}

double strength_used(const ContactState& c, const CrackMaterial& m)
{
    const double tension = m.ft > 0.0 ? c.sigma / m.ft : INFINITY;
    const double shear = m.cohesion - c.sigma * m.tan_phi;
    return std::max(tension, shear > 0.0 ? std::abs(c.tau) / shear : INFINITY);
}

} // namespace dem
