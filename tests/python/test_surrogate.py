#!/usr/bin/python3
"""What `drystone surrogate` kept, from Python and over HTTP."""
import json
import math
import re
import subprocess
import unittest
import urllib.request

import numpy

import drystone

from scene import InFolder, PROGRAM, QUICK, run, sets

STUDY = {"uq.samples": 12, "solver.fidelity": "rigid", "solver.steps_per_mm": 100, "load.max_displacement": "15 mm",
         "load.vertical_stress": "1 MPa", "joint.wall_modulus": "1057 MPa"}


def polynomial(family, n, c):
    if family == "legendre":
        p = [1.0, c]
        for k in range(1, n):
            p.append(((2 * k + 1) * c * p[k] - k * p[k - 1]) / (k + 1))
        return math.sqrt(2 * n + 1) * p[n]
    p = [1.0, c]
    for k in range(1, n):
        p.append(c * p[k] - k * p[k - 1])
    return p[n] / math.sqrt(math.factorial(n))


def by_the_page(file, level, c):
    """docs/surrogates.md, "Predict from the file"."""
    if level["better"] == "chaos":
        terms = zip(level["chaos"]["degrees"], level["chaos"]["coefficients"])
        families = [i["coordinate"] for i in file["inputs"]]
        return sum(a * math.prod(polynomial(f, n, x) for f, n, x in zip(families, degrees, c)) for degrees, a in terms), level["chaos"]["error"]["rmse"]
    process = level["process"]
    lengths = numpy.array(process["lengths"])

    def rho(a, b):
        r = math.sqrt((((a - b) / lengths) ** 2).sum())
        s = math.sqrt(5.0) * r
        return math.exp(-0.5 * r * r) if process["kernel"] == "squared exponential" else (1 + s + s * s / 3) * math.exp(-s)

    points = numpy.array(process["points"])
    k = process["variance"] * numpy.array([rho(p, c) for p in points])
    covariance = process["variance"] * numpy.array([[rho(p, q) for q in points] for p in points]) + process["noise"] * numpy.eye(len(points))
    one = numpy.linalg.solve(covariance, numpy.ones(len(points)))
    left = 1 - one @ k
    variance = process["variance"] - k @ numpy.linalg.solve(covariance, k) + left * left / one.sum() + process["noise"]
    return process["constant"] + k @ numpy.array(process["weights"]), math.sqrt(process["inflation"] * variance)


class SurrogatesPredict(InFolder):
    def test_file_python_and_server_agree(self):
        run("study", QUICK, "--out", self.folder / "s.h5", "--quiet", *sets(STUDY))
        said = run("surrogate", self.folder / "s.h5", "--quiet")
        self.assertEqual(said.returncode, 0, said.stderr)
        path = self.folder / "s_surrogate/surrogate.json"
        surrogate, file = drystone.Surrogate(path), json.loads(path.read_text())
        self.assertEqual((surrogate.response, surrogate.vertical_stress.tolist()), ("peak_force", [1e6]))
        self.assertIn("fewer than 5 for each of 5", surrogate.doubts()[0])
        results = drystone.open(self.folder / "s.h5")
        level = file["surrogates"][0]
        seen = numpy.array([results.inputs[key] for key in surrogate.inputs]).T[:level["walls"]]
        walls = surrogate.predict(seen)
        self.assertEqual(walls.outside.tolist(), [0] * len(seen))
        by_name = surrogate.predict({key: seen[:, i] for i, key in enumerate(surrogate.inputs)})
        self.assertEqual(by_name.mean.tolist(), walls.mean.tolist())
        for c, mean, sd in zip(level["process"]["points"], walls.mean, walls.sd):
            told = by_the_page(file, level, numpy.array(c))
            self.assertAlmostEqual(told[0] / (mean / 1e3), 1, delta=1e-10)
            self.assertAlmostEqual(told[1] / (sd / 1e3), 1, delta=1e-6)
        least, most = surrogate.learned_between()
        self.assertEqual(surrogate.predict([2 * most, most, least]).outside.tolist(), [5, 0, 0])
        modes = surrogate.modes(seen)
        self.assertEqual(list(modes), level["modes"]["names"])
        self.assertGreaterEqual(len(modes), 2)
        self.assertLess(abs(sum(p.probability for p in modes.values()) - 1).max(), 1e-12)
        first, second = list(modes.values())[:2]
        c = numpy.array(level["process"]["points"])  # of the walls that have the response: here of all
        told = numpy.array(level["modes"]["coefficients"][0]) @ numpy.vstack([numpy.ones(len(c)), c.T])
        self.assertLess(abs(numpy.log(second.probability / first.probability) - told).max(), 1e-9)
        self.assertEqual(surrogate.modes({key: seen[:, i] for i, key in enumerate(surrogate.inputs)})[list(modes)[0]].sd.tolist(), first.sd.tolist())
        for wrong in ([1.0], [[1.0, 2.0]], [[math.nan] * 5], {"joint.friction_angle": 1}):
            with self.assertRaises(ValueError):
                surrogate.predict(wrong)
        with self.assertRaises(IndexError):
            surrogate.predict(seen, level=1)

        server = subprocess.Popen([PROGRAM, "serve", path, "--port", "0"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        try:
            address = re.search(r"http://\S+:\d+", server.stdout.readline()).group(0)

            def ask(place, request):
                return json.load(urllib.request.urlopen(address + place, json.dumps(request).encode()))

            columns = ask("/Columns", {"name": "s_surrogate"})
            self.assertEqual([c["name"] for c in columns["inputs"]], surrogate.inputs)
            self.assertEqual([(c["name"], c["unit"]) for c in columns["outputs"]],
                             [("peak_force", "N"), ("peak_force_sd", "N"), ("outside", "-"), *((name, "-") for mode in modes for name in (mode, mode + "_sd"))])
            self.assertIn("not to be trusted", columns["outputs"][0]["meaning"])
            for i, (x, mean, sd) in enumerate(zip(seen, walls.mean, walls.sd)):
                answer = ask("/Evaluate", {"name": "s_surrogate", "input": [x.tolist()], "config": {}})
                self.assertEqual(answer["output"], [[mean, sd, 0, *(v[i] for p in modes.values() for v in p)]])
            answer = ask("/Evaluate", {"name": "s_surrogate", "input": [(2 * most).tolist()], "config": {}})
            self.assertEqual(answer["output"][0][2], 5)
        finally:
            server.terminate()
            said = server.communicate(timeout=20)[1]
        self.assertIn("1.00 MPa: not to be trusted. 12 walls are fewer", said)

    def test_other_files_are_refused(self):
        with self.assertRaisesRegex(drystone.ConfigError, "surrogate.json that drystone surrogate FILE.h5 wrote"):
            drystone.Surrogate(self.folder / "none.json")
        other = self.folder / "summary.json"
        other.write_text("{}")
        with self.assertRaisesRegex(drystone.ConfigError, "summary.json: is not a surrogate"):
            drystone.Surrogate(other)
        said = run("serve", other, "--port", "0")
        self.assertEqual((said.returncode, "is not a surrogate" in said.stderr), (2, True))
        said = run("serve", other, "--port", "0", "--response", "peak_force")
        self.assertIn("drystone: --response: a surrogate is served as it was learned", said.stderr)


unittest.main()
