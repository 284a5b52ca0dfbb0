"""Samples of random variables, drawn as those of a study are."""
from __future__ import annotations

from collections.abc import Mapping

import numpy

from drystone._load import core as _core


def sample(variables: Mapping[str, str], n: int, *, seed: int = 1, design: str = "lhs",
           pearson: Mapping[tuple[str, str], float] | None = None) -> dict[str, numpy.ndarray]:
    """Samples of variables, each an array of n values. Equal seeds give equal bits.

    >>> sample({"phi": "normal(mean 31.8, cov 0.20)", "ft": "lognormal(mean 3.7, cov 0.30)"}, 50)  # doctest: +SKIP

    :param variables: name: distribution, as in study files, in your own units
    :param n: number of samples, >= 1
    :param design: lhs, lhs_centred, lhs_optimised, monte_carlo, sobol
    :param pearson: correlation of pairs of variables, through the normal copula
    :raises ConfigError: uq.sample: name: what is wrong and what to write
    """
    for name in variables:
        if not name or any(c.isspace() or c == "," for c in name):
            raise ValueError(f"{name!r}: a name has no blanks and no commas")
    pairs = ", ".join(f"{a} {b} {float(rho)!r}" for (a, b), rho in (pearson or {}).items())
    values = _core.sample(list(variables.items()), n, design, seed, pairs)
    return {name: numpy.ascontiguousarray(values[:, i]) for i, name in enumerate(variables)}
