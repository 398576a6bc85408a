"""Where two results differ: the places in the schema, and what stands there."""

import json
from collections.abc import Collection, Iterator
from typing import Any, NamedTuple, cast

import msgspec

from vrts.marking.result import Result

LONGEST = 120  # characters of a value as shown
ABSENT = "nothing"


class Difference(NamedTuple):
    """One place in which two results differ."""

    path: str  # such as `losses[0].points`
    old: str  # the values as JSON, shortened
    new: str


def differences(old: Result, new: Result, without: Collection[str] = ()) -> Iterator[Difference]:
    """Yield where two results differ, in the order of the schema.

    Args:
        old: One result.
        new: The other.
        without: Fields of the result that are not compared.
    """
    for name in old.__struct_fields__:
        if name not in without:
            yield from _between(name, _plain(getattr(old, name)), _plain(getattr(new, name)))


def _plain(value: Any) -> Any:
    """Return a value as JSON has it, with all fields: one that is left out is its usual value."""
    if isinstance(value, msgspec.Struct):
        return {name: _plain(getattr(value, name)) for name in value.__struct_fields__}
    if isinstance(value, tuple):
        return [_plain(item) for item in cast("tuple[Any, ...]", value)]
    return msgspec.to_builtins(value)


def _between(path: str, old: Any, new: Any) -> Iterator[Difference]:
    if isinstance(old, dict) and isinstance(new, dict):
        left, right = cast("dict[str, Any]", old), cast("dict[str, Any]", new)
        for key in {**left, **right}:
            yield from _member(f"{path}.{key}", left, right, key)
    elif isinstance(old, list | tuple) and isinstance(new, list | tuple):
        items = (list(cast("list[Any]", old)), list(cast("list[Any]", new)))
        left, right = ({str(k): item for k, item in enumerate(side)} for side in items)
        for key in {**left, **right}:
            yield from _member(f"{path}[{key}]", left, right, key)
    elif old != new:
        yield Difference(path, _shown(old), _shown(new))


def _member(
    path: str, left: dict[str, Any], right: dict[str, Any], key: str
) -> Iterator[Difference]:
    if key in left and key in right:
        yield from _between(path, left[key], right[key])
    else:
        values = [_shown(side[key]) if key in side else ABSENT for side in (left, right)]
        yield Difference(path, *values)


def _shown(value: Any) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= LONGEST else text[: LONGEST - 1] + "…"
