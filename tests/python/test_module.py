#!/usr/bin/python3
"""The Python module against the files of the command line: exactly the same numbers.

DRYSTONE_PROGRAM, DRYSTONE_SOURCE_DIR: the program and the sources; PYTHONPATH: the folder of the module.
"""
import ast
import csv
import inspect
import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import sysconfig
import tempfile
import threading
import time
import unittest
import unittest.mock
import warnings

import numpy

import drystone

PROGRAM = os.environ["DRYSTONE_PROGRAM"]
ROOT = pathlib.Path(os.environ["DRYSTONE_SOURCE_DIR"])
WALL, QUICK = ROOT / "configs/wall.ini", ROOT / "configs/quick.ini"
CHEAP = {"solver.fidelity": "rigid", "solver.steps_per_mm": 100, "load.max_displacement": "3 mm"}
STUDY = {**CHEAP, "uq.samples": 6}
LONG = {"solver.fidelity": "fine", "load.max_displacement": "300 mm"}
RIGID = "wall.toe: no effect"  # of a rigid first course
TIMES = ("solver_seconds", "contact_updates_per_second")


def run(*words):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)


def sets(values):
    return [word for key, value in values.items() for word in ("--set", f"{key}={value}")]


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
        self.assertEqual(wall.force.max() * 1e-3, wall.summary["peak_force_kN"])
        self.assertEqual(wall.vertical_stress, 0.5e6)
        self.assertEqual(wall.drift[-1], wall.displacement[-1] / 1.1)
        self.assertFalse(wall.force.flags.writeable or wall.failed)

    def test_wall_of_a_study(self):
        wall = self.check(QUICK, STUDY, "--sample", "3", "--level", "1.00 MPa", sample=3, level="1.00 MPa")
        self.assertEqual((wall.level, wall.sample), (1, 3))

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
            self.assertEqual(wall.summary["peak_force_kN"], theirs.responses["peak_force"][i] * 1e-3)
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


class FitIsThatOfTheCommandLine(InFolder):
    DRIFTS = [1.26, 1.89, 1.62, 2.27, 0.93, 3.00, 0.84, 1.10, 0.71, 1.45, 0.98, 1.30]
    STOOD = [0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1]

    def command_line(self, law="lognormal"):
        data = self.folder / "drifts.csv"
        data.write_text("drift [%],stood\n" + "".join(f"{d},{c}\n" for d, c in zip(self.DRIFTS, self.STOOD)))
        done = run("fragility", data, "--drift", "drift", "--censored", "stood", "--set", f"fragility.law={law}",
                   "--out", self.folder / law)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / law / "tables"

    def test_laws(self):
        rows = table(self.command_line() / "law_parameters.csv")
        self.assertEqual(len(rows), 4)
        for row in rows:
            fit = drystone.fragility.fit(self.DRIFTS, self.STOOD, law=row["law"])
            self.assertEqual(fit.aic, float(row["AIC"]))
            self.assertEqual((fit.n, fit.n_censored), (12, 3))
            if row["law"] in ("lognormal", "normal"):
                self.assertEqual((fit.location, fit.dispersion), (float(row["first value"]), float(row["second value"])))
                self.assertEqual(fit.location_error, float(row["first value std error"]))
                # The table takes it from the covariance of its own parameters: the last bit differs.
                error = float(row["second value std error"])
                self.assertTrue(math.isclose(fit.dispersion_error, error, rel_tol=4e-16), row)
            else:
                shape = {"weibull": 1 / fit.dispersion, "gamma": 1 / fit.dispersion**2}[row["law"]]
                self.assertTrue(math.isclose(shape, float(row["first value"]), rel_tol=4e-16), row)

    def test_performance_limits(self):
        for law in ("lognormal", "weibull"):
            row, = table(self.command_line(law) / "../performance_limits.csv")
            limits = drystone.fragility.performance_limits(self.DRIFTS, self.STOOD, law)
            fit = drystone.fragility.fit(self.DRIFTS, self.STOOD, law)
            for i, name in enumerate(("5 % drift", "16 % drift", "median drift", "84 % drift", "95 % drift")):
                self.assertEqual(limits.drift[i], float(row[f"{name} [%]"]))
                self.assertEqual(limits.lower[i], float(row[f"{name} lower [%]"]))
                self.assertEqual(limits.upper[i], float(row[f"{name} upper [%]"]))
                self.assertEqual(fit.quantile(limits.share[i]), limits.drift[i])
                self.assertEqual(fit.interval(limits.share[i]), (limits.lower[i], limits.upper[i]))
            self.assertEqual(limits.dispersion, float(row["dispersion"]))
            self.assertEqual(fit.interval("dispersion"), limits.dispersion_interval)
            self.assertEqual(100 * limits.censored_share, float(row["censored [%]"]))
            self.assertEqual(fit.median, limits.drift[2])

    def test_kaplan_meier(self):
        rows = table(self.command_line() / "steps_drift.csv")
        steps = drystone.fragility.kaplan_meier(self.DRIFTS, self.STOOD)
        for column, name in ((steps.at, "drift [%]"), (steps.probability, "share"), (steps.lower, "share lower"),
                             (steps.upper, "share upper"), (steps.at_risk, "walls at risk")):
            self.assertEqual(list(column), [float(row[name]) for row in rows])
        self.assertEqual(steps.end, 3.0)

    def test_curve(self):
        fit = drystone.fragility.fit(self.DRIFTS, self.STOOD)
        x = numpy.array([[0.5, 1.0], [2.0, fit.median]])
        self.assertEqual(fit.cdf(x).shape, (2, 2))
        self.assertEqual(fit.cdf(1.0), fit.cdf(x)[0, 1])
        self.assertAlmostEqual(fit.cdf(1.0), 0.5 * math.erfc((fit.location - 0.0) / fit.dispersion / math.sqrt(2)), 14)

    def test_many_fits_are_quick(self):
        begin = time.process_time()
        for _ in range(1000):
            drystone.fragility.fit(self.DRIFTS, self.STOOD)
        self.assertLess(time.process_time() - begin, 10.0)  # 0.05 s where nothing else runs


