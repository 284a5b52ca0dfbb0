#!/usr/bin/python3
"""Pushes of the Python module, against the files of the command line."""
import json
import unittest

import numpy

import drystone

from scene import CHEAP, InFolder, QUICK, as_written, run, sets, STUDY, TIMES, WALL


class PushIsThatOfTheCommandLine(InFolder):
    def check(self, study, settings, *words, **asked):
        out = self.folder / "wall"
        done = run("push", study, "--out", out, "--quiet", *sets(settings), *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        wall = drystone.push(study, set=settings, **asked)
        self.assertEqual(wall.capacity_csv(), (out / "capacity.csv").read_text())
        expected = json.loads((out / "summary.json").read_text())
        for key in TIMES:
            self.assertGreater(wall.summary[key], 0)
        strip = lambda summary: {k: v for k, v in summary.items() if k not in TIMES}
        self.assertEqual(strip(wall.summary), strip(expected))
        self.assertEqual(list(wall.summary), list(expected))
        return wall

    def test_numbers(self):
        wall = self.check(WALL, CHEAP)
        self.assertEqual(as_written(wall.force.max() * 1e-3), wall.summary["peak_force_kN"])
        self.assertEqual(wall.vertical_stress, 0.5e6)
        self.assertEqual(wall.drift[-1], wall.displacement[-1] / 1.1)
        self.assertFalse(wall.force.flags.writeable or wall.failed)
        self.assertEqual(wall.summary["displacement_at_peak_mm"], wall.summary["peak_displacement_mm"]) # of version 0.2
        self.assertEqual(wall.summary["mechanism"]["crushed_through_mm2"], wall.summary["mechanism"]["crushed_area_mm2"])
        self.assertRaises(KeyError, lambda: wall.summary["peak"])

    def test_other_way_of_a_wall_that_is_not_symmetric(self):
        wall = self.check(WALL, {**CHEAP, "wall.openings": "0.2 m, 0 m, 0.2 m, 0.3 m"})
        self.assertGreater(wall.summary["other_way"]["peak_force_kN"], 0)

    def test_key_taken_out(self):
        wall = drystone.push(WALL, set={**CHEAP, "joint.wall_modulus": None, "joint.normal_stiffness": "8 GPa/m"})
        self.assertNotIn("wall_modulus", wall.summary["study"])

    def test_wall_of_a_study(self):
        wall = self.check(QUICK, STUDY, "--sample", "3", "--level", "1.00 MPa", sample=3, level="1.00 MPa")
        self.assertEqual((wall.level, wall.sample), (1, 3))

    def test_sample_of_random_layouts(self):
        settings = {**STUDY, "wall.unit_length_cov": 0.1, "wall.layouts": 4}
        wall = self.check(QUICK, settings, "--sample", "5", "--level", "1.00 MPa", sample=5, level="1.00 MPa")
        walls = drystone.Study(QUICK, set=settings).push([1, 5], level=1)
        self.assertEqual([w.sample for w in walls], [1, 5])
        self.same(walls[1].force, wall.force)
        alone = {**STUDY, "wall.unit_length_cov": 0.1, "wall.seed": 2}  # the seed of samples 1 and 5
        self.same(drystone.push(QUICK, set=alone, sample=5, level="1.00 MPa").force, wall.force)

    def test_body_forces(self):
        study = self.folder / "body.ini"
        study.write_text("".join(line for line in WALL.open(encoding="utf-8") if not line.startswith("height  ")))
        wall = self.check(study, {**CHEAP, "load.pattern": "body", "beam.height": "0.1 m"})
        self.assertIn("load_factor", wall.capacity_csv().splitlines()[0])

    def test_values(self):
        settings = {**CHEAP, "uq.shared": True, "uq.samples": numpy.int64(8), "uq.seed": 2, "joint.wall_modulus": "768, 912 MPa",
                    "load.vertical_stress": "0.5, 0.7 MPa", "fragility.rotation_share": numpy.float64(0.6)}
        lines = [line.split("#")[0].split() for line in drystone.Study(QUICK, set=settings).configuration.splitlines()]
        for wanted in ("shared = yes", "samples = 8", "seed = 2", "rotation_share = 0.6", "vertical_stress = 0.5, 0.7 MPa"):
            self.assertIn(wanted.split(), lines)

    def test_arrays_outlive_the_wall(self):
        force = drystone.push(WALL, set=CHEAP).force
        self.assertEqual(force.max(), drystone.push(WALL, set=CHEAP).force.max())


unittest.main()
