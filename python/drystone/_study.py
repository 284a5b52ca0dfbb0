"""Studies, and walls pushed one by one."""
from __future__ import annotations

import json
import os
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy

from drystone._load import core as _core
from drystone._results import Results, open as _open
from drystone._values import Value, overrides as _overrides
from drystone._wall import Wall

if TYPE_CHECKING:
    import pandas


class Frame(NamedTuple):
    """A wall at one instant of its push."""
    displacement: float
    """of the load line [m]"""
    force: float
    """[N]"""
    outlines: list[numpy.ndarray]
    """of each block as it stands then, n x 2 coordinates x, z [m]; a loading beam is the last"""


class Curve(NamedTuple):
    """Points of a curve."""
    displacement: numpy.ndarray
    """[m]"""
    force: numpy.ndarray
    """[N]"""


class _Summary(dict):
    """Finds numbers by the keys of earlier versions, too."""

    def __missing__(self, key: str) -> Any:
        return self[_core.old_summary_keys()[key]]


class Push:
    """One wall pushed. Its curve is an array of numpy, to be plotted as it is."""

    def __init__(self, wall: Any) -> None:
        self._wall = wall
        self._summary: dict[str, Any] | None = None

    @property
    def displacement(self) -> numpy.ndarray:
        """Of the load line [m]."""
        return self._wall.displacement

    @property
    def force(self) -> numpy.ndarray:
        """Horizontal load [N]."""
        return self._wall.force

    @property
    def drift(self) -> numpy.ndarray:
        """Displacement over the height of the load line [-]."""
        return self._wall.displacement / self._wall.height

    @property
    def height(self) -> float:
        """Of the load line above the floor [m]."""
        return self._wall.height

    @property
    def vertical_stress(self) -> float:
        """[Pa]"""
        return self._wall.vertical_stress

    @property
    def level(self) -> int:
        """Number of the vertical stress in the study, from 0."""
        return self._wall.level

    @property
    def sample(self) -> int | None:
        """Number of the wall in the study, from 0; None: not one of its walls."""
        return self._wall.sample

    @property
    def failed(self) -> bool:
        """Whether the numbers of the run broke; summary["outcome"] says how."""
        return self._wall.failed

    @property
    def solver_error(self) -> float:
        """Estimated error of the peak force by the speed of the solver's drive [-]; nan where the run failed. The study asks
        for solver.accuracy."""
        return self._wall.solver_error

    @property
    def points_error(self) -> float:
        """Estimated error of the force by the number of contact points, over the peak force [-]; nan where the run failed."""
        return self._wall.points_error

    @property
    def summary(self) -> dict[str, Any]:
        """What summary.json of the command line holds: peak_force_kN, ultimate_displacement_mm, mode, ... What is not
        defined on this wall is None."""
        if self._summary is None:
            self._summary = json.loads(self._wall.summary_json(), object_hook=_Summary)
        return self._summary

    def capacity_csv(self) -> str:
        """The text of capacity.csv as the command line writes it: displacement [mm], drift [%], force [kN], base shear,
        unbalance and energies."""
        return self._wall.capacity_csv()

    def capacity_svg(self) -> str:
        """The text of capacity.svg: the curve with its peak."""
        return self._wall.capacity_svg()

    def wall_svg(self) -> str:
        """The text of wall.svg: the wall at its peak and at the end. Of a wall of `Study.push` it needs frames=True."""
        return self._wall.wall_svg()

    @property
    def frames(self) -> list[Frame]:
        """The wall as it moves: at the end, and with frames=True before the push and every output.snapshot_every of its way.

        >>> ax.add_collection(PolyCollection(wall.frames[-1].outlines, facecolor="0.9", edgecolor="0"))  # doctest: +SKIP
        """
        return [Frame(*frame) for frame in self._wall.frames()]

    @property
    def cycles(self) -> dict[str, numpy.ndarray]:
        """Of a push to and fro, by cycle, in SI, what cycles.csv has: cycle (from 1), amplitude, displacement_plus, displacement_minus,
        residual_plus, residual_minus, half_width, shift [m], force_plus, force_minus [N], energy [J], damping [-], stiffness [N/m],
        stiffness_share [-], closed (1: it came back to zero), and where the energy went: friction, fracture, crushing, solver, stored,
        closing (a part of friction) [J]. nan: a cycle has no such value. docs/cyclic.md says what they are.

        >>> pandas.DataFrame(wall.cycles)  # doctest: +SKIP
        """
        return self._wall.cycles()

    @property
    def piers(self) -> dict[str, Any]:
        """Of a wall with openings, by pier from the left, storey by storey: its place from, to, bottom, top [m], storey, normal_before,
        normal_at_peak, shear_at_peak, largest_shear [N], drift over its own height [-], slenderness H0/D [-], mode. Empty columns of a
        wall without piers. A table: pandas.DataFrame(wall.piers). `piers.csv` of a push has the same."""
        return self._wall.piers()

    @property
    def spandrels(self) -> dict[str, numpy.ndarray]:
        """The same of the masonry above each opening: place [m], normal_at_peak, shear_at_peak, largest_shear [N], drift over its
        own length [-]."""
        return self._wall.spandrels()

    @property
    def backbones(self) -> dict[str, Curve]:
        """Envelopes of first cycles, "right" and "left", displacements and forces positive on either side."""
        return {"right": Curve(*self._wall.backbone(1)), "left": Curve(*self._wall.backbone(-1))}

    def frame(self) -> pandas.DataFrame:
        """The curve as a table of pandas: displacement [m], drift [-], force [N]."""
        import pandas
        return pandas.DataFrame({"displacement": self.displacement, "drift": self.drift, "force": self.force})

    def __repr__(self) -> str:
        peak = "failed" if self.failed else f"peak {self.summary['peak_force_kN']:.4g} kN"
        return f"<Push under {self.vertical_stress * 1e-6:.2f} MPa: {peak}>"


