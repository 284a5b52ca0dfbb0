#!/usr/bin/python3
"""Objects of the Python module that are made, copied, or read in a way nobody foresaw. A crash would end the interpreter."""
import copy
import pickle
import shutil
import sys
import unittest

import numpy

import drystone

from scene import CHEAP, InFolder, QUICK, STUDY, WALL


class ObjectsHold(InFolder):
    def test_without_constructor(self):
        core = sys.modules["drystone._core"]
        for kind in (core.Wall, core.LoadedStudy, core.Fit, core.LearnedSurrogate):
            for make in (lambda: kind.__new__(kind), kind, lambda: object.__new__(kind), lambda: super(kind, kind).__new__(kind),
                         lambda: type("Own", (kind,), {"__new__": lambda c: super(c, c).__new__(c)})(), lambda: copy.copy(kind).__new__(kind)):
                with self.assertRaises(TypeError):
                    make()

    def test_copies(self):
        wall, study = drystone.push(WALL, set=CHEAP), drystone.Study(QUICK, set=STUDY)
        for one in (copy.copy, copy.deepcopy):
            self.same(one(wall).force, wall.force)
            self.assertTrue(numpy.array_equal(one(study).draws(), study.draws()))
        fit = drystone.fragility.fit([1.26, 1.89, 1.62, 2.27, 0.93, 3.00], [0, 0, 0, 1, 0, 1], "weibull")
        again = pickle.loads(pickle.dumps(fit))
        self.assertEqual((again.law, again.median, again.n_censored, again.interval("median")),
                         (fit.law, fit.median, fit.n_censored, fit.interval("median")))
        self.assertEqual(copy.deepcopy(fit).median, fit.median)

    def test_replaced_file(self):
        """Two studies are never mixed."""
        file, other = self.folder / "study.h5", self.folder / "other.h5"
        drystone.Study(QUICK, set=STUDY).run(file)
        drystone.Study(QUICK, set={**STUDY, "uq.seed": 7}).run(other)
        results = drystone.open(file)
        self.assertEqual(len(results.drifts("ntc SLV")[0]), 6)
        shutil.copy(other, file)
        for read in (lambda: results.curves, lambda: results.drifts("ntc SLV"), lambda: results.limit_states, results.readings):
            with self.assertRaisesRegex(drystone.StoreError, "study.h5' has changed since it was opened: .*open it again"):
                read()
        self.assertEqual(len(drystone.open(file).curves), 18)

    def test_shape_of_inputs(self):
        study = drystone.Study(QUICK, set=STUDY)
        for shape in ((2, 5, 1), (1, 2, 5), (0,), (5, 1)):
            with self.assertRaises((drystone.ConfigError, ValueError)):
                study.push(inputs=numpy.full(shape, 0.5), level=0)


unittest.main()