class SamplesAreThoseOfStudies(InFolder):
    def test_same_bits(self):
        text = "normal(mean 1, cov 0.25, from 0.2, to 3)"
        keys = ("joint.stiffness_factor", "unit.stiffness_factor")
        fixed = {"joint.friction_angle": "31.8 deg", "unit.friction_angle": "35 deg", "unit.tensile_strength": "3.7 MPa"}
        for design in ("lhs", "lhs_centred", "monte_carlo", "sobol"):
            study = drystone.Study(QUICK, set={**fixed, **{key: text for key in keys}, "uq.samples": 16, "uq.seed": 7,
                                               "uq.design": design, "uq.shared": "yes", "uq.pearson": " ".join(keys) + " 0.5"})
            sample = drystone.uq.sample({key: text for key in keys}, 16, seed=7, design=design, pearson={keys: 0.5})
            self.assertEqual(list(sample), study.inputs)
            self.assertTrue(numpy.array_equal(numpy.column_stack(list(sample.values())), study.draws(0)), design)

    def test_bad_input(self):
        for variables, n, more, message in (
                ({"x": "normal(mean 1)"}, 4, {}, r"^uq\.sample: x: "),
                ({"x": "normal(mean 1, cov 0.1)"}, 0, {}, r"^uq\.sample: samples: "),
                ({"x": "normal(mean 1, cov 0.1)"}, 4, {"design": "grid"}, r"^uq\.sample: design: "),
                ({"x": "normal(mean 1, cov 0.1)"}, 4, {"pearson": {("x", "y"): 0.3}}, r"^uq\.sample.*y.* is no random input"),
                ({}, 4, {}, r"^uq\.sample: variables: none")):
            with self.assertRaisesRegex(drystone.ConfigError, message):
                drystone.uq.sample(variables, n, **more)


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


class PythonGoesOnMeanwhile(InFolder):
    def interrupted(self, work):
        """Seconds from Ctrl-C to its exception."""
        sent = []

        def interrupt():
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)
        timer = threading.Timer(0.5, interrupt)
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            work()
        return time.monotonic() - sent[0]

    def test_interrupt_a_push(self):
        self.assertLess(self.interrupted(lambda: drystone.push(WALL, set=LONG)), 5.0)
        self.assertFalse(drystone.push(WALL, set=CHEAP).failed)

    def test_interrupt_a_study(self):
        study = drystone.Study(QUICK, set={**CHEAP, "uq.samples": 5000, "uq.design": "monte_carlo"})
        file = self.folder / "study.h5"
        self.interrupted(lambda: study.run(file))
        results = drystone.open(file)
        self.assertEqual(results.missing, 15000 - len(results))
        self.assertTrue(0 < len(results) < 15000)

    def test_other_threads_run(self):
        turns, over = 0, threading.Event()

        def push():
            try:
                drystone.push(WALL, set={**CHEAP, "solver.steps_per_mm": 2000})
            finally:
                over.set()
        worker = threading.Thread(target=push)
        worker.start()
        while not over.wait(1e-3):
            turns += 1
        worker.join()
        self.assertGreater(turns, 20)

    def test_one_thread_uses_hdf5(self):
        study, file = drystone.Study(QUICK, set=STUDY), self.folder / "study.h5"
        refused = []

        def look(done, failed, all):
            def other():
                try:
                    drystone.open(file)
                except RuntimeError as error:
                    refused.append(str(error))
            if done == 3:
                self.assertEqual(drystone.open(file).missing + len(drystone.open(file)), 18)
                thread = threading.Thread(target=other)
                thread.start()
                thread.join()
        study.run(file, progress=look)
        self.assertEqual(len(refused), 1)
        self.assertIn("HDF5 serves one thread", refused[0])


