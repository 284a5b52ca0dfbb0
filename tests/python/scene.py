"""What the tests of the Python module share.

DRYSTONE_PROGRAM, DRYSTONE_SOURCE_DIR: the program and the sources; PYTHONPATH: the folder of the module.
"""
import csv
import os
import pathlib
import subprocess
import tempfile
import unittest
import warnings

PROGRAM = os.environ["DRYSTONE_PROGRAM"]
ROOT = pathlib.Path(os.environ["DRYSTONE_SOURCE_DIR"])
WALL, QUICK = ROOT / "configs/wall.ini", ROOT / "configs/quick.ini"
CHEAP = {"solver.fidelity": "rigid", "solver.steps_per_mm": 100, "solver.accuracy": "20 %", "load.max_displacement": "3 mm"}
STUDY = {**CHEAP, "uq.samples": 6}
LONG = {"solver.fidelity": "fine", "load.max_displacement": "300 mm"}
RIGID = "wall.toe: no effect"  # of a rigid first course
TIMES = ("solver_seconds", "contact_updates_per_second")


def run(*words):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)


def sets(values):
    return [word for key, value in values.items() for word in ("--set", f"{key}={value}")]


def as_written(value):
    """A number as tables and summaries have it: of 15 digits (app/text/number_text.hpp)."""
    return float(f"{value:.15g}")


def table(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        warnings.filterwarnings("ignore", RIGID)

    def same(self, a, b):
        self.assertEqual(a.dtype, b.dtype)
        self.assertEqual(a.shape, b.shape)
        self.assertEqual(a.tobytes(), b.tobytes())
