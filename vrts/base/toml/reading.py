"""TOML with places: the one way in which vrts reads scenes and tasks.

Values come from `tomllib`, places from `base.toml.places`; the two must see the same shape.
"""

import tomllib
from typing import cast

from vrts.base.source import SourceFile
from vrts.base.toml.kinds import Fields
from vrts.base.toml.places import Layout, Place, places
from vrts.base.toml.problems import Problems
from vrts.base.toml.syntax import LONGEST, refused, too_deep, too_long
from vrts.base.toml.table import Table

__all__ = ["Problems", "Table", "read_toml"]


def read_toml(source: SourceFile) -> tuple[Table | None, Problems]:
    """Return the top table of a TOML text. None, with one diagnostic, when it is not TOML."""
    problems = Problems(source)
    if len(source.text) > LONGEST:
        problems.found.append(too_long(source))
        return None, problems
    layout = places(source.text)
    if layout.too_deep:
        problems.found.append(too_deep(source, layout.lost_at or 0))
        return None, problems
    try:
        fields = cast("Fields", tomllib.loads(source.text))
    except ValueError as refusal:  # TOMLDecodeError, and numbers too long for Python
        problems.found.append(refused(source, str(refusal), layout))
        return None, problems
    _agree(layout, fields)
    return Table(problems, "", fields, layout.root), problems


def _agree(layout: Layout, fields: Fields) -> None:
    """Raise when the scanner has seen another shape than `tomllib`: a fault of ours."""
    if layout.lost_at is not None or not _same_shape(layout.root, fields):
        raise AssertionError(f"places and values of a TOML text disagree near {layout.lost_at}")


def _same_shape(place: Place, value: object) -> bool:
    if isinstance(value, dict):
        fields = cast("Fields", value)
        return (
            place.fields is not None
            and place.fields.keys() == fields.keys()
            and all(_same_shape(place.fields[key], item) for key, item in fields.items())
        )
    if isinstance(value, list):
        items = cast("list[object]", value)
        return (
            place.items is not None
            and len(place.items) == len(items)
            and all(map(_same_shape, place.items, items))
        )
    return place.fields is None and place.items is None
