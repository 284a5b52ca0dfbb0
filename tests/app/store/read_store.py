#!/usr/bin/python3
"""Runs the five lines of docs/store.md on a study, and checks the datasets that it lists.

read_store.py PROGRAM DOCS   the test program, which writes paper.h5; docs/store.md

Exit code 0: good, 1: not, 77: skipped, h5py is not installed.
"""
import os
import re
import subprocess
import sys
import tempfile
import types

try:
    import h5py
    import numpy
except ImportError:
    print("skipped: python3-h5py is not installed")
    sys.exit(77)

plotted = []


def stand_in_for_matplotlib():
    """Takes note of what is plotted: matplotlib need not be installed."""
    plot = types.ModuleType("matplotlib.pyplot")
    plot.plot = lambda x, y: plotted.append((x, y))
    for name in ("xlabel", "ylabel", "savefig"):
        setattr(plot, name, lambda text: None)
    sys.modules["matplotlib"] = types.ModuleType("matplotlib")
    sys.modules["matplotlib"].pyplot = plot
    sys.modules["matplotlib.pyplot"] = plot


def check_layout(study, text):
    table = text.split("## Layout 2")[1].split("\nAttributes of")[0]
    for line in table.splitlines():
        for path in re.findall(r"`(/[a-z_/]+[a-z])`", line):
            assert path in study or "Only in files of" in line, f"{path} is documented, not there"
    n = len(study["walls/level"])
    for group in ("responses", "counts", "cost"):
        assert len(study[group]) > 0
        for name, data in study[group].items():
            assert data.shape == (n,), name
            assert data.attrs["unit"] and "meaning" in data.attrs, name
    assert study["walls/inputs"].shape == (n, len(study["walls/input_name"]))
    assert len(study["curves/offset"]) == n + 1
    assert study["curves/offset"][-1] == len(study["curves/force"])
    keys = list(zip(study["walls/level"], study["walls/sample"]))
    assert keys == sorted(keys)
    failed = study["walls/status"][:] != 0
    assert ((study["walls/reason"][:] != b"") == failed).all()
    for path, axes in (("walls/inputs", ["/wall", "/input"]), ("responses/peak_force", ["/wall"]),
                       ("curves/force", ["/curve_point"]), ("levels/samples", ["/stress_level"])):
        if path in study:
            assert [axis[0].name for axis in study[path].dims] == axes, path
    study.visititems(lambda name, item: named(name, item))
    assert "vertical" not in study["configuration"][0].decode()
    assert study.attrs["layout"] == 2


def named(name, item):
    """netCDF programs open a file only if every axis has a name."""
    if isinstance(item, h5py.Dataset) and item.attrs.get("CLASS") != b"DIMENSION_SCALE":
        assert all(len(axis) == 1 for axis in item.dims), name


def main():
    with open(sys.argv[2], encoding="utf-8") as docs:
        text = docs.read()
    lines = re.search(r"```python\n(.*?)```", text, re.S).group(1)
    assert lines.count("\n") == 5, "five lines"
    stand_in_for_matplotlib()
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "DRYSTONE_STORE_FOLDER": folder}
        subprocess.run([os.path.abspath(sys.argv[1]), "[h5py]"], env=environment, check=True,
                       stdout=subprocess.DEVNULL)
        os.chdir(folder)
        names = {}
        exec(lines, names)
        (x, y), = plotted
        with open("row17.txt", encoding="ascii") as expected:
            points = [[float(word) for word in line.split()] for line in expected]
        wanted = numpy.array(points).reshape(-1, 2)
        assert numpy.array_equal(x, 1e3 * wanted[:, 0], equal_nan=True), "displacement"
        assert numpy.array_equal(y, 1e-3 * wanted[:, 1], equal_nan=True), "force"
        assert len(x) > 10
        check_layout(names["study"], text)
    print(f"{len(x)} points plotted")


main()
