#include "dem/scene/mechanism/snapshot_vtu.hpp"

#include "dem/scene/mechanism/block_displacement.hpp"
#include "dem/scene/mechanism/vtk_grid.hpp"

#include <array>
#include <charconv>
#include <cstddef>
#include <vector>

namespace dem {

namespace {

// The kinds of face in the file are counted in this order.
static_assert(static_cast<int>(FaceKind::bed_joint) == 0 &&
              static_cast<int>(FaceKind::head_joint) == 1 &&
              static_cast<int>(FaceKind::unit_crack) == 2 &&
              static_cast<int>(FaceKind::beam_joint) == 3 &&
              static_cast<int>(FaceKind::base_joint) == 4);

struct ContactNumber {
    const char* name;
    double ContactState::*value;
};
constexpr std::array kContactNumbers = {ContactNumber{"opening", &ContactState::opening},
                                        ContactNumber{"slip", &ContactState::slip},
                                        ContactNumber{"sigma", &ContactState::sigma},
                                        ContactNumber{"tau", &ContactState::tau},
                                        ContactNumber{"damage", &ContactState::damage},
                                        ContactNumber{"area", &ContactState::area}};

std::vector<VtkArray> load_data(const Snapshot& wall)
{
    std::vector<VtkArray> data = {vtk_reals("load_displacement"), vtk_reals("force")};
    data[0].add(wall.displacement);
    data[1].add(wall.force);
    return data;
}

/// Between the two sides of a face.
Point middle_displacement(const Snapshot& wall, const FaceState& face, Point at)
{
    const Point a = displacement_at(wall, face.block_a, at);
    const Point b = displacement_at(wall, face.block_b, at);
    return {0.5 * (a.x + b.x), 0.5 * (a.z + b.z)};
}

} // namespace

std::string blocks_vtu(const Snapshot& wall)
{
    VtkGrid grid;
    VtkArray displacement = vtk_vectors("displacement");
    VtkArray course = vtk_integers("course"), unit = vtk_integers("unit"),
             index = vtk_integers("block");
    for (const BlockState& block : wall.blocks) {
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

std::string joints_vtu(const Snapshot& wall)
{
    VtkGrid grid;
    grid.point_data = {vtk_vectors("displacement")};
    for (const ContactNumber& n : kContactNumbers) grid.point_data.push_back(vtk_reals(n.name));
    VtkArray kind = vtk_integers("kind"), id = vtk_integers("id");
    VtkArray block_a = vtk_integers("block_a"), block_b = vtk_integers("block_b");
    VtkArray normal = vtk_vectors("normal");
    for (const FaceState& face : wall.faces) {
        if (face.contacts.empty()) continue;
        for (const ContactState& c : face.contacts) {
            grid.add_point(c.at);
            grid.point_data[0].add(middle_displacement(wall, face, c.at));
            for (std::size_t i = 0; i < kContactNumbers.size(); ++i)
                grid.point_data[i + 1].add(c.*kContactNumbers[i].value);
        }
        kind.add(static_cast<int>(face.kind));
        id.add(face.id);
        block_a.add(face.block_a);
        block_b.add(face.block_b);
        normal.add(face.normal);
        grid.end_cell(face.contacts.size() == 1 ? kVtkVertex : kVtkPolyLine);
    }
    grid.cell_data = {kind, id, block_a, block_b, normal};
    grid.field_data = load_data(wall);
    return vtu_text(grid);
}

std::string pvd_text(const std::vector<double>& times, const std::vector<std::string>& files)
{
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
                       "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (std::size_t i = 0; i < times.size(); ++i) {
        std::array<char, 32> time; // the shortest text that reads back as the same double
        const auto end = std::to_chars(time.data(), time.data() + time.size(), times[i]).ptr;
        text += "<DataSet timestep=\"" + std::string(time.data(), end) +
                "\" part=\"0\" file=\"" + files.at(i) + "\"/>\n";
    }
    return text + "</Collection>\n</VTKFile>\n";
}

} // namespace dem
