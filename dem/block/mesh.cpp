#include "dem/block/mesh.hpp"

#include "dem/block/triangle.hpp"

namespace dem {

namespace {

template <std::size_t kNodes, class Matrix>
void add_entries(const std::array<int, kNodes>& nodes, const Matrix& k,
                 std::vector<Eigen::Triplet<double>>& entries)
{
    const int rows = 2 * static_cast<int>(kNodes);
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < rows; ++c)
            entries.emplace_back(2 * nodes[static_cast<std::size_t>(r / 2)] + r % 2,
                                 2 * nodes[static_cast<std::size_t>(c / 2)] + c % 2, k(r, c));
}

std::array<Point, 3> corners(const Mesh& m, const std::array<int, 6>& t)
{
    return {m.nodes[t[0]], m.nodes[t[1]], m.nodes[t[2]]};
}

} // namespace

Mesh grid_mesh(const ZoneGrid& grid)
{
    Mesh m;
    const int nx = static_cast<int>(grid.x.size()), nz = static_cast<int>(grid.z.size());
    for (const double z : grid.z)
        for (const double x : grid.x) m.nodes.push_back({x, z});
    for (int j = 0; j + 1 < nz; ++j)
        for (int i = 0; i + 1 < nx; ++i)
            m.rectangles.push_back({grid.node(i, j), grid.node(i + 1, j),
                                    grid.node(i + 1, j + 1), grid.node(i, j + 1)});
    for (int i = 0; i < nx - 1; ++i) m.ring.push_back(grid.node(i, 0));
    for (int j = 0; j < nz - 1; ++j) m.ring.push_back(grid.node(nx - 1, j));
    for (int i = nx - 1; i > 0; --i) m.ring.push_back(grid.node(i, nz - 1));
    for (int j = nz - 1; j > 0; --j) m.ring.push_back(grid.node(0, j));
    return m;
}

Eigen::SparseMatrix<double> mesh_stiffness(const Mesh& m, double thickness,
                                           const Elastic& material)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& r : m.rectangles)
        add_entries(r,
                    zone_stiffness(m.nodes[r[2]].x - m.nodes[r[0]].x,
                                   m.nodes[r[2]].z - m.nodes[r[0]].z, thickness, material),
                    entries);
    for (const auto& t : m.triangles)
        add_entries(t, triangle_stiffness(corners(m, t), thickness, material), entries);
    const int rows = 2 * static_cast<int>(m.nodes.size());
    Eigen::SparseMatrix<double> stiffness(rows, rows);
    stiffness.setFromTriplets(entries.begin(), entries.end());
    return stiffness;
}

Eigen::VectorXd nodal_areas(const Mesh& m)
{
    Eigen::VectorXd area = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m.nodes.size()));
    for (const auto& r : m.rectangles) {
        const Point a = m.nodes[r[0]], b = m.nodes[r[2]];
        for (const int n : r) area(n) += 0.25 * (b.x - a.x) * (b.z - a.z);
    }
    for (const auto& t : m.triangles) // the shapes of the corners have no volume
        for (int k = 3; k < 6; ++k) area(t[k]) += triangle_area(corners(m, t)) / 3.0;
    return area;
}

} // namespace dem
