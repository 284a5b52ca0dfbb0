#include "bench/accuracy/accuracy_walls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bench {

namespace {

/// Half of an arch, to the right of its crown.
struct HalfArch {
    double centre_x = 0.0;  ///< of its circle [m]
    double centre_z = 0.0;  ///< [m]
    double radius = 1.0;    ///< of the intrados [m]
    double thickness = 0.2; ///< of the ring [m]
    double springing = 0.0; ///< angle above the horizon [rad]
    [[nodiscard]] Corner inner(double angle) const { return at(radius, angle); }
    [[nodiscard]] Corner outer(double angle) const { return at(radius + thickness, angle); }
    /// Where the circle of `r` reaches the crown [rad].
    [[nodiscard]] double crown(double r) const { return std::acos(-centre_x / r); }

  private:
    [[nodiscard]] Corner at(double r, double angle) const
    {
        return {centre_x + r * std::cos(angle), centre_z + r * std::sin(angle)};
    }
};

std::vector<Corner> mirrored(const std::vector<Corner>& stone)
{
    std::vector<Corner> m;
    for (auto c = stone.rbegin(); c != stone.rend(); ++c) m.push_back({-c->x, c->z});
    return m;
}

/// The ring in joints along the radius. An odd number of stones has a key stone; the others of
/// a pointed arch meet at the crown.
void add_ring(std::vector<std::vector<Corner>>& stones, const HalfArch& a, int count)
{
    const double end = a.crown(a.radius); // of the intrados
    const double each = (end - a.springing) * 2.0 / count;
    const int half = count / 2;
    for (int i = 0; i < half; ++i) {
        const double from = a.springing + i * each, to = from + each;
        const bool meets = count % 2 == 0 && i + 1 == half;
        const std::vector<Corner> stone = {
            a.inner(from), a.outer(from),
            meets ? Corner{0.0, a.outer(a.crown(a.radius + a.thickness)).z} : a.outer(to),
            meets ? Corner{0.0, a.inner(end).z} : a.inner(to)};
        stones.push_back(stone);
        stones.push_back(mirrored(stone));
    }
    if (count % 2 == 0) return;
    const Corner in = a.inner(a.springing + half * each),
                 out = a.outer(a.springing + half * each);
    stones.push_back({{-in.x, in.z}, in, out, {-out.x, out.z}});
}

/// Piers in drums; the uppermost takes up a springing that leans.
void add_piers(std::vector<std::vector<Corner>>& stones, const HalfArch& a, double wide,
               int drums)
{
    const Corner in = a.inner(a.springing), out = a.outer(a.springing);
    const double edge = std::max(in.x + wide, out.x);
    for (int i = 0; i < drums; ++i) {
        const double z0 = i * in.z / drums, z1 = (i + 1) * in.z / drums;
        std::vector<Corner> drum = {{in.x, z0}, {edge, z0}};
        if (i + 1 < drums) {
            drum.push_back({edge, z1});
            drum.push_back({in.x, z1});
        } else {
            drum.push_back({edge, out.z});
            if (edge > out.x + 1e-9) drum.push_back(out);
            drum.push_back(in);
        }
        stones.push_back(drum);
        stones.push_back(mirrored(drum));
    }
}

} // namespace

DrawnWall draw_arch(Draw& d)
{
    const double half_span = d.log_uniform(0.2, 1.2);
    const int form = d.integer(0, 2); // semicircular, segmental, pointed
    HalfArch a;
    a.radius = half_span;
    if (form == 1) {
        a.springing = d.uniform(0.25, 0.9);
        a.radius = half_span / std::cos(a.springing);
    } else if (form == 2) {
        a.centre_x = -half_span * d.uniform(0.15, 1.0);
        a.radius = half_span - a.centre_x;
    }
    a.thickness = half_span * (form == 0 ? d.uniform(0.15, 0.35) : d.uniform(0.12, 0.3));
    int count = std::min(d.integer(7, 26), d.integer(7, 26));
    if (form == 2) count += count % 2; // no key stone
    const bool piers = d.chance(0.5);
    double foot = piers ? half_span * d.uniform(0.2, 1.2) : 0.0;
    if (form == 1 && !piers) foot = 0.15 * half_span; // what takes its thrust
    a.centre_z = foot - a.radius * std::sin(a.springing);
    std::vector<std::vector<Corner>> stones;
    if (foot > 0.0) {
        const double wide = half_span * d.uniform(0.4, 1.0);
        add_piers(stones, a, wide, piers ? d.integer(1, 3) : 1);
    }
    add_ring(stones, a, count);
    DrawnWall w = drawn_wall_of("arch", std::move(stones), d.uniform(0.2, 0.6));
    w.keys += "base = joint\n";
    w.course_height = a.thickness;
    return w;
}

} // namespace bench
