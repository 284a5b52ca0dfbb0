#!/usr/bin/python3
"""bench/active_openturns.py [REPETITIONS=50]   writes docs/bench/uq/active_openturns.md

Subset simulation and importance sampling around the design point, by OpenTURNS, on the limit states of docs/bench/uq/active.md.
"""
import math
import pathlib
import sys

import openturns as ot

ot.Log.Show(ot.Log.NONE)

TARGET = 0.1  # coefficient of variation, as in docs/bench/uq/active.md
LEVEL = 1000  # samples of a level of subset simulation
NORMAL = 1.959963984540054


def plane(beta, curvature):
    u = [f"u{i}" for i in range(10)]
    return u, f"{beta} + 0.25 * {curvature} * (u0 - u1)^2 - ({' + '.join(u)}) / sqrt(10)"


def branches(k):
    return ["a", "b"], (f"min(min(3 + 0.1 * (a - b)^2 - (a + b) / sqrt(2), 3 + 0.1 * (a - b)^2 + (a + b) / sqrt(2)), "
                        f"min(a - b + {k} / sqrt(2), b - a + {k} / sqrt(2)))")


def oscillator(force, sd):
    w2 = "((1.1 + 0.1 * b + 0.01 * c) / (1 + 0.05 * a))"
    return list("abcdef"), (f"3 * (0.5 + 0.05 * f) - abs(2 * ({force} + {sd} * d) / ((1 + 0.05 * a) * {w2}) "
                            f"* sin(0.5 * sqrt({w2}) * (1 + 0.2 * e)))")


# name, (inputs, limit state of standard normal inputs), exact probability as in docs/bench/uq/active.md
PROBLEMS = [
    ("four branches, k 6", branches(6), 0.004457),
    ("four branches, k 7", branches(7), 0.002223),
    ("RP22", (["a", "b"], "2.5 - (a + b) / sqrt(2) + 0.1 * (a - b)^2"), 4.207305511e-3),
    ("R - S 7/2", (["a", "b"], "5 + a - b"), 2.034760087e-4),
    ("oscillator", oscillator(1, 0.2), 0.0286),
    ("oscillator, weak force", oscillator(0.6, 0.1), 8.992e-6),
    ("10 inputs, beta 3.09, curvature 0", plane(3.0902, 0), 0.001),
    ("10 inputs, beta 3.5, curvature 5", plane(3.5, 5), 5.127e-5),
    ("10 inputs, beta 4.753, curvature 0", plane(4.7534, 0), 1e-6),
    ("10 inputs, two sides", (plane(0, 0)[0], f"4 - abs({' + '.join(plane(0, 0)[0])}) / sqrt(10)"), 6.334e-5),
]


def event_of(problem):
    inputs, formula = problem
    g = ot.SymbolicFunction(inputs, [formula])
    x = ot.RandomVector(ot.Normal(len(inputs)))
    return g, ot.ThresholdEvent(ot.CompositeRandomVector(g, x), ot.LessOrEqual(), 0.0)


def subset(event):
    run = ot.SubsetSampling(event)
    run.setMaximumOuterSampling(LEVEL // 10)
    run.setBlockSize(10)
    run.run()
    result = run.getResult()
    return result.getProbabilityEstimate(), result.getCoefficientOfVariation()


def around_design_point(event):
    search = ot.SQP()
    search.setStartingPoint([0.1] * event.getAntecedent().getDimension())  # not 0: a limit state with two sides has no slope there
    form = ot.FORM(search, event, search.getStartingPoint())
    form.run()
    point = form.getResult().getStandardSpaceDesignPoint()
    run = ot.ProbabilitySimulationAlgorithm(ot.StandardEvent(event), ot.ImportanceSamplingExperiment(ot.Normal(point, ot.CovarianceMatrix(len(point)))))
    run.setMaximumOuterSampling(100000)
    run.setBlockSize(8)
    run.setMaximumCoefficientOfVariation(TARGET)
    run.run()
    result = run.getResult()
    return result.getProbabilityEstimate(), result.getCoefficientOfVariation()


def row(name, problem, exact, method, repetitions):
    calls, errors, told, held, none = 0, [], 0.0, 0, 0
    for seed in range(1, repetitions + 1):
        ot.RandomGenerator.SetSeed(seed)
        g, event = event_of(problem)
        try:
            p, cov = method(event)
        except (RuntimeError, TypeError, ValueError) as why:
            print(name, why, file=sys.stderr)
            none += 1
            continue
        calls += g.getEvaluationCallsNumber() + g.getGradientCallsNumber() * g.getInputDimension()
        errors.append(p / exact - 1)
        told += p * cov / exact
        held += abs(p - exact) <= NORMAL * p * cov
    n = len(errors)
    if n == 0:
        return None
    rms = math.sqrt(sum(e * e for e in errors) / n)
    return [f"{calls / n:.0f}", f"{100 * sum(errors) / n:.1f}", f"{100 * rms:.1f}", f"{100 * told / n:.1f}", f"{held} of {n}"]


def main():
    repetitions = int(sys.argv[1]) if len(sys.argv) > 1 else 50
    head = ["calls", "bias [%]", "rms error [%]", "told [%]", "holds"]
    lines = ["# Subset simulation and FORM with importance sampling: OpenTURNS", "",
             f"Written by `bench/active_openturns.py {repetitions}` with OpenTURNS {ot.__version__}.", "",
             f"The limit states of [active.md](active.md), {repetitions} repetitions each with other seeds. Subset simulation: {LEVEL} samples a level, all else as OpenTURNS has it. "
             "Importance sampling: a normal density at the design point (FORM, SQP), until the coefficient of variation is 10 %; calls with those of the gradient by differences. Errors are over the exact probability. "
             "Holds: 95 % normal intervals of the told error that hold it. Columns of `active` are in active.md.", "",
             "| problem | exact P | method | " + " | ".join(head) + " |", "|---:|---:|---:|" + "---:|" * len(head)]
    for name, problem, exact in PROBLEMS:
        for label, method in (("subset", subset), ("FORM, importance", around_design_point)):
            cells = row(name, problem, exact, method, repetitions) or ["-"] * len(head)
            lines.append(f"| {name} | {exact:.4g} | {label} | " + " | ".join(cells) + " |")
            print(lines[-1], file=sys.stderr)
    page = pathlib.Path(__file__).resolve().parent.parent / "docs/bench/uq/active_openturns.md"
    page.write_text("\n".join(lines) + "\n")


main()
