#pragma once
/// An unstructured grid in the format of VTK: XML, with the numbers appended as bytes.

#include "dem/scene/geometry/snapshot.hpp"

#include <string>
#include <vector>

namespace dem {

/// Values of one array. add() throws std::invalid_argument for a value that is not finite.
struct VtkArray {
    std::string name;
    std::string type; ///< of VTK XML: Float64, Int32, Int64, UInt8
    int components = 1;
    std::string bytes = {}; ///< of the values, little-endian
    int tuples = 0;

    void add(double value);
    void add(int value);
    /// In the plane of the wall: x along, z up; y = 0.
    void add(Point vector);
};

[[nodiscard]] VtkArray vtk_reals(std::string name);
[[nodiscard]] VtkArray vtk_vectors(std::string name);
[[nodiscard]] VtkArray vtk_integers(std::string name);

inline constexpr int kVtkVertex = 1, kVtkPolyLine = 4, kVtkPolygon = 7; // cell types of VTK

/// Cells over consecutive points.
struct VtkGrid {
    VtkArray points = vtk_vectors("Points");
    VtkArray connectivity = {"connectivity", "Int64"};
    VtkArray offsets = {"offsets", "Int64"};
    VtkArray types = {"types", "UInt8"};
    std::vector<VtkArray> point_data, cell_data, field_data;

    void add_point(Point at);
    /// Closes a cell over the points added since the last.
    void end_cell(int type);
};

/// The content of a .vtu file.
[[nodiscard]] std::string vtu_text(const VtkGrid& grid);

} // namespace dem
