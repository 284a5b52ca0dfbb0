#!/usr/bin/python3
"""Pictures, frames, cycles and readings in Python, against the files of the command line."""
import math
import unittest

import numpy

import drystone

from scene import CHEAP, InFolder, QUICK, ROOT, run, sets, STUDY, table, WALL


class PythonHasWhatTheFilesHave(InFolder):
    def pushed(self, settings):
        out = self.folder / "out"
        done = run("push", WALL, "--out", out, "--quiet", *sets(settings))
        self.assertEqual(done.returncode, 0, done.stderr)
        return out

    def test_pictures(self):
        settings = {**CHEAP, "output.snapshot_every": "1 mm"}
        out = self.pushed(settings)
        wall = drystone.push(WALL, set=settings, frames=True)
        self.assertEqual(wall.wall_svg(), (out / "wall.svg").read_text())
        self.assertEqual(wall.capacity_svg(), (out / "capacity.svg").read_text())
        self.assertEqual(len(wall.frames), len(list((out / "series").glob("wall_*.vtu"))))
        self.assertEqual(wall.frames[0].displacement, 0.0)
        self.assertAlmostEqual(wall.frames[-1].displacement, 3e-3)
        before, after = (frame.outlines for frame in (wall.frames[0], wall.frames[-1]))
        self.assertEqual({len(outlines) for outlines in (before, after)}, {101})
        top = after[-1] - before[-1]  # of the beam, which is pushed
        self.assertAlmostEqual(top[:, 0].max(), 3e-3, delta=5e-5)
        self.assertLess(abs(after[0] - before[0]).max(), 1e-3)

        plain = drystone.push(WALL, set=settings)
        self.assertEqual((plain.wall_svg(), len(plain.frames)), (wall.wall_svg(), 1))
        self.same(plain.force, wall.force)
        study = drystone.Study(QUICK, set=STUDY)
        self.assertEqual(len(study.push([0], level=0, frames=True)[0].wall_svg()) > 1000, True)
        with self.assertRaisesRegex(RuntimeError, "frames=True"):
            study.push([0], level=0)[0].wall_svg()

    def test_cycles(self):
        settings = {**{k: v for k, v in CHEAP.items() if k != "load.max_displacement"}, "load.amplitudes": "1, 2 mm", "load.repeats": 2}
        study = self.folder / "cyclic.ini"
        study.write_text("".join(line for line in WALL.read_text().splitlines(True) if not line.startswith("max_displacement")))
        out = self.folder / "out"
        self.assertEqual(run("push", study, "--out", out, "--quiet", *sets(settings)).returncode, 0)
        wall = drystone.push(study, set=settings)
        rows = table(out / "cycles.csv")
        self.assertEqual(len(rows), 4)
        units = {"mm": 1e3, "kN": 1e-3, "J": 1, "percent": 100, "kN_per_mm": 1e-6, "": 1}
        self.assertEqual(len(rows[0]), 20)
        columns = dict(wall.cycles)
        self.assertTrue((columns.pop("closing") == 0).all()) # a column of the file where joints lose energy as they close
        self.assertEqual(len(columns), 20)
        for (name, values), column in zip(columns.items(), rows[0]):
            self.assertTrue(column == name or column.startswith(name + "_"), (name, column))
            for value, row in zip(values * units[column[len(name):].removeprefix("_")], rows):
                self.assertEqual(math.isnan(value), row[column] == "", name)
                if row[column]:
                    self.assertTrue(math.isclose(value, float(row[column]), rel_tol=1e-8, abs_tol=1e-12), (name, value, row[column]))
        for side, curve in wall.backbones.items():
            points = [(float(r["displacement_mm"]), float(r["force_kN"])) for r in table(out / "backbones.csv") if r["side"] == side]
            self.assertTrue(numpy.allclose(numpy.column_stack([curve.displacement * 1e3, curve.force * 1e-3]), points, rtol=1e-8, atol=1e-9))
        self.assertEqual(len(drystone.push(WALL, set=CHEAP).cycles["energy"]), 1)

    def test_piers(self):
        """Those of piers.csv and spandrels.csv, and of the file of a study."""
        facade = ROOT / "configs/facade.ini"
        settings = {**CHEAP, "solver.accuracy": "20 %", "load.direction": "right"}
        out = self.folder / "out"
        self.assertEqual(run("push", facade, "--out", out, "--quiet", *sets(settings)).returncode, 0)
        wall = drystone.push(facade, set=settings)
        for part, columns, names in (
                (wall.piers, table(out / "piers.csv"), {"normal_before": "N before [kN]", "shear_at_peak": "V [kN]", "drift": "drift [%]"}),
                (wall.spandrels, table(out / "spandrels.csv"), {"largest_shear": "largest V [kN]", "drift": "drift [%]"})):
            self.assertGreater(len(columns), 1)
            for name, column in {"from": "from [m]", **names}.items():
                unit = {"[kN]": 1e-3, "[%]": 100, "[m]": 1}[column.split()[-1]]
                self.assertEqual(len(part[name]), len(columns))
                for value, row in zip(part[name] * unit, columns):
                    self.assertTrue(math.isclose(value, float(row[column]), rel_tol=1e-8, abs_tol=1e-12), (name, value, row[column]))
        self.assertEqual(wall.piers["mode"], [row["mode"] for row in table(out / "piers.csv")])
        self.assertEqual(len(drystone.push(WALL, set=CHEAP).piers["drift"]), 0)

        file = self.folder / "facade.h5"
        self.assertEqual(run("study", facade, "--out", file, "--quiet", *sets({**settings, "uq.samples": 1})).returncode, 0)
        spandrels = drystone.open(file).spandrels
        self.assertNotIn("storey", spandrels)
        for name in ("from", "top"):
            self.same(spandrels[name], wall.spandrels[name])
        for name in ("normal_at_peak", "shear_at_peak", "largest_shear"):
            self.same(spandrels[name][0], wall.spandrels[name])
        self.same(spandrels["end_drop"][0] / (spandrels["to"] - spandrels["from"]), wall.spandrels["drift"])
        stored = drystone.open(file).piers
        self.same(stored["from"], wall.piers["from"])
        self.assertEqual(stored["shear_at_peak"].shape, (1, len(wall.piers["from"])))
        self.same(stored["shear_at_peak"][0], wall.piers["shear_at_peak"])

    def test_joints(self):
        """The joints of joints.csv, and what the file of a study says of each value."""
        settings = {**STUDY, "uq.spatial": "independent"}
        out = self.folder / "scene"
        self.assertEqual(run("scene", QUICK, "--out", out, *sets(settings)).returncode, 0)
        study = drystone.Study(QUICK, set=settings)
        for places, is_crack in ((study.joints, False), (study.cracks, True)):
            rows = [row for row in table(out / "joints.csv") if (row["kind"] == "crack") == is_crack]
            self.assertEqual([int(row["id"]) for row in rows], places["id"].tolist())
            self.assertEqual([row["kind"] for row in rows], places["kind"].tolist())
            for name in ("course", "unit", "x", "z", "length"):
                column = [float(row[name if name in row else f"{name} [m]"]) for row in rows]
                self.assertTrue(numpy.allclose(places[name], column, rtol=1e-11), name)
        i = study.inputs.index("joint.friction_angle.17")
        self.assertIn(f"middle at x = {study.joints['x'][16]:.6g} m, z = {study.joints['z'][16]:.6g} m", study._study.columns()[i][2])

    def test_readings(self):
        """Mode, ultimate and limit drifts of each wall, as walls.csv has them."""
        file, out = self.folder / "study.h5", self.folder / "tables"
        results = drystone.Study(QUICK, set=STUDY).run(file)
        self.assertEqual(run("fragility", file, "--out", out).returncode, 0)
        readings, rows = results.readings(), table(out / "tables/walls.csv")
        self.assertEqual(len(rows), 18)
        self.assertEqual([row["mode"] for row in rows], readings["mode"].tolist())
        height = 1.1e3  # [mm]
        for name, column, to_mm in (("ultimate_displacement", "ultimate", 1e3), ("ultimate_drift", "ultimate", height), *((s, s, height / 100) for s in results.limit_states)):
            for value, censored, row in zip(readings[name] * to_mm, readings[f"{name} censored"], rows):
                wanted = row[f"{column} [mm]"]
                self.assertEqual(math.isnan(value), wanted == "", name)
                if wanted:
                    self.assertTrue(math.isclose(value, float(wanted), rel_tol=1e-9), (name, value, wanted))
                    self.assertEqual(censored, row[f"{column} censored"] == "1", name)
        other = results.readings({"fragility.limit_states": "paper"})
        self.assertEqual([name for name in other if name.startswith("ntc")], [])
        try:
            import pandas  # noqa: F401
        except ImportError:
            print("without python3-pandas: no frame")
            return
        frame = results.frame()
        self.assertEqual(frame["mode"].tolist(), readings["mode"].tolist())
        self.assertIn("ntc SLV", frame.columns)


unittest.main()
