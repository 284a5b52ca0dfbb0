#include "dem/shaking/true_masses.hpp"

#include "dem/block/model.hpp"

#include <stdexcept>

namespace dem {

namespace {

/// Second moment of area about the origin, Ix + Iz [m4], of a polygon that runs
/// counter-clockwise.
double polar_moment(const std::vector<Point>& corners)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point p = corners[i], q = corners[(i + 1) % corners.size()];
        const double cross = p.x * q.z - q.x * p.z;
        sum += cross * (p.x * p.x + p.x * q.x + q.x * q.x + p.z * p.z + p.z * q.z + q.z * q.z);
    }
    return sum / 12.0;
}

/// Inertia of the block alone, about its own centre.
double own_inertia(const Block& b, double density, double thickness)
{
    const Point centre = centre_of(b);
    std::vector<Point> corners = b.outline;
    if (corners.empty()) corners = {{b.x0, b.z0}, {b.x1, b.z0}, {b.x1, b.z1}, {b.x0, b.z1}};
    for (Point& p : corners) p = {p.x - centre.x, p.z - centre.z};
    return density * thickness * polar_moment(corners);
}

/// Adds a point mass to a block.
void add_point(double mass, double x, double z, BlockMass& b)
{
    const double all = b.mass + mass, dx = x - b.centre_x, dz = z - b.centre_z;
    b.inertia += b.mass * mass / all * (dx * dx + dz * dz);
    b.centre_x += mass / all * dx;
    b.centre_z += mass / all * dz;
    b.mass = all;
}

} // namespace

std::vector<BlockMass> true_masses(const Model& m, const StepTables& t, const WallMaterials& w,
                                   LoadMass load, double load_height)
{
    std::vector<BlockMass> all;
    for (int k = 0; k < static_cast<int>(m.layout.blocks.size()); ++k) {
        const FiniteTables::BlockRow& row = t.finite.blocks[k];
        if (row.rigid != 0 && row.rigid != 3)
            throw std::invalid_argument(
                "a wall that is shaken needs blocks that are held altogether or not at all: "
                "leave the toe free");
        BlockMass b;
        if (row.rigid == 3) {
            const double density = stone_of(m, k, w.stone).density;
            b = {density * row.volume,
                 own_inertia(m.layout.blocks[k], density, m.layout.thickness), row.centre_x,
                 row.centre_z};
            if (k == m.layout.beam && load == LoadMass::floor) {
                const double stress = w.vertical_stress.value_or(m.loads.vertical_stress);
                const double mass = stress * t.finite.load_area / m.loads.gravity;
                if (mass > 0.0) add_point(mass, 0.0, t.finite.load.above + load_height, b);
            }
            if (!(b.mass > 0.0 && b.inertia > 0.0))
                throw std::invalid_argument("a wall that is shaken needs blocks with mass: "
                                            "give every stone, and the beam, a density");
        }
        all.push_back(b);
    }
    return all;
}

Eigen::Matrix3d modal_mass(const BlockElement& e, const BlockMass& b)
{
    Eigen::Matrix3d m;
    const double x = b.centre_x, z = b.centre_z;
    m << b.mass, 0.0, b.mass * z, 0.0, b.mass, -b.mass * x, b.mass * z, -b.mass * x,
        b.inertia + b.mass * (x * x + z * z);
    return e.rigid.transpose() * m * e.rigid;
}

} // namespace dem