def _places(columns: dict[str, Any]) -> dict[str, numpy.ndarray]:
    return {name: numpy.asarray(values) for name, values in columns.items()}


class Study:
    """A study file, or the file of its results, with values in place of its own.

    >>> study = Study("configs/quick.ini", set={"uq.samples": 8, "solver.fidelity": "rigid"})  # doctest: +SKIP

    :param path: STUDY.ini, or FILE.h5; None: `set` has all values
    :param set: section.key: value
    :param wall: in the place of all that the study file says in [wall] and [lintel]
    :raises ConfigError: FILE:LINE: KEY: what is wrong and what to write
    """

    def __init__(self, path: str | os.PathLike[str] | None = None, set: Mapping[str, Value] | None = None, *,
                 wall: Wall | None = None) -> None:
        self._study = _core.load_study("" if path is None else os.fspath(path), _overrides(set),
                                       [] if wall is None else _overrides(wall.keys))
        for note in self._study.notes().splitlines():
            warnings.warn(note.removeprefix("note: "), stacklevel=2)

    @property
    def vertical_stress(self) -> numpy.ndarray:
        """Of each level [Pa]."""
        return numpy.array(self._study.vertical_stress)

    @property
    def samples(self) -> int:
        """Walls under each vertical stress."""
        return self._study.samples

    @property
    def bond(self) -> dict[str, float]:
        """How well the units are interlocked, as `drystone scene` says it (docs/theory.md, Scenes): trace [m], trace_ratio,
        level_trace_ratio, least_overlap and mean_overlap [-]; mean_length and mean_height of a unit [m]; shares of long_stones
        and middle_stones, and filled [-], for the masonry quality index. What is not defined on this wall is nan."""
        return self._study.bond()

    @property
    def configuration(self) -> str:
        """The study in full, as a study file that reads back to the same study."""
        return self._study.configuration

    @property
    def inputs(self) -> list[str]:
        """Names of the random values of a wall; of values per joint one for each: "joint.friction_angle.17"."""
        return [name for name, _, _ in self._study.columns()]

    @property
    def units(self) -> list[str]:
        """Of the inputs: "Pa", "rad", "-"."""
        return [unit for _, unit, _ in self._study.columns()]

    @property
    def joints(self) -> dict[str, numpy.ndarray]:
        """Where each joint is, in the order of its `id`: kind ("bed joint", "head joint"), course and unit that it lies on or ends,
        middle x, z and length [m]. Input "joint.friction_angle.17" is that of id 17. A table: pandas.DataFrame(study.joints).
        Of random layouts those of the first."""
        return _places(self._study.joints())

    @property
    def cracks(self) -> dict[str, numpy.ndarray]:
        """The same of each potential crack, behind inputs such as "unit.tensile_strength.17"."""
        return _places(self._study.cracks())

    def draws(self, level: int = 0) -> numpy.ndarray:
        """Random values of the walls under a vertical stress, in SI: one row per sample, columns as `inputs`."""
        return self._study.draws(level)

    def frame(self) -> pandas.DataFrame:
        """All draws as a table of pandas, by level and sample, in SI."""
        import pandas
        levels = range(len(self.vertical_stress))
        index = pandas.MultiIndex.from_product([levels, range(self.samples)], names=["level", "sample"])
        return pandas.DataFrame(numpy.vstack([self.draws(level) for level in levels]), index, self.inputs)

    def push(self, samples: Iterable[int] | None = None, level: int | None = None, *,
             inputs: Sequence[Sequence[float]] | numpy.ndarray | None = None, threads: int = 0,
             frames: bool = False) -> list[Push]:
        """Pushes walls side by side, each with the bits that it has alone and in a study.

        :param samples: numbers of the walls, from 0; None: all
        :param level: number of the vertical stress, from 0; None: all of them, one after the other
        :param inputs: in place of samples: one row per wall, columns as `inputs`, in SI; needs the level where there are several
        :param threads: 0: all of this machine
        :param frames: keep what `Push.frames` and `Push.wall_svg` show; takes memory
        """
        if inputs is not None:
            if samples is not None:
                raise TypeError("give samples or inputs, not both")
            if level is None and len(self.vertical_stress) > 1:
                raise TypeError("inputs need the level under which these walls are pushed")
            rows = numpy.atleast_2d(numpy.asarray(inputs, float))
            walls = self._study.push_values(level or 0, rows, threads, frames)
        else:
            levels = range(len(self.vertical_stress)) if level is None else [level]
            chosen = list(range(self.samples) if samples is None else samples)
            walls = self._study.push_samples([(at, sample) for at in levels for sample in chosen], threads, frames)
        return [Push(wall) for wall in walls]

    def run(self, out: str | os.PathLike[str], *, threads: int = 0, rerun_failed: bool = False,
            progress: Callable[[int, int, int], object] | None = None) -> Results:
        """Pushes what the file has not yet, as `drystone study --out` does, and opens it. After Ctrl-C the same call goes on.

        While it runs, no other thread of this process may use HDF5. The callback may.

        :param out: FILE.h5
        :param progress: called after each wall with the walls that are done, that failed, and all of this run; then the same for the
            walls of uq.audit
        """
        self._study.run(os.fspath(out), threads, rerun_failed, progress)
        return _open(out)


def push(study: str | os.PathLike[str] | None = None, set: Mapping[str, Value] | None = None, *, wall: Wall | None = None,
         sample: int | Literal["mean"] | None = None, level: str = "", threads: int = 0, frames: bool = False) -> Push:
    """Pushes one wall, as `drystone push` does.

    >>> push("configs/wall.ini", set={"load.vertical_stress": "0.30 MPa"})  # doctest: +SKIP

    :param study: STUDY.ini, or FILE.h5; None: `set` has all values
    :param set: section.key: value
    :param wall: in the place of all that the study file says in [wall] and [lintel]
    :param sample: of a study with distributions, from 0; "mean": the wall of the mean values
    :param level: the vertical stress, "0.75 MPa", of a study with several
    :param frames: keep the wall as it moves, for `Push.frames`
    :raises ConfigError: FILE:LINE: KEY: what is wrong and what to write
    """
    mean = sample == "mean"
    return Push(Study(study, set, wall=wall)._study.push(None if mean else sample, mean, level, threads, frames))
