#pragma once
/// Rigid blocks on dry joints, for shaking.

#include "dem/block/model.hpp"
#include "dem/shaking/shake.hpp"
#include "scenes/paper_wall.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace shaken_blocks {

constexpr double kGravity = 9.81;

/// A block of half width b and half height h on a dry joint, without a beam.
inline scenes::Scene block(double b, double h, double kn = 1e10, double tan_phi = 10.0)
{
    scenes::Scene s = scenes::monolith(2.0 * b, 2.0 * h, 0.0, kn);
    s.stone = {1e16, 0.0, 2300.0};
    s.wall.toe = dem::Toe::free;
    s.beam.present = false;
    s.loads.pattern = dem::LoadPattern::body;
    s.loads.vertical_stress = 0.0;
    s.joint.tan_phi = tan_phi;
    return s;
}

inline dem::Discretisation rigid(int contact_points = 2)
{
    dem::Discretisation d;
    d.contact_points = contact_points;
    d.block_modes = d.beam_modes = 3;
    d.zones_per_interval = 1;
    d.face_rule = dem::FaceRule::even;
    return d;
}

/// Two contact points on each bed joint: its ends.
inline dem::Model model(const scenes::Scene& s, int contact_points = 2)
{
    dem::Layout layout = dem::lay_out(s.wall, s.beam.present ? s.beam.height : 0.0);
    layout.half_unit = s.wall.length;
    return dem::discretise(std::move(layout), s.stone, s.beam, s.loads, {s.joint, s.crack},
                           rigid(contact_points));
}

inline dem::ShakeResult shaken(const scenes::Scene& s, const dem::ShakePlan& plan,
                               int contact_points = 2)
{
    const dem::Model m = model(s, contact_points);
    return dem::shake(m, scenes::uniform(s, m), plan);
}

/// Half a sine of this peak [m/s2] and duration [s].
inline dem::ShakePlan half_sine(double peak, double duration, int samples = 400)
{
    dem::ShakePlan p;
    p.step = duration / samples;
    for (int i = 0; i <= samples; ++i)
        p.horizontal.push_back(peak * std::sin(std::numbers::pi * i / samples));
    return p;
}

/// A block turned about its lower right corner by th, its middle against the undeformed place.
inline dem::Displaced turned(int block, double b, double h, double th)
{
    // From the corner (b, -h) of the block to its middle: (-b, h).
    return {block, -b * std::cos(th) + h * std::sin(th) + b,
            h * std::cos(th) + b * std::sin(th) - h, th};
}

} // namespace shaken_blocks
