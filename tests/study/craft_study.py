"""craft_study.py STUDY.h5 OUT.h5 CRAFT   a copy of a study as a stranger may send it: all checksums are right"""
import shutil
import sys

import h5py
import numpy


def replace(file, name, values):
    about = dict(file[name].attrs)
    del file[name]
    made = file.create_dataset(name, data=values)
    for key in ("unit", "meaning"):
        if key in about:
            made.attrs.create(key, about[key], dtype=h5py.string_dtype("utf-8", len(about[key])))


def outside(file):
    walls = file["curves/force"].shape
    del file["curves/force"]
    file.create_dataset("curves/force", walls, "f8", external=[("/etc/passwd", 0, 8 * walls[0])])


def other_configuration(file):
    text = file["configuration"][0].replace(b"length                  = 0.60 m", b"length                  = 0.80 m")
    replace(file, "configuration", numpy.array([text], dtype=h5py.string_dtype("utf-8", len(text))))


def with_point(file, value, name="force"):
    file["curves/" + name][5] = value


crafts = {
    "stack": lambda f: f.attrs.__setitem__("seed", numpy.full(1000, 0x4141414141414141, "u8")),
    "heap": lambda f: f["responses"].attrs.create("columns", numpy.array([b"A" * 16] * 3900, dtype=h5py.string_dtype("utf-8", 16))),
    "sizes": lambda f: replace(f, "design_sizes", numpy.zeros(0, "u4")),
    "nan": lambda f: with_point(f, numpy.nan),
    "fall": lambda f: with_point(f, -1.0, "displacement"),
    "outside": outside,
    "configuration": other_configuration,
    "column": lambda f: f.__delitem__("counts/outcome"),
    "zeros": lambda f: f["curves/force"].write_direct(numpy.zeros(f["curves/force"].shape)),
}
study, out, craft = sys.argv[1:]
shutil.copy(study, out)
with h5py.File(out, "r+", libver="v110") as opened:
    crafts[craft](opened)
