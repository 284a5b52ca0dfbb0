"""Walls that were never run."""
from __future__ import annotations

import os
from collections.abc import Mapping
from typing import NamedTuple, Union

import numpy
from numpy.typing import ArrayLike

from drystone._load import core as _core


class Prediction(NamedTuple):
    """One row for each wall; in SI."""
    mean: numpy.ndarray
    sd: numpy.ndarray
    """Doubt of one wall: standard deviation about the mean."""
    outside: numpy.ndarray
    """Number of inputs beyond those of the walls learned from: where it is not 0 the surrogate extrapolates."""


class ModeProbability(NamedTuple):
    """One row for each wall."""
    probability: numpy.ndarray
    sd: numpy.ndarray
    """Standard error of the probability."""


class Surrogate:
    """What `drystone surrogate FILE.h5` learned of a response and kept (docs/surrogates.md).

    >>> surrogate = Surrogate("runs/quick_surrogate/surrogate.json")   # doctest: +SKIP
    >>> surrogate.predict([[0.55, 1.0, 3.7e6, 0.61, 1.0]], level=1)      # doctest: +SKIP

    :raises ConfigError: no such file, damaged, another one
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self._learned = _core.read_surrogate(os.fspath(path))
        self.path: str = os.fspath(path)
        self.study: str = self._learned.study
        """Name of the file that it was learned from."""
        self.response: str = self._learned.response
        self.inputs: list[str] = self._learned.keys
        """Keys of the study, in the order of the columns of `predict`; in SI, as `Study.draws` has them."""
        self.vertical_stress: numpy.ndarray = numpy.array(self._learned.stresses)
        """Of each level [Pa]."""

    def doubts(self, level: int = 0) -> list[str]:
        """Why the surrogate of this stress is not to be trusted; empty: it is."""
        return self._learned.doubts(level)

    def learned_between(self, level: int = 0) -> tuple[numpy.ndarray, numpy.ndarray]:
        """Least and most of each input on the walls learned from, in SI."""
        least, most = self._learned.learned_between(level)
        return numpy.array(least), numpy.array(most)

    def predict(self, x: Union[ArrayLike, Mapping[str, ArrayLike]], level: int = 0) -> Prediction:
        """The response of walls that were never run, by the better of both surrogates.

        :param x: n x d, columns as `inputs`, in SI; or an array for each of them by name
        :param level: number of the vertical stress, from 0
        """
        return Prediction(*map(numpy.array, self._learned.predict(level, self._rows(x))))

    def modes(self, x: Union[ArrayLike, Mapping[str, ArrayLike]], level: int = 0) -> dict[str, ModeProbability]:
        """Probability of each failure mode of walls that were never run; empty where the walls of the study gave no model of them.

        :param x: as `predict` takes it
        """
        return {name: ModeProbability(numpy.array(p), numpy.array(sd)) for name, p, sd in self._learned.modes(level, self._rows(x))}

    def _rows(self, x: Union[ArrayLike, Mapping[str, ArrayLike]]) -> numpy.ndarray:
        if isinstance(x, Mapping):
            if set(x) != set(self.inputs):
                raise ValueError(f"inputs are {', '.join(self.inputs)}, not {', '.join(map(str, x))}")
            x = numpy.column_stack(numpy.broadcast_arrays(*(numpy.atleast_1d(numpy.asarray(x[key], float)) for key in self.inputs)))
        return numpy.asarray(x, float)

    def __repr__(self) -> str:
        doubts = sum(1 for level in range(len(self.vertical_stress)) if self.doubts(level))
        return f"<Surrogate of {self.response} of {self.study}: {len(self.vertical_stress)} stresses, {doubts} not to be trusted>"
