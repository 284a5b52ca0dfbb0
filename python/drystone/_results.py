"""The file of a study."""
from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy

from drystone._load import core as _core
from drystone._values import Value, overrides as _overrides

if TYPE_CHECKING:
    import pandas


class _Drifts(NamedTuple):
    values: numpy.ndarray
    """[%] of the height of the load line"""
    censored: numpy.ndarray
    """True: the wall had not reached the limit state at this drift"""


class Drifts(_Drifts):
    """Limit drifts of walls, as drystone.fragility takes them: fit(*drifts)."""
    capped: numpy.ndarray
    """True: a drift limit of a code or of the study, not the wall's own; no law describes it"""

    def __new__(cls, values: numpy.ndarray, censored: numpy.ndarray, capped: numpy.ndarray | None = None) -> Drifts:
        drifts = super().__new__(cls, values, censored)
        drifts.capped = numpy.zeros(len(values), bool) if capped is None else capped
        return drifts


class Results:
    """What the file of a study holds, by wall: level by level, sample by sample. NaN: not defined on this wall."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path: str = os.fspath(path)
        file = _core.read_walls(self.path)
        self.level: numpy.ndarray = file["level"]
        """Number of the vertical stress of each wall, from 0."""
        self.sample: numpy.ndarray = file["sample"]
        """Number of each wall under its vertical stress, from 0."""
        self.failed: numpy.ndarray = file["status"] != 0
        """Walls whose run failed; `reasons` says why."""
        self.reasons: list[str] = file["reasons"]
        self.vertical_stress: numpy.ndarray = file["vertical_stress"]
        """Of each level [Pa]."""
        self.missing: int = file["missing"]
        """Walls of the study that the file has not."""
        self._stamp: str = file["stamp"]
        self.configuration: str = file["configuration"]
        """The study file in full."""
        self.solver_revision: str = file["solver_revision"]
        """Revision of the solver that pushed the walls; empty in files of before 0.2.0. `drystone.__solver_revision__` is this program's."""
        self.inputs: dict[str, numpy.ndarray]
        """Random values of the walls in SI, by name."""
        self.responses: dict[str, numpy.ndarray]
        """peak_force [N], peak_displacement [m], ..., by name; `units` and `meanings` say what they are."""
        self.counts: dict[str, numpy.ndarray]
        """cracked_units, ..., by name."""
        self.piers: dict[str, numpy.ndarray] = file["piers"]
        """Of walls with openings: from, to, bottom, top [m] and storey of each pier; normal_before, shear_at_peak [N], end_movement [m], ...,
        by wall and pier. Empty of walls without piers. docs/store.md says what they are."""
        self.spandrels: dict[str, numpy.ndarray] = file["spandrels"]
        """The same of the masonry above each opening: from, to, bottom, top [m]; normal_at_peak, shear_at_peak, largest_shear [N], end_drop [m].
        Empty of walls without piers, and of files of before 0.4.0."""
        self.units: dict[str, str] = {}
        self.meanings: dict[str, str] = {}
        for group in ("inputs", "responses", "counts"):
            arrays, about = file[group]
            setattr(self, group, arrays)
            for name, (unit, meaning) in about.items():
                self.units[name], self.meanings[name] = unit, meaning

    def __len__(self) -> int:
        return len(self.level)

    @cached_property
    def curves(self) -> list[tuple[numpy.ndarray, numpy.ndarray]]:
        """Displacement [m] and force [N] of each wall."""
        return _core.read_curves(self.path, self._stamp)

    def readings(self, set: Mapping[str, Value] | None = None) -> dict[str, numpy.ndarray]:
        """How each wall is read: "mode" ("rocking", "sliding", "mixed"; "" of a wall that gave no result), "ultimate_displacement"
        and "collapse_displacement" [m], "ultimate_drift" [-], and the drift [%] of each limit state, "ntc SLV". "ntc SLV censored":
        True where the drift is a lower bound. docs/numbers.md says what they are.

        :param set: fragility.key: value, in place of the study's
        """
        modes, readings = _core.read_readings(self.path, self._stamp, _overrides(set))
        columns = {"mode": numpy.array(modes, str)}
        for name, values, censored in readings:
            columns[name] = values
            columns[f"{name} censored"] = numpy.array(censored, bool)
        return columns

    @property
    def solver_error(self) -> numpy.ndarray:
        """Estimated error of the peak force of each wall by the speed of the solver's drive [-]; nan: the wall failed, or the file is
        of a version that did not measure it. The study asks for solver.accuracy."""
        return self.responses.get("solver_error", numpy.full(len(self), numpy.nan))

    @property
    def points_error(self) -> numpy.ndarray:
        """Estimated error of the force of each wall by the number of contact points, over its peak force [-]; nan as above."""
        return self.responses.get("points_error", numpy.full(len(self), numpy.nan))

    @property
    def solver_error_text(self) -> str:
        """What `drystone study` says of both errors, and of the audit."""
        return _core.read_audit(self.path, self._stamp)[1]

    @property
    def audit(self) -> dict[str, numpy.ndarray]:
        """Walls that were pushed again more slowly (uq.audit): their level and sample, and the relative difference between both pushes
        of peak_force and ultimate_displacement [-]; nan: not defined on one of them. A table: pandas.DataFrame(results.audit)."""
        return _core.read_audit(self.path, self._stamp)[0]

    @property
    def other_way(self) -> dict[str, numpy.ndarray]:
        """Walls that were pushed the other way (load.direction = both): their level, sample and responses, in SI; empty of a study that
        was pushed one way. `responses` and `curves` are of the direction of the study; `readings` and `drifts` are the worse of both."""
        return _core.read_other_way(self.path, self._stamp)

    def frame(self) -> pandas.DataFrame:
        """Inputs, responses, counts and readings as a table of pandas, by level and sample, in SI; drifts of limit states in percent."""
        import pandas
        index = pandas.MultiIndex.from_arrays([self.level, self.sample], names=["level", "sample"])
        stress = {"vertical_stress": self.vertical_stress[self.level]}
        return pandas.DataFrame({**stress, **self.inputs, **self.responses, **self.counts, **self.readings(), "failed": self.failed},
                                index)

    def curve_frame(self) -> pandas.DataFrame:
        """All curves as a table of pandas: displacement [m], force [N], by level and sample."""
        import pandas
        points = [len(force) for _, force in self.curves]
        index = pandas.MultiIndex.from_arrays([numpy.repeat(self.level, points), numpy.repeat(self.sample, points)],
                                              names=["level", "sample"])
        displacement, force = (numpy.concatenate([c[i] for c in self.curves]) if points else numpy.empty(0) for i in (0, 1))
        return pandas.DataFrame({"displacement": displacement, "force": force}, index)

    @property
    def limit_states(self) -> list[str]:
        """Names that `drifts` takes: "ntc SLV"."""
        return _core.read_drifts(self.path, self._stamp, [])[0]

    def drifts(self, limit_state: str, level: int = 0, set: Mapping[str, Value] | None = None) -> Drifts:
        """Drifts at which the walls under a vertical stress reached a limit state. Warns where a drift limit comes first.

        :param limit_state: one of `limit_states`
        :param set: fragility.key: value, in place of the study's
        """
        states, levels = _core.read_drifts(self.path, self._stamp, _overrides(set))
        if limit_state not in states:
            raise ValueError(f"{limit_state!r} is none of {', '.join(states)}")
        values, censored, capped, limit = levels[level][states.index(limit_state)]
        if limit:
            warnings.warn(f"{limit_state}: {limit}: no law describes these drifts (Drifts.capped marks them)", stacklevel=2)
        return Drifts(values, numpy.array(censored, bool), numpy.array(capped, bool))

    def __repr__(self) -> str:
        return f"<Results {self.path}: {len(self)} walls, {int(self.failed.sum())} failed, {self.missing} still to run>"


def open(path: str | os.PathLike[str]) -> Results:
    """Reads the file of a study; a study that is still running too.

    >>> results = open("runs/paper.h5")      # doctest: +SKIP
    >>> results.responses["peak_force"]      # doctest: +SKIP
    >>> results.frame().groupby("level").mean()  # doctest: +SKIP

    :raises StoreError: no such file, damaged, of another program
    """
    return Results(path)
