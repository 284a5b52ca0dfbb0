#!/usr/bin/python3
"""What the Python module says of bad input, against the program."""
import math
import unittest
import warnings

import drystone

from scene import InFolder, QUICK, run, sets, STUDY, WALL


class ErrorsAreThoseOfTheProgram(InFolder):
    def test_text(self):
        study = self.folder / "wall.ini"
        study.write_text(WALL.read_text().replace("friction_angle", "friction_angel", 1))
        for path, settings in ((study, {}), (WALL, {"joint.friction_angle": "100 deg"}), (WALL, {"wall.lenght": 1}),
                               (self.folder / "none.ini", {}), (QUICK, {})):
            said = run("push", path, "--out", self.folder / "out", *sets(settings))
            self.assertEqual(said.returncode, 2)
            with self.assertRaises(drystone.ConfigError) as caught:
                drystone.push(path, set=settings)
            self.assertEqual(str(caught.exception) + "\n", said.stderr)
            self.assertIsInstance(caught.exception, ValueError)

    def test_files(self):
        damaged = self.folder / "damaged.h5"
        damaged.write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(100))
        for path in (self.folder / "none.h5", damaged):
            said = run("curves", path, "--out", self.folder / "out.csv")
            with self.assertRaises((drystone.StoreError, drystone.ConfigError)) as caught:
                drystone.open(path)
            self.assertEqual(str(caught.exception), said.stderr.strip().removeprefix("drystone: "))

    def test_fits(self):
        fit = drystone.fragility.fit
        with self.assertRaisesRegex(drystone.NoFit, "all 4 are right-censored"):
            fit([1, 2, 3, 4], [True] * 4)
        with self.assertRaisesRegex(drystone.NoFit, "not a number"):
            fit([1, 2, math.nan])
        with self.assertRaisesRegex(drystone.NoFit, "positive values only"):
            fit([1, 2, 0, 3])
        with self.assertRaisesRegex(ValueError, "censored: must be as long as values"):
            fit([1, 2, 3], [True])
        with self.assertRaisesRegex(ValueError, "censored: must be True or False"):
            fit([1, 2, 3], [0, 0.5, 1])
        with self.assertRaisesRegex(ValueError, "censored: must be True or False"):
            fit([1, 2, 3], ["no", "no", "yes"])
        with self.assertRaisesRegex(ValueError, "law: .* is none of lognormal"):
            fit([1, 2, 3], law="cauchy")
        with self.assertRaises(ValueError):
            drystone.fragility.kaplan_meier([1, 2, 3], confidence=1.5)

    def test_walls(self):
        study = drystone.Study(QUICK, set=STUDY)
        with self.assertRaises(IndexError):
            study.push([6])
        with self.assertRaises(IndexError):
            study.draws(3)
        with self.assertRaises(TypeError):
            study.push(inputs=[[0.5, 1, 3.7e6, 0.6, 1]])
        for bad, message in (([[2.0, 1, 3.7e6, 0.6, 1]], "joint.friction_angle = 2 rad is out of range"),
                             ([[0.5, 1, 3.7e6, 0.6]], "4 values; the wall takes 5"),
                             ([[0.5, 1, math.nan, 0.6, 1]], "unit.tensile_strength = nan Pa is out of range")):
            with self.assertRaisesRegex(drystone.ConfigError, message):
                study.push(inputs=bad, level=0)

    def test_keys_without_effect(self):
        with self.assertWarnsRegex(UserWarning, "uq.kernel: no effect"):
            drystone.Study(QUICK, set={"uq.kernel": "matern"})
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            drystone.Study(QUICK)


unittest.main()
