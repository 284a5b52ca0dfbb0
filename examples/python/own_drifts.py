"""Own drift data to a fragility curve: python3 examples/python/own_drifts.py

Drifts [%] at which six walls reached a limit state; two still stood where their tests ended. The numbers are those of
docs/cookbook.md.
"""
import matplotlib
matplotlib.use("Agg")  # into a file; leave out in a notebook
import matplotlib.pyplot as plt
import numpy

from drystone import fragility

drifts = [1.26, 1.89, 1.62, 2.27, 0.93, 3.00]
stood = [False, False, False, True, False, True]

fit = fragility.fit(drifts, stood)
low, high = fit.interval("median")
print(f"median {fit.median:.2f} % [{low:.2f}, {high:.2f}], dispersion {fit.dispersion:.2f}")
for law in ("lognormal", "weibull", "gamma"):
    print(f"{law:10s} AIC {fragility.fit(drifts, stood, law).aic:.2f}")

steps = fragility.kaplan_meier(drifts, stood)
x = numpy.linspace(0.01, 4.0, 200)
plt.plot(x, fit.cdf(x), label="lognormal")
plt.step(steps.at, steps.probability, where="post", label="observed (Kaplan-Meier)")
plt.xlabel("drift [%]")
plt.ylabel("share of walls at the limit state")
plt.legend()
plt.savefig("own_drifts.png")
