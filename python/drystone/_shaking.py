"""Walls on ground that moves."""
from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal

import numpy

from drystone._load import core as _core
from drystone._study import Study
from drystone._values import Value
from drystone._wall import Wall

if TYPE_CHECKING:
    import pandas


class Shaking:
    """One wall under one record at one intensity. Verified against closed forms, not validated (docs/dynamics.md)."""

    def __init__(self, history: dict[str, Any]) -> None:
        self.motion: str = history["motion"]
        """Name of the record, with its intensity."""
        self.height: float = history["height"]
        """Of the point whose displacement is told, above the ground [m]."""
        self.failed: bool = history["failed"]
        """Whether the numbers broke or the wall did not stand at rest; summary["outcome"] says how."""
        self.time: numpy.ndarray = history["time"]
        """[s]"""
        self.ground: numpy.ndarray = history["ground"]
        """Horizontal acceleration of the ground [m/s2]."""
        self.displacement: numpy.ndarray = history["displacement"]
        """Of the top against the ground, to the right [m]."""
        self.base_shear: numpy.ndarray = history["base_shear"]
        """Of the wall on the ground [N]."""
        self.summary: dict[str, Any] = json.loads(history["summary"])
        """What summary.json of the command line holds: max_drift_percent, residual_drift_percent, overturned, ..."""

    @property
    def drift(self) -> numpy.ndarray:
        """Displacement over the height [-]."""
        return self.displacement / self.height

    def frame(self) -> pandas.DataFrame:
        """The history as a table of pandas: time [s], ground [m/s2], displacement [m], drift [-], base_shear [N]."""
        import pandas
        return pandas.DataFrame({"time": self.time, "ground": self.ground, "displacement": self.displacement,
                                 "drift": self.drift, "base_shear": self.base_shear})

    def __repr__(self) -> str:
        drift = self.summary["max_drift_percent"]
        return f"<Shaking by {self.motion}: {'failed' if drift is None else f'{drift:.3g} % of drift'}>"


def shake(study: str | os.PathLike[str] | None = None, set: Mapping[str, Value] | None = None, *, wall: Wall | None = None,
          sample: int | Literal["mean"] | None = None, level: str = "") -> list[Shaking]:
    """Shakes one wall with each record at each intensity of [shaking], as `drystone shake` does.

    >>> shake("configs/shaken.ini", set={"shaking.intensities": "0.3, 0.6 g"})  # doctest: +SKIP

    :param study: STUDY.ini; None: `set` has all values
    :param set: section.key: value
    :param wall: in the place of all that the study file says in [wall] and [lintel]
    :param sample: of a study with distributions, from 0; "mean": the wall of the mean values
    :param level: the vertical stress, "0.75 MPa", of a study with several
    :raises ConfigError: FILE:LINE: KEY: what is wrong and what to write
    """
    mean = sample == "mean"
    return [Shaking(h) for h in _core.shake(Study(study, set, wall=wall)._study, None if mean else sample, mean, level)]
