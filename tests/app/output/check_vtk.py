#!/usr/bin/python3
"""Reads a time series with the reader of VTK (Debian: python3-vtk9) and checks cells, arrays and numbers.

check_vtk.py FOLDER   a folder with wall.pvd and joints.pvd, e.g. of a push
check_vtk.py PROGRAM  the test program, which writes such a folder and what its files must hold

Exit code 0: good, 1: not, 77: skipped, VTK is not installed.
"""
import math
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

try:
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    print("skipped: python3-vtk9 is not installed")
    sys.exit(77)

VERTEX, POLY_LINE, POLYGON = 1, 4, 7
ARRAYS = {  # point arrays, cell arrays with their numbers of components; cell types
    "wall": ({"displacement": 3}, {"course": 1, "unit": 1, "block": 1}, {POLYGON}),
    "joints": (
        {"displacement": 3, "opening": 1, "slip": 1, "sigma": 1, "tau": 1, "damage": 1, "area": 1},
        {"kind": 1, "id": 1, "block_a": 1, "block_b": 1, "normal": 3},
        {VERTEX, POLY_LINE},
    ),
}


def fail(file, reason):
    print(f"{file}: {reason}")
    sys.exit(1)


def read_grid(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    errors = []
    reader.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
    reader.Update()
    if errors:
        fail(path, "VTK reports an error")
    return reader.GetOutput()


def check_arrays(path, data, arrays, tuples):
    for name, components in arrays.items():
        array = data.GetArray(name)
        if array is None:
            fail(path, f"array {name} is missing")
        if array.GetNumberOfComponents() != components or array.GetNumberOfTuples() != tuples:
            fail(path, f"array {name} has {array.GetNumberOfTuples()} x {array.GetNumberOfComponents()} values")
        for i in range(tuples):
            if not all(math.isfinite(v) for v in array.GetTuple(i)):
                fail(path, f"array {name} holds a value that is not finite")


def area(cell):
    """Of a polygon in the plane of the wall; positive if counter-clockwise."""
    points = [cell.GetPoints().GetPoint(i) for i in range(cell.GetNumberOfPoints())]
    pairs = zip(points, points[1:] + points[:1])
    return 0.5 * sum(p[0] * q[2] - q[0] * p[2] for p, q in pairs)


def check_grid(path, kind):
    grid = read_grid(path)
    point_arrays, cell_arrays, types = ARRAYS[kind]
    if grid.GetNumberOfCells() == 0:
        fail(path, "no cells")
    check_arrays(path, grid.GetPointData(), point_arrays, grid.GetNumberOfPoints())
    check_arrays(path, grid.GetCellData(), cell_arrays, grid.GetNumberOfCells())
    check_arrays(path, grid.GetFieldData(), {"load_displacement": 1, "force": 1}, 1)
    used = 0
    for i in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(i)
        used += cell.GetNumberOfPoints()
        if cell.GetCellType() not in types:
            fail(path, f"cell {i} has type {cell.GetCellType()}")
        if kind == "wall" and not area(cell) > 0.0:
            fail(path, f"block {i} has no area or runs clockwise")
    if used != grid.GetNumberOfPoints():
        fail(path, "points without a cell")
    return grid


def check_series(folder, kind):
    pvd = os.path.join(folder, kind + ".pvd")
    entries = xml.etree.ElementTree.parse(pvd).getroot().findall("Collection/DataSet")
    if not entries:
        fail(pvd, "no files")
    times = [float(entry.get("timestep")) for entry in entries]
    if any(b <= a for a, b in zip(times, times[1:])):
        fail(pvd, "time does not grow")
    return {e.get("file"): check_grid(os.path.join(folder, e.get("file")), kind) for e in entries}


def check_expected(folder, grids):
    """Sums are taken in the order of the file: equal to the last bit if every double was read back."""
    with open(os.path.join(folder, "expected.txt"), encoding="ascii") as lines:
        expected = [line.split() for line in lines]
    if len(expected) != len(grids):
        fail(folder, f"{len(grids)} files instead of {len(expected)}")
    for file, cells, points, total in expected:
        grid = grids[file]
        name, component = ("displacement", 2) if file.startswith("wall") else ("opening", 0)
        array = grid.GetPointData().GetArray(name)
        found = 0.0
        for i in range(grid.GetNumberOfPoints()):
            found += array.GetComponent(i, component)
        if grid.GetNumberOfCells() != int(cells) or grid.GetNumberOfPoints() != int(points):
            fail(file, f"{grid.GetNumberOfCells()} cells, {grid.GetNumberOfPoints()} points")
        if found != float(total):
            fail(file, f"sum of {name} is {found!r} instead of {total}")


def check_folder(folder):
    grids = {**check_series(folder, "wall"), **check_series(folder, "joints")}
    print(f"{len(grids)} files read")
    return grids


def main():
    if len(sys.argv) != 2:
        print(__doc__)
        sys.exit(1)
    target = os.path.abspath(sys.argv[1])
    if os.path.isdir(target):
        check_folder(target)
        return
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "DRYSTONE_VTK_FOLDER": folder}
        subprocess.run([target, "[vtk_reader]"], env=environment, check=True, stdout=subprocess.DEVNULL)
        check_expected(folder, check_folder(folder))


main()
