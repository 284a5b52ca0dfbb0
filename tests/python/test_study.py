#!/usr/bin/python3
"""Studies of the Python module and their files, against those of the command line."""
import unittest

import numpy

import drystone

from scene import InFolder, QUICK, STUDY, as_written, run, sets, table


class StudyIsThatOfTheCommandLine(InFolder):
    def command_line(self):
        file = self.folder / "by_program.h5"
        done = run("study", QUICK, "--out", file, "--quiet", *sets(STUDY))
        self.assertEqual(done.returncode, 0, done.stderr)
        return file

    def check_equal(self, mine, theirs):
        self.assertEqual(len(mine), 18)
        self.assertEqual(mine.configuration, theirs.configuration)
        for name in ("level", "sample", "failed", "vertical_stress"):
            self.same(getattr(mine, name), getattr(theirs, name))
        for group in ("inputs", "responses", "counts"):
            self.assertEqual(list(getattr(mine, group)), list(getattr(theirs, group)))
            for name, array in getattr(mine, group).items():
                self.same(array, getattr(theirs, group)[name])
        for a, b in zip(mine.curves, theirs.curves):
            self.same(a[0], b[0])
            self.same(a[1], b[1])

    def check_hdf5(self, results):
        try:
            import h5py
        except ImportError:
            print("without python3-h5py: not compared with its arrays")
            return
        with h5py.File(results.path, "r") as file:
            for i, name in enumerate(results.inputs):
                self.same(results.inputs[name], file["walls/inputs"][:, i])
            for name, array in results.responses.items():
                self.same(array, file["responses"][name][:])
                self.assertEqual(results.units[name], file["responses"][name].attrs["unit"].decode())
            at = file["curves/offset"][:]
            for i, (displacement, force) in enumerate(results.curves):
                self.same(displacement, file["curves/displacement"][at[i]:at[i + 1]])
                self.same(force, file["curves/force"][at[i]:at[i + 1]])

    def test_bond(self):
        bond = drystone.Study(QUICK).bond
        self.assertAlmostEqual(bond["trace"], 1.9)  # ten head joints of 0.1 m, nine half units of 0.1 m
        self.assertAlmostEqual(bond["mean_length"], 10 / 55)
        self.assertAlmostEqual(bond["filled"], 1.0)

    def test_study(self):
        theirs = drystone.open(self.command_line())
        study = drystone.Study(QUICK, set=STUDY)
        seen = []
        mine = study.run(self.folder / "mine.h5", progress=lambda *p: seen.append(p))
        self.check_equal(mine, theirs)
        self.check_hdf5(theirs)
        self.assertFalse(theirs.failed.any() or any(theirs.reasons) or theirs.missing)
        self.assertEqual(seen, [(done, 0, 18) for done in range(19)])
        for suffix in (".csv", ".md", ".tex"):
            self.assertEqual((self.folder / f"mine_summary{suffix}").read_text().replace("mine", ""),
                             (self.folder / f"by_program_summary{suffix}").read_text().replace("by_program", ""))
        self.check_chosen(study, theirs)
        self.check_drifts(theirs)
        self.check_frames(study, theirs)

    def test_solver_error(self):
        study = drystone.Study(QUICK, set={**STUDY, "uq.samples": 2, "uq.audit": 1, "solver.accuracy": "2 %"})
        seen = []
        results = study.run(self.folder / "audited.h5", progress=lambda *p: seen.append(p))
        self.assertEqual((len(results), results.missing), (6, 0))
        self.assertEqual(len(results.vertical_stress), 3)
        self.assertEqual(seen[-1], (3, 0, 3))
        self.same(results.solver_error, results.responses["solver_error"])
        self.assertTrue((results.solver_error >= 0).all())
        self.same(results.points_error, results.responses["points_error"])
        self.assertTrue((results.points_error > 0).all())
        self.assertIn("Error by the number of contact points: median", results.solver_error_text)
        self.assertEqual(list(results.audit["level"]), [0, 1, 2])
        self.assertEqual(list(results.audit["sample"]), [0, 0, 0])
        self.assertTrue((results.audit["peak_force"] < 0.5).all())
        self.assertIn("of 6 walls above the 2 % asked for", results.solver_error_text)
        self.assertIn("3 of 6 walls pushed again 4 times slower", results.solver_error_text)
        self.assertEqual(len(results.curves), 6)
        wall, = study.push([1], level=2)
        self.assertEqual(wall.solver_error, results.solver_error[5])
        self.assertEqual(wall.points_error, results.points_error[5])
        self.assertEqual(wall.summary["solver_error_percent"], as_written(100 * wall.solver_error))

    def test_both_ways(self):
        door = {**STUDY, "uq.samples": 2, "wall.openings": "0.1 m, 0 m, 0.3 m, 0.3 m", "load.vertical_stress": "0.5 MPa",
                "joint.wall_modulus": "768 MPa"}
        both, right, left = (drystone.Study(QUICK, set={**door, "load.direction": way}).run(self.folder / f"{way}.h5")
                             for way in ("both", "right", "left"))
        self.same(both.responses["peak_force"], right.responses["peak_force"])
        self.same(both.other_way["peak_force"], left.responses["peak_force"])
        self.assertEqual(list(both.other_way["sample"]), [0, 1])
        self.assertEqual(len(right.other_way["sample"]), 0)
        limits = [r.readings()["ntc SLO"] for r in (both, right, left)]
        self.same(limits[0], numpy.minimum(limits[1], limits[2]))
        self.assertEqual((len(both), both.missing, len(both.curves), len(both.readings()["mode"])), (2, 0, 2, 2))

    def check_chosen(self, study, theirs):
        """Draws and chosen walls."""
        self.assertEqual(study.samples, 6)
        self.assertEqual(study.inputs, list(theirs.inputs))
        self.assertEqual(study.units, [theirs.units[name] for name in study.inputs])
        for level in range(3):
            rows = numpy.column_stack([a[theirs.level == level] for a in theirs.inputs.values()])
            self.assertTrue(numpy.array_equal(study.draws(level), rows))
        walls = study.push([4, 0], level=2) + study.push(inputs=study.draws(2)[[4, 0]], level=2)
        for wall, sample in zip(walls, (4, 0, 4, 0)):
            i, = numpy.flatnonzero((theirs.level == 2) & (theirs.sample == sample))
            self.same(wall.displacement, theirs.curves[i][0])
            self.same(wall.force, theirs.curves[i][1])
            self.assertEqual(wall.summary["peak_force_kN"], as_written(theirs.responses["peak_force"][i] * 1e-3))
        self.assertEqual([(w.level, w.sample) for w in walls], [(2, 4), (2, 0), (2, None), (2, None)])
        self.assertEqual([(w.level, w.sample) for w in study.push([1, 0])], [(0, 1), (0, 0), (1, 1), (1, 0), (2, 1), (2, 0)])

    def check_drifts(self, theirs):
        out = self.folder / "tables"
        self.assertEqual(run("fragility", theirs.path, "--out", out).returncode, 0)
        rows = table(out / "performance_limits.csv")
        self.assertEqual([row["limit state"] for row in rows[:len(theirs.limit_states)]], theirs.limit_states)
        for row in rows:
            level = [0.5, 1.0, 1.25].index(float(row["stress [MPa]"]))
            values, censored = theirs.drifts(row["limit state"], level)
            self.assertEqual(len(values), float(row["n"]))
            if len(values):
                self.assertEqual(100 * censored.mean(), float(row["censored [%]"]))
        with self.assertRaisesRegex(ValueError, "'SLV' is none of paper ultimate, ntc SLO"):
            theirs.drifts("SLV")

    def check_frames(self, study, theirs):
        try:
            import pandas  # noqa: F401
        except ImportError:
            print("without python3-pandas: no frames")
            return
        frame = theirs.frame()
        self.assertEqual(frame.loc[(2, 4), "peak_force"], theirs.responses["peak_force"][16])
        self.assertEqual(frame.loc[(1, 0), "vertical_stress"], 1.0e6)
        self.same(theirs.curve_frame().loc[(2, 4), "force"].to_numpy(), theirs.curves[16][1])
        self.assertTrue(numpy.array_equal(study.frame().loc[1].to_numpy(), study.draws(1)))
        wall = study.push([0], level=0)[0]
        self.assertEqual(list(wall.frame().columns), ["displacement", "drift", "force"])

    def test_run_goes_on(self):
        whole = drystone.Study(QUICK, set=STUDY).run(self.folder / "whole.h5")
        file = self.folder / "grown.h5"
        part = drystone.Study(QUICK, set=STUDY)

        def stop(done, failed, all):
            if done == 5:
                raise RuntimeError("enough")
        with self.assertRaisesRegex(RuntimeError, "enough"):
            part.run(file, progress=stop)
        left = drystone.open(file)
        self.assertTrue(5 <= len(left) < 18 and left.missing == 18 - len(left), left)
        self.check_equal(part.run(file), whole)


unittest.main()
