#include "dem/scene/mechanism/vtk_grid.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace dem {

namespace {

template <class T> void append(VtkArray& array, T value)
{
    static_assert(std::endian::native == std::endian::little);
    const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    array.bytes.append(bytes.data(), bytes.size());
}

double checked(const VtkArray& array, double value)
{
    if (!std::isfinite(value))
        throw std::invalid_argument("time series: a value of '" + array.name +
                                    "' is not finite");
    return value;
}

/// The head of an array; its bytes go behind those of the others, each after their number.
std::string array_text(const VtkArray& array, bool field, std::string& appended)
{
    std::string text = "<DataArray type=\"" + array.type + "\" Name=\"" + array.name + '"';
    if (array.components > 1)
        text += " NumberOfComponents=\"" + std::to_string(array.components) + '"';
    if (field) text += " NumberOfTuples=\"" + std::to_string(array.tuples) + '"';
    text += " format=\"appended\" offset=\"" + std::to_string(appended.size()) + "\"/>\n";
    VtkArray size{"", "UInt64"};
    append(size, static_cast<std::uint64_t>(array.bytes.size()));
    appended += size.bytes + array.bytes;
    return text;
}

std::string section(const std::string& name, const std::vector<VtkArray>& arrays,
                    std::string& appended)
{
    std::string text = '<' + name + ">\n";
    for (const VtkArray& array : arrays)
        text += array_text(array, name == "FieldData", appended);
    return text + "</" + name + ">\n";
}

} // namespace

void VtkArray::add(double value)
{
    append(*this, checked(*this, value));
    ++tuples;
}

void VtkArray::add(int value)
{
    if (type == "Int64")
        append(*this, static_cast<std::int64_t>(value));
    else if (type == "UInt8")
        append(*this, static_cast<std::uint8_t>(value));
    else
        append(*this, static_cast<std::int32_t>(value));
    ++tuples;
}

void VtkArray::add(Point vector)
{
    for (const double x : {vector.x, 0.0, vector.z}) append(*this, checked(*this, x));
    ++tuples;
}

VtkArray vtk_reals(std::string name) { return {std::move(name), "Float64"}; }
VtkArray vtk_vectors(std::string name) { return {std::move(name), "Float64", 3}; }
VtkArray vtk_integers(std::string name) { return {std::move(name), "Int32"}; }

void VtkGrid::add_point(Point at)
{
    connectivity.add(points.tuples);
    points.add(at);
}

void VtkGrid::end_cell(int type)
{
    offsets.add(points.tuples);
    types.add(type);
}

std::string vtu_text(const VtkGrid& grid)
{
    std::string bytes;
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
                       "version=\"1.0\" byte_order=\"LittleEndian\" "
                       "header_type=\"UInt64\">\n<UnstructuredGrid>\n";
    text += section("FieldData", grid.field_data, bytes);
    text += "<Piece NumberOfPoints=\"" + std::to_string(grid.points.tuples) +
            "\" NumberOfCells=\"" + std::to_string(grid.types.tuples) + "\">\n";
    text += section("PointData", grid.point_data, bytes);
    text += section("CellData", grid.cell_data, bytes);
    text += section("Points", {grid.points}, bytes);
    text += section("Cells", {grid.connectivity, grid.offsets, grid.types}, bytes);
    return text + "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" + bytes +
           "\n</AppendedData>\n</VTKFile>\n";
}

} // namespace dem
