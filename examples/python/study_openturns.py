"""A study driven by OpenTURNS: python3 examples/python/study_openturns.py

OpenTURNS draws the walls, Drystone pushes them side by side, OpenTURNS tells which input matters.
"""
import pathlib

import numpy
import openturns as ot

import drystone

quick_ini = pathlib.Path(__file__).parents[2] / "configs/quick.ini"
study = drystone.Study(quick_ini, set={"load.vertical_stress": "0.50 MPa", "joint.wall_modulus": "768 MPa",
                                       "load.max_displacement": "10 mm"})

degree = numpy.pi / 180
distributions = {  # in SI, in place of those of the study file
    "joint.friction_angle": ot.TruncatedDistribution(ot.Normal(31.8 * degree, 6.36 * degree), 0.1, 1.2),
    "joint.stiffness_factor": ot.LogNormalMuSigma(1.0, 0.25).getDistribution(),
    "unit.tensile_strength": ot.LogNormalMuSigma(3.7e6, 1.11e6).getDistribution(),
    "unit.friction_angle": ot.TruncatedDistribution(ot.Normal(35 * degree, 7 * degree), 0.1, 1.2),
    "unit.stiffness_factor": ot.LogNormalMuSigma(1.0, 0.25).getDistribution(),
}
together = ot.ComposedDistribution([distributions[name] for name in study.inputs])
ot.RandomGenerator.SetSeed(1)
samples = ot.LHSExperiment(together, 32).generate()

walls = study.push(inputs=numpy.array(samples))
peaks = ot.Sample([[wall.summary["peak_force_kN"]] for wall in walls])

print(f"peak force: mean {peaks.computeMean()[0]:.1f} kN, standard deviation {peaks.computeStandardDeviation()[0]:.1f} kN")
for name, rank in zip(study.inputs, ot.CorrelationAnalysis(samples, peaks).computeSpearmanCorrelation()):
    print(f"{name:24s} rank correlation with the peak {rank:5.2f}")
