#!/usr/bin/python3
"""Walls shaken by the Python module, against the files of the command line."""
import json
import pathlib
import unittest

import numpy

import drystone

from scene import InFolder, WALL, run, sets

SHAKEN = pathlib.Path(WALL).parent / "shaken.ini"
CHEAP = {"solver.fidelity": "rigid", "wall.courses": 4, "shaking.contact_damping": 0.05,
         "shaking.records": "half_sine(peak 0.6 g, duration 0.1 s)"}


class ShakeIsThatOfTheCommandLine(InFolder):
    def test_history_and_summary(self):
        out = self.folder / "shaken"
        done = run("shake", SHAKEN, "--out", out, "--quiet", *sets(CHEAP))
        self.assertEqual(done.returncode, 0, done.stderr)
        history, = drystone.shake(SHAKEN, set=CHEAP)
        self.assertEqual(history.summary, json.loads((out / "summary.json").read_text()))
        rows = numpy.loadtxt(out / "history.csv", delimiter=",", skiprows=1)
        numpy.testing.assert_allclose(rows[:, 0], history.time, rtol=1e-8)
        numpy.testing.assert_allclose(rows[:, 2], 1e3 * history.displacement, rtol=1e-8, atol=1e-12)
        numpy.testing.assert_allclose(rows[:, 3], 1e2 * history.drift, rtol=1e-8, atol=1e-12)
        self.assertFalse(history.failed)
        self.assertIn("half_sine", history.motion)

    def test_one_for_each_intensity(self):
        two = drystone.shake(SHAKEN, set={**CHEAP, "shaking.intensities": "0.1, 0.2 g"})
        self.assertEqual([h.summary["peak_ground_acceleration_g"] for h in two], [0.1, 0.2])

    def test_study_of_histories_is_not_pushed(self):
        study = drystone.Study(SHAKEN, set=CHEAP)
        with self.assertRaisesRegex(drystone.ConfigError, "shaking.records: this study shakes walls"):
            study.run(self.folder / "a.h5")


if __name__ == "__main__":
    unittest.main()
