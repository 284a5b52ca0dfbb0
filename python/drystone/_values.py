"""Values of the keys of a study file."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Union

import numpy

Value = Union[str, int, float, bool, None, Sequence[Union[int, float]]]
"""Of a key of the study file: as it is written there, "0.50 MPa", or a number without unit. None takes the key out of the
file."""


def text(value: Value) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, str):
        return value
    if isinstance(value, (Sequence, numpy.ndarray)):
        return ", ".join(text(each) for each in value)
    return repr(value.item() if isinstance(value, numpy.generic) else value)


def overrides(values: Mapping[str, Value] | None) -> list[str]:
    return [f"{key}={text(value)}" for key, value in (values or {}).items()]
