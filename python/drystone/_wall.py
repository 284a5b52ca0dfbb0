"""Walls of one's own."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy
from numpy.typing import ArrayLike

from drystone._values import Value


def _outline(corners: ArrayLike) -> str:
    points = numpy.asarray(corners, float)
    if points.ndim != 2 or points.shape[1] != 2 or len(points) < 3:
        raise ValueError(f"an outline is n x 2 numbers, n >= 3, not {' x '.join(map(str, points.shape))}")
    x, z = points.T
    clockwise = numpy.dot(x, numpy.roll(z, -1)) < numpy.dot(numpy.roll(x, -1), z)
    return ", ".join(f"{x!r} {z!r}" for x, z in (points[::-1] if clockwise else points).tolist())


class Wall:
    """The blocks of a wall, given as polygons, in the place of those of a study file.

    >>> steps = [[(0, 0), (0.6, 0), (0.6, 0.2), (0, 0.2)], [(0, 0.2), (0.3, 0.2), (0.3, 0.4), (0, 0.4)],
    ...          [(0.3, 0.2), (0.6, 0.2), (0.6, 0.4), (0.3, 0.4)]]
    >>> wall = Wall(steps, thickness=0.2)

    :param blocks: the outline of each unit, n x 2 coordinates x, z [m], in either direction, without the first corner again;
        the floor is z = 0. They must meet along their sides, within 1 micrometre, and not overlap
    :param thickness: [m]
    :param layers: of each unit the name of its stone, or "" for that of the wall; `layer_stones` says what they are
    :param keys: what else [wall] has: base="joint", unit_length="0.4 m", layer_stones="lintel: 30 GPa, 0.2, 2500 kg/m3"
    """

    def __init__(self, blocks: Iterable[ArrayLike], thickness: float, layers: Sequence[str] | None = None, **keys: Value) -> None:
        outlines = [_outline(block) for block in blocks]
        if not outlines:
            raise ValueError("a wall has one block at least")
        if layers is not None:
            if len(layers) != len(outlines):
                raise ValueError(f"{len(layers)} layers for {len(outlines)} blocks")
            outlines = [f"{layer}: {outline}" if layer else outline for layer, outline in zip(layers, outlines)]
        self._keys: dict[str, Value] = {"wall.outlines": "; ".join(outlines), "wall.thickness": f"{float(thickness)!r} m"}
        self._keys.update({f"wall.{name}": value for name, value in keys.items()})

    @property
    def keys(self) -> Mapping[str, Value]:
        """The keys of a study file that say the same."""
        return dict(self._keys)

    def __repr__(self) -> str:
        return f"<Wall of {str(self._keys['wall.outlines']).count(';') + 1} blocks>"
