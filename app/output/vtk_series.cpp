#include "app/output/vtk_series.hpp"

#include "app/output/block_displacement.hpp"
#include "app/output/vtk_grid.hpp"

#include <cstddef>
#include <vector>

namespace app {

namespace {

std::vector<VtkArray> load_data(const dem::Snapshot& wall)
{
    std::vector<VtkArray> data = {vtk_reals("load_displacement"), vtk_reals("force")};
    data[0].add(wall.displacement);
    data[1].add(wall.force);
    return data;
}

/// Between the two sides of a face.
dem::Point middle_displacement(const dem::Snapshot& wall, const dem::FaceState& face,
                               dem::Point at)
{
    const dem::Point a = displacement_at(wall, face.block_a, at);
    const dem::Point b = displacement_at(wall, face.block_b, at);
    return {0.5 * (a.x + b.x), 0.5 * (a.z + b.z)};
}

int kind_number(dem::FaceKind kind)
{
    switch (kind) {
    case dem::FaceKind::bed_joint:
        return 0;
    case dem::FaceKind::head_joint:
        return 1;
    case dem::FaceKind::unit_crack:
        return 2;
    case dem::FaceKind::beam_joint:
        return 3;
    case dem::FaceKind::base_joint:
        return 4;
    }
    return -1;
}

} // namespace

std::string blocks_vtu(const dem::Snapshot& wall)
{
    VtkGrid grid;
    VtkArray displacement = vtk_vectors("displacement");
    VtkArray course = vtk_integers("course"), unit = vtk_integers("unit"),
             index = vtk_integers("block");
    for (const dem::BlockState& block : wall.blocks) {
        index.add(index.tuples);
        course.add(block.course);
        unit.add(block.unit);
        for (std::size_t i = 0; i < block.outline.size(); ++i) {
            grid.add_point(block.outline[i]);
            displacement.add(block.displacement.at(i));
        }
        grid.end_cell(kVtkPolygon);
    }
    grid.point_data = {displacement};
    grid.cell_data = {course, unit, index};
    grid.field_data = load_data(wall);
    return vtu_text(grid);
}

std::string joints_vtu(const dem::Snapshot& wall)
{
    VtkGrid grid;
    VtkArray displacement = vtk_vectors("displacement");
    VtkArray opening = vtk_reals("opening"), slip = vtk_reals("slip"),
             sigma = vtk_reals("sigma");
    VtkArray tau = vtk_reals("tau"), damage = vtk_reals("damage"), area = vtk_reals("area");
    VtkArray kind = vtk_integers("kind"), id = vtk_integers("id");
    VtkArray block_a = vtk_integers("block_a"), block_b = vtk_integers("block_b");
    VtkArray normal = vtk_vectors("normal");
    for (const dem::FaceState& face : wall.faces) {
        if (face.contacts.empty()) continue;
        for (const dem::ContactState& c : face.contacts) {
            grid.add_point(c.at);
            displacement.add(middle_displacement(wall, face, c.at));
            opening.add(c.opening);
            slip.add(c.slip);
            sigma.add(c.sigma);
            tau.add(c.tau);
            damage.add(c.damage);
            area.add(c.area);
        }
        kind.add(kind_number(face.kind));
        id.add(face.id);
        block_a.add(face.block_a);
        block_b.add(face.block_b);
        normal.add(face.normal);
        grid.end_cell(face.contacts.size() == 1 ? kVtkVertex : kVtkPolyLine);
    }
    grid.point_data = {displacement, opening, slip, sigma, tau, damage, area};
    grid.cell_data = {kind, id, block_a, block_b, normal};
    grid.field_data = load_data(wall);
    return vtu_text(grid);
}

} // namespace app
