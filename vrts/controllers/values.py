"""The fields of a model by their names: to be shown, changed, compared and hashed."""

import hashlib
import json
from collections.abc import Iterator, Mapping
from dataclasses import replace
from enum import Enum
from types import MappingProxyType
from typing import TypeAlias

from vrts.controllers.model import AlignTurn, ControllerModel

Value: TypeAlias = float | bool | Enum | None

# Fields that came after files held digests, and what was done before. A model that says the same
# is the same model, so what was saved then is still known again.
LATER: Mapping[str, Value] = MappingProxyType(
    {
        "lines.align": AlignTurn.SMALLEST,
        "branches.shoulder_boundary_m": 25e-3,
        "branches.elbow_boundary_m": 25e-3,
        "branches.wrist_boundary_deg": 0.01,
    }
)


def values(model: ControllerModel) -> Iterator[tuple[str, Value]]:
    """Yield every field of a model by its name, with its value."""
    groups = {
        "pace": model.pace,
        "corners": model.corners,
        "lines": model.lines,
        "stops": model.stops,
        "next_motion": model.next_motion,
        "programs": model.programs,
        "branches": model.branches,
    }
    for group, part in groups.items():
        for name, value in part._asdict().items():
            yield f"{group}.{name}", value


def with_value(model: ControllerModel, name: str, value: Value) -> ControllerModel:
    """Return a model with another value of a field. Raises AttributeError when there is none."""
    group, _, field = name.partition(".")
    part = getattr(model, group)
    getattr(part, field)
    return replace(model, **{group: part._replace(**{field: value})})


def differing(model: ControllerModel, from_: ControllerModel) -> Iterator[str]:
    """Yield the names of the fields in which two models differ."""
    other = dict(values(from_))
    yield from (name for name, value in values(model) if value != other[name])


def digest(model: ControllerModel) -> str:
    """Return the hash of what a model says; its name and title are no part of it."""
    said = {
        name: v.value if isinstance(v, Enum) else v
        for name, v in values(model)
        if name not in LATER or v != LATER[name]
    }
    whole = json.dumps([said, model.fitted_from], sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(whole.encode()).hexdigest()