class ModuleSaysWhatItIs(InFolder):
    PACKAGE = pathlib.Path(drystone.__file__).parent

    def python(self, code, path):
        environment = {**os.environ, "PYTHONPATH": str(path)}
        return subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)

    def test_without_numpy(self):
        said = self.python("import sys; sys.modules['numpy'] = None; import drystone", self.PACKAGE.parent)
        self.assertIn("drystone needs numpy, which", said.stderr)
        self.assertIn("apt-get install python3-numpy", said.stderr)

    def test_other_python(self):
        copy = self.folder / "drystone"
        copy.mkdir()
        for file in self.PACKAGE.glob("*.py"):
            shutil.copy(file, copy)
        said = self.python("import drystone", self.folder)
        self.assertIn("has no compiled part", said.stderr)
        (copy / "_core.cpython-39-x86_64-linux-gnu.so").touch()
        said = self.python("import drystone", self.folder)
        here = f"{sys.version_info.major}.{sys.version_info.minor}"
        self.assertIn("compiled for Python 3.9, and", said.stderr)
        self.assertIn(f"is Python {here}; run python3.9", said.stderr)

    def test_instruction_sets(self):
        """Of the package's three the fastest that this processor has."""
        from drystone import _load
        v3 = {"avx2", "fma", "bmi2"}
        v4 = v3 | {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"}
        for flags, sets in ((set(), ["", "v1"]), ({"avx2", "fma"}, ["", "v1"]), (v3, ["", "v3", "v1"]),
                            (v4 - {"avx512vl"}, ["", "v3", "v1"]), (v4 | {"sse"}, ["", "v4", "v3", "v1"])):
            with unittest.mock.patch.object(_load, "_flags", lambda: flags):
                self.assertEqual(_load._instruction_sets(), sets)
        self.assertIn("fpu", _load._flags())
        copy = self.folder / "drystone"
        (copy / "v1").mkdir(parents=True)
        for file in self.PACKAGE.glob("*.py"):
            shutil.copy(file, copy)
        shutil.copy(self.PACKAGE / f"_core{sysconfig.get_config_var('EXT_SUFFIX')}", copy / "v1")
        said = self.python("import drystone; print(drystone.fragility.fit([1, 2, 3]))", self.folder)
        self.assertIn("lognormal fit of 3 walls", said.stdout, said.stderr)

    def test_stubs(self):
        """The stub names what the compiled part has, and every public function says what it does."""
        core = sys.modules["drystone._core"]
        tree = ast.parse((self.PACKAGE / "_core.pyi").read_text())
        names = {node.name for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(names, {name for name in dir(core) if not name.startswith("_")})
        for node in tree.body:
            if isinstance(node, ast.ClassDef) and not node.name.endswith(("Error", "NoFit")):
                listed = {m.target.id if isinstance(m, ast.AnnAssign) else m.name for m in node.body
                          if isinstance(m, (ast.AnnAssign, ast.FunctionDef))}
                there = {name for name in dir(getattr(core, node.name)) if not name.startswith("_")}
                self.assertEqual(listed - {"__init__"}, there, node.name)
        for module in (drystone, drystone.fragility, drystone.uq):
            for name in module.__all__ if hasattr(module, "__all__") else ["sample"]:
                thing = getattr(module, name)
                self.assertTrue(inspect.getdoc(thing), name)
                for member, value in vars(thing).items() if inspect.isclass(thing) else ():
                    if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                        self.assertTrue(inspect.getdoc(value), f"{name}.{member}")
        self.assertEqual("drystone " + drystone.__version__, run("version").stdout.strip())


unittest.main()
