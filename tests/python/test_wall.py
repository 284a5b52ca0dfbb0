#!/usr/bin/python3
"""Walls given as polygons, against the same outlines in a study file and against the wall in courses."""
import unittest

import numpy

import drystone

from scene import CHEAP, InFolder, run, sets, WALL


def running_bond(length=1.0, courses=10, height=0.1, unit=0.2):
    for course in range(courses):
        first = 0.5 * unit if course % 2 else unit
        ends = [0.0, *numpy.arange(first, length - 1e-9, unit), length]
        for x0, x1 in zip(ends, ends[1:]):
            z0, z1 = course * height, (course + 1) * height
            yield numpy.round([(x0, z0), (x1, z0), (x1, z1), (x0, z1)], 9)


class WallOfPolygons(InFolder):
    def test_is_the_wall_of_the_command_line(self):
        wall = drystone.Wall(running_bond(), thickness=0.2, unit_length="0.2 m")
        push = drystone.push(WALL, set=CHEAP, wall=wall)
        lines = WALL.read_text().split("[stone]", 1)
        study = self.folder / "drawn.ini"
        keys = "".join(f"{key.split('.')[1]} = {value}\n" for key, value in wall.keys.items())
        study.write_text(f"[wall]\n{keys}[stone]{lines[1]}")
        done = run("push", study, "--out", self.folder / "wall", "--quiet", *sets(CHEAP))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(push.capacity_csv(), (self.folder / "wall/capacity.csv").read_text())

    def test_is_the_wall_in_courses(self):
        settings = {"load.max_displacement": "2 mm", "solver.accuracy": "0.3 %", "solver.fidelity": "simple"}
        drawn = drystone.push(WALL, set=settings, wall=drystone.Wall(running_bond(), 0.2, unit_length="0.2 m"))
        courses = drystone.push(WALL, set={**settings, "wall.toe": "free"})
        self.assertAlmostEqual(drawn.force.max() / courses.force.max(), 1.0, delta=1e-3)

    def test_either_direction_and_layers(self):
        units = [block[::-1] for block in running_bond(courses=2)]
        layers = [""] * len(units)
        layers[-1] = "lintel"
        wall = drystone.Wall(units, 0.2, layers, layer_stones="lintel: 30 GPa, 0.2, 2500 kg/m3")
        self.assertIn("lintel: ", wall.keys["wall.outlines"])
        study = drystone.Study(WALL, set={**CHEAP, "load.height": "0.3 m"}, wall=wall)
        self.assertIn("layer_stones", study.configuration)

    def test_a_study_without_a_file(self):
        settings = {"stone.young_modulus": "10 GPa", "stone.poisson_ratio": 0.2, "stone.density": "2000 kg/m3", "joint.normal_stiffness": "10 GPa/m",
                    "joint.friction_angle": "35 deg", "beam.height": "0.1 m", "beam.young_modulus": "30 GPa",
                    "beam.density": "2500 kg/m3", "load.vertical_stress": "0.2 MPa", "load.height": "0.5 m", **CHEAP}
        wall = drystone.Wall(running_bond(0.6, 4), thickness=0.2)
        self.assertGreater(drystone.push(set=settings, wall=wall).force.max(), 0.0)

    def test_bad(self):
        for blocks, message in (([], "one block"), ([[(0, 0), (1, 0)]], "n x 2 numbers"), ([[0, 1, 2]], "n x 2 numbers")):
            with self.assertRaisesRegex(ValueError, message):
                drystone.Wall(blocks, 0.2)
        with self.assertRaisesRegex(ValueError, "2 layers for 1 blocks"):
            drystone.Wall([[(0, 0), (1, 0), (1, 1)]], 0.2, ["", ""])
        over = [[(0, 0), (1, 0), (1, 1), (0, 1)], [(0.5, 0.5), (1.5, 0.5), (1.5, 1.5), (0.5, 1.5)]]
        with self.assertRaisesRegex(drystone.ConfigError, "this block overlaps"):
            drystone.Study(WALL, wall=drystone.Wall(over, 0.2))
        with self.assertRaisesRegex(drystone.ConfigError, "file of results"):
            drystone.Study("any.h5", wall=drystone.Wall(running_bond(), 0.2))

    def test_the_wall_of_mean_values(self):
        quick = WALL.with_name("quick.ini")
        mean = drystone.push(quick, set=CHEAP, sample="mean", level="1.00 MPa")
        run("push", quick, "--out", self.folder / "mean", "--quiet", "--sample", "mean", "--level", "1.00 MPa", *sets(CHEAP))
        self.assertEqual(mean.capacity_csv(), (self.folder / "mean/capacity.csv").read_text())


unittest.main()
