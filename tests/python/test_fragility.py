#!/usr/bin/python3
"""Fits and samples of the Python module, against the tables of the command line."""
import math
import time
import unittest
import warnings

import numpy

import drystone

from scene import InFolder, QUICK, as_written, run, table


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
            self.assertEqual(as_written(fit.aic), float(row["AIC"]))
            self.assertEqual((fit.n, fit.n_censored), (12, 3))
            if row["law"] in ("lognormal", "normal"):
                self.assertEqual((as_written(fit.location), as_written(fit.dispersion)), (float(row["first value"]), float(row["second value"])))
                self.assertEqual(as_written(fit.location_error), float(row["first value std error"]))
                # The table takes it from the covariance of its own parameters: the last bit differs.
                error = float(row["second value std error"])
                self.assertTrue(math.isclose(fit.dispersion_error, error, rel_tol=1e-14), row)
            else:
                shape = {"weibull": 1 / fit.dispersion, "gamma": 1 / fit.dispersion**2}[row["law"]]
                self.assertTrue(math.isclose(shape, float(row["first value"]), rel_tol=1e-14), row)

    def test_performance_limits(self):
        for law in ("lognormal", "weibull"):
            row, = table(self.command_line(law) / "../performance_limits.csv")
            limits = drystone.fragility.performance_limits(self.DRIFTS, self.STOOD, law)
            fit = drystone.fragility.fit(self.DRIFTS, self.STOOD, law)
            self.assertEqual(as_written(limits.tested_to), float(row["tested up to [%]"]))
            for i, name in enumerate(("5 % drift", "16 % drift", "median drift", "84 % drift", "95 % drift")):
                known = math.isfinite(limits.drift[i])
                self.assertEqual(as_written(limits.drift[i]) if known else "", float(row[f"{name} [%]"]) if row[f"{name} [%]"] else "")
                self.assertEqual(row[f"{name} censored"], "0" if known else "1")
                self.assertEqual(as_written(limits.lower[i]), float(row[f"{name} lower [%]"]))
                upper = row[f"{name} upper [%]"]
                self.assertEqual(as_written(limits.upper[i]) if math.isfinite(limits.upper[i]) else "", float(upper) if upper else "")
            self.assertEqual(fit.quantile(limits.share[0]), limits.drift[0])  # the law's, in a wider interval of few walls
            self.assertLess(limits.lower[0], fit.interval(limits.share[0])[0])
            self.assertEqual(math.inf, limits.drift[4])  # walls stood
            self.assertEqual(as_written(limits.dispersion), float(row["dispersion"]))
            self.assertEqual(as_written(100 * limits.censored_share), float(row["censored [%]"]))

    def test_kaplan_meier(self):
        rows = table(self.command_line() / "steps_drift.csv")
        steps = drystone.fragility.kaplan_meier(self.DRIFTS, self.STOOD)
        for column, name in ((steps.at, "drift [%]"), (steps.probability, "share"), (steps.lower, "share lower"),
                             (steps.upper, "share upper"), (steps.at_risk, "walls at risk")):
            self.assertEqual([as_written(x) for x in column], [float(row[name]) for row in rows])
        self.assertEqual(steps.end, 3.0)

    def test_median(self):
        twenty = drystone.fragility.kaplan_meier(numpy.arange(1.0, 21.0))
        self.assertEqual((twenty.median, twenty.median_interval), (10.0, (6.0, 15.0)))  # ranks of the sign test
        stood = drystone.fragility.kaplan_meier([1.0, 2.0, 3.0, 3.0, 3.0], [0, 0, 1, 1, 1])
        self.assertIsNone(stood.median)
        self.assertEqual(stood.end, 3.0)
        self.assertEqual(stood.median_interval[1], math.inf)

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


class DriftLimitsAreNoDriftsOfWalls(InFolder):
    def test_warning(self):
        file = self.folder / "few.h5"
        drystone.Study(QUICK, set={"uq.samples": 2, "load.vertical_stress": "0.5 MPa", "joint.wall_modulus": "768 MPa",
                                   "solver.fidelity": "rigid", "load.max_displacement": "3 mm"}).run(file)
        results = drystone.open(file)
        given = {"fragility.limit_states": "user", "fragility.user_states": "near: 0.1 %"}
        with self.assertWarnsRegex(UserWarning, r"^user near: limit given \(0\.100 %\): 100 % of walls: no law"):
            drifts = results.drifts("user near", set=given)
        self.assertEqual(list(drifts.capped), [True, True])
        values, censored = drifts
        self.assertEqual(list(censored), [False, False])
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertFalse(results.drifts("paper ultimate").capped.any())


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
                ({"x": "normal(mean 1, cov 0.1)"}, 4, {"pearson": {("x", "y"): 0.3}}, r"^uq\.sample.*y.* is not a random input"),
                ({}, 4, {}, r"^uq\.sample: variables: none")):
            with self.assertRaisesRegex(drystone.ConfigError, message):
                drystone.uq.sample(variables, n, **more)


unittest.main()
