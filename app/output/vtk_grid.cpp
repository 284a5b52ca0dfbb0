#include "app/output/vtk_grid.hpp"

#include "app/input/number_text.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace app {

namespace {

constexpr const char* kHeader = "<?xml version=\"1.0\"?>\n";

void append(VtkArray& array, const std::string& value)
{
    array.values += value;
    array.values += ++array.tuples % 8 == 0 ? '\n' : ' ';
}

std::string checked(const VtkArray& array, double value)
{
    if (!std::isfinite(value))
        throw std::invalid_argument("time series: a value of '" + array.name +
                                    "' is not finite");
    return number(value, 17);
}

std::string array_text(const VtkArray& array, bool field)
{
    std::string text = "<DataArray type=\"" + array.type + "\" Name=\"" + array.name + '"';
    if (array.components > 1)
        text += " NumberOfComponents=\"" + std::to_string(array.components) + '"';
    if (field) text += " NumberOfTuples=\"" + std::to_string(array.tuples) + '"';
    return text + " format=\"ascii\">\n" + array.values + "\n</DataArray>\n";
}

std::string section(const std::string& name, const std::vector<VtkArray>& arrays)
{
    std::string text = '<' + name + ">\n";
    for (const VtkArray& array : arrays) text += array_text(array, name == "FieldData");
    return text + "</" + name + ">\n";
}

} // namespace

void VtkArray::add(double value) { append(*this, checked(*this, value)); }
void VtkArray::add(int value) { append(*this, std::to_string(value)); }
void VtkArray::add(dem::Point vector)
{
    append(*this, checked(*this, vector.x) + " 0 " + checked(*this, vector.z));
}

VtkArray vtk_reals(std::string name) { return {std::move(name), "Float64"}; }
VtkArray vtk_vectors(std::string name) { return {std::move(name), "Float64", 3}; }
VtkArray vtk_integers(std::string name) { return {std::move(name), "Int32"}; }

void VtkGrid::add_point(dem::Point at)
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
    return std::string(kHeader) +
           "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n<UnstructuredGrid>\n" +
           section("FieldData", grid.field_data) + "<Piece NumberOfPoints=\"" +
           std::to_string(grid.points.tuples) + "\" NumberOfCells=\"" +
           std::to_string(grid.types.tuples) + "\">\n" + section("PointData", grid.point_data) +
           section("CellData", grid.cell_data) + section("Points", {grid.points}) +
           section("Cells", {grid.connectivity, grid.offsets, grid.types}) +
           "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string pvd_text(const std::vector<double>& times, const std::vector<std::string>& files)
{
    std::string text = std::string(kHeader) + "<VTKFile type=\"Collection\" version=\"1.0\" "
                                              "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (std::size_t i = 0; i < times.size(); ++i)
        text += "<DataSet timestep=\"" + number(times[i], 17) + "\" part=\"0\" file=\"" +
                files.at(i) + "\"/>\n";
    return text + "</Collection>\n</VTKFile>\n";
}

} // namespace app
