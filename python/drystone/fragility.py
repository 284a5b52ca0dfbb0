"""Fragility of walls from limit drifts, whoever measured them: those of a study, or your own.

Drifts are in any one unit, results in the same; the tables of the command line have percent. A wall that had not reached the limit
state where its run ended is `censored`: its drift is a lower bound.
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy

from drystone._load import core as _core

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from drystone._core import Fit
else:
    Fit = _core.Fit

__all__ = ["Fit", "KaplanMeier", "PerformanceLimits", "fit", "kaplan_meier", "performance_limits"]


def _flags(censored: ArrayLike | None) -> numpy.ndarray:
    if censored is None:
        return numpy.empty(0, bool)
    flags = numpy.asarray(censored)
    if flags.dtype.kind not in "biuf" or not ((flags == 0) | (flags == 1)).all():
        raise ValueError("censored: must be True or False, or 1 or 0, for each value")
    return flags.astype(bool)


def fit(values: ArrayLike, censored: ArrayLike | None = None, law: str = "lognormal") -> Fit:
    """The law of limit drifts by maximum likelihood.

    :param values: drifts; > 0 unless the law is normal
    :param censored: True where the drift is a lower bound; None: all were reached
    :param law: lognormal, normal, weibull, gamma
    :returns: `median`, `dispersion`, `location`, errors, `aic`, `cdf(drift)`, `quantile(share)`, `interval("median")`
    :raises NoFit: the walls determine no law; the text says why
    """
    return _core.fit(values, _flags(censored), law)


@dataclass(frozen=True)
class KaplanMeier:
    """Share of walls that reached the limit state, without any law; matplotlib: step(at, probability, where="post")."""
    at: numpy.ndarray
    """Drifts at which walls reached it, ascending."""
    at_risk: numpy.ndarray
    """Walls that stood just before."""
    failed: numpy.ndarray
    """Walls that reached it there."""
    probability: numpy.ndarray
    """Share at or below, up to the next step [-]."""
    std_error: numpy.ndarray
    """Of the share (Greenwood) [-]."""
    lower: numpy.ndarray
    """Band of the share [-]."""
    upper: numpy.ndarray
    end: float
    """Highest drift of all; nothing is known beyond."""
    median: float | None
    """Drift at which half of the walls have reached it; None: fewer did, and it is `end` or more."""
    median_interval: tuple[float, float]
    """Of the median, without a law (Fay, Brittain and Proschan 2013); an infinite end: the walls give none."""


def kaplan_meier(values: ArrayLike, censored: ArrayLike | None = None, confidence: float = 0.95) -> KaplanMeier:
    """Kaplan and Meier's estimate (1958, J. Am. Stat. Assoc. 53, 457-481).

    :param confidence: of the band and of the median's interval, in (0, 1)
    """
    return KaplanMeier(**_core.kaplan_meier(values, _flags(censored), confidence))


@dataclass(frozen=True)
class PerformanceLimits:
    """Drifts that 5, 16, 50, 84 and 95 % of the walls reach, with their intervals. An infinite end: the data give none."""
    share: numpy.ndarray
    """Of walls that have reached the limit state [-]."""
    drift: numpy.ndarray
    """Infinite where it lies beyond the drift tested: only `lower` is known."""
    lower: numpy.ndarray
    upper: numpy.ndarray
    tested_to: float
    """Drift to which enough walls were tested; infinite: all of them reached the limit state."""
    dispersion: float
    """From wall to wall."""
    dispersion_interval: tuple[float, float]
    median_error: float
    """Standard error of ln median; of a normal law, of the median."""
    predictive_dispersion: float
    """Of a further wall: dispersion and error of the median together."""
    censored_share: float
    """Of all walls [-]."""
    n: float
    """Walls."""


def performance_limits(values: ArrayLike, censored: ArrayLike | None = None, law: str = "lognormal",
                       confidence: float = 0.95) -> PerformanceLimits:
    """The row of performance_limits.csv of these walls, without modes and without a test of fit.

    Where some of them are censored, shares above half of those reached are read from the shares observed.

    :raises NoFit: the walls determine no law; the text says why
    """
    return PerformanceLimits(**_core.performance_limits(values, _flags(censored), law, confidence))
