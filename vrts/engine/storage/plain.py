"""Plain records (named tuples, frozen dataclasses) to JSON and back, told by their annotations.

A record becomes the list of its fields, one of several kinds the name of its kind and that list.
Reading takes nothing for granted: whatever is not as the annotation says raises `Damaged`.
"""

import dataclasses
import math
import re
from collections.abc import Callable, Mapping, Sequence
from enum import Enum
from functools import cached_property
from types import MappingProxyType, NoneType
from typing import Any, NamedTuple, TypeAlias, cast, get_args, get_origin

from vrts.base.diagnostic import Rule
from vrts.base.pose import Pose
from vrts.base.source import SourceFile, Span
from vrts.engine.memory.events import Cause, Landed, Toppled
from vrts.engine.storage.damage import require
from vrts.ir.values import Joints
from vrts.scene.model import Locks, Scenario

Json: TypeAlias = Any
LARGEST = 1e100  # of any number: nothing computed from a few of them overflows
LARGEST_WHOLE = 2**53
# last fields, which records have got since, and what they are where a file does not say
LATER: Mapping[Any, Mapping[str, Any]] = MappingProxyType(
    {
        Scenario: {
            "locks": Locks(),
            "operator": (),
            "draws": (),
            "process_first": (),
            "analog": (),
        },
        Landed: {"also": ()},
        Toppled: {"also": ()},
    }
)
_HALF = re.compile("[\ud800-\udfff]")  # surrogates, which no text file can hold
DEEPEST = 10  # lists in each other in the exact values of a finding


class Pair(NamedTuple):
    """How values of one type are written and read."""

    write: Callable[[Any], Json]
    read: Callable[[Json], Any]


class Unwritable(ValueError):  # noqa: N818 -- names the situation
    """A value has no plain form."""


class Plain:
    """Writes and reads values that point at places in some sources."""

    def __init__(self, sources: Sequence[SourceFile]) -> None:
        """Take the sources; places are written with their numbers."""
        self._sources = tuple(sources)
        self._numbers = {id(source): k for k, source in enumerate(self._sources)}
        self._known: dict[Any, Pair] = {
            float: Pair(_write_number, number),
            int: Pair(_same, whole),
            str: Pair(_same, text),
            bool: Pair(_same, truth),
            Span: Pair(self._write_span, self._read_span),
            Pose: Pair(_write_pose, _read_pose),
            Rule: Pair(list, _read_rule),
            Cause: Pair(self._write_cause, self._read_cause),
        }
        self.causes: list[Cause] = []
        self._cause_numbers: dict[Cause, int] = {}

    def write(self, hint: Any, value: Any) -> Json:
        """Return a value of an annotated type as JSON.

        Raises:
            Unwritable: It cannot be written.
        """
        return self._pair(hint).write(value)

    def read(self, hint: Any, data: Json) -> Any:
        """Return the value that JSON stands for.

        Raises:
            Damaged: It does not stand for a value of this type.
        """
        return self._pair(hint).read(data)

    def cause_number(self, cause: Cause) -> int:
        """Return the number of a cause, giving it one."""
        found = self._cause_numbers.get(cause)
        if found is None:
            found = self._cause_numbers[cause] = len(self.causes)
            self.causes.append(cause)
        return found

    @cached_property
    def _cause_fields(self) -> Pair:
        return self._record(Cause)

    def write_causes(self) -> Json:
        """Return the causes that have numbers."""
        return [self._cause_fields.write(cause) for cause in self.causes]

    def read_causes(self, data: Json) -> None:
        """Take the causes that have numbers."""
        self.causes = [self._cause_fields.read(item) for item in listed(data)]

    # --- types --------------------------------------------------------------------------------

    def _pair(self, hint: Any) -> Pair:
        found = self._known.get(hint)
        if found is None:
            found = self._known[hint] = self._made(hint)
        return found

    def _made(self, hint: Any) -> Pair:
        origin, arguments = get_origin(hint), get_args(hint)
        if origin is tuple:
            return self._tuple(arguments)
        if isinstance(origin, type) and issubclass(origin, Mapping):
            values = arguments[1]
            return self._mapping(DATUM if isinstance(values, str) else self._pair(values))
        if arguments:
            return self._union(arguments)
        if isinstance(hint, type) and issubclass(hint, Enum):
            return _enumerated(hint)
        if isinstance(hint, type) and (dataclasses.is_dataclass(hint) or issubclass(hint, tuple)):
            return self._record(hint)
        raise Unwritable(f"values of {hint!r} are not written")

    def _tuple(self, arguments: tuple[Any, ...]) -> Pair:
        if arguments[1:] == (...,):
            item = self._pair(arguments[0])

            def write_all(values: tuple[Any, ...]) -> Json:
                return [item.write(value) for value in values]

            def read_all(data: Json) -> tuple[Any, ...]:
                return tuple([item.read(value) for value in listed(data)])

            return Pair(write_all, read_all)
        items = [self._pair(argument) for argument in arguments]

        def write(values: tuple[Any, ...]) -> Json:
            return [pair.write(value) for pair, value in zip(items, values, strict=True)]

        def read(data: Json) -> tuple[Any, ...]:
            values = listed(data, len(items))
            return tuple([pair.read(value) for pair, value in zip(items, values, strict=True)])

        return Pair(write, read)

    def _mapping(self, values: Pair) -> Pair:
        def write(mapping: Mapping[str, Any]) -> Json:
            return {name: values.write(value) for name, value in mapping.items()}

        def read(data: Json) -> Mapping[str, Any]:
            return MappingProxyType({k: values.read(value) for k, value in named(data).items()})

        return Pair(write, read)

    def _union(self, arguments: tuple[Any, ...]) -> Pair:
        kinds = [kind for kind in arguments if kind is not NoneType]
        if Pose in kinds:
            inner = Pair(_write_value, _read_value)
        else:
            inner = self._pair(kinds[0]) if len(kinds) == 1 else self._tagged(kinds)
        if len(kinds) == len(arguments):
            return inner

        def write(value: Any) -> Json:
            return None if value is None else inner.write(value)

        def read(data: Json) -> Any:
            return None if data is None else inner.read(data)

        return Pair(write, read)

    def _tagged(self, kinds: list[type]) -> Pair:
        by_name = {kind.__name__: kind for kind in kinds}

        def write(value: Any) -> Json:
            name = value.__class__.__name__
            return [name, self._pair(by_name[name]).write(value)]

        def read(data: Json) -> Any:
            name, fields = listed(data, 2)
            kind = by_name.get(text(name))
            require(kind is not None, f"there is no `{name}`")
            return self._pair(kind).read(fields)

        return Pair(write, read)

    def _record(self, kind: Any) -> Pair:
        hints: dict[str, Any] = kind.__annotations__
        fields = [(name, self._pair(hint)) for name, hint in hints.items()]
        later: dict[str, Any] = dict(LATER.get(kind, {}))
        least = len(fields) - len(later)

        def write(value: Any) -> Json:
            found = [pair.write(getattr(value, name)) for name, pair in fields]
            for name in reversed(list(later)):
                if getattr(value, name) != later[name]:
                    break
                found.pop()
            return found

        def read(data: Json) -> Any:
            values = listed(data)
            require(least <= len(values) <= len(fields), "a list has another length")
            return kind(
                *[pair.read(value) for (_, pair), value in zip(fields, values, strict=False)]
            )

        return Pair(write, read)

    # --- places -------------------------------------------------------------------------------

    def _write_span(self, span: Span) -> Json:
        found = self._numbers.get(id(span.source))
        if found is None:
            raise Unwritable(f"`{span.source.name}` is none of the sources of the run")
        return [found, span.start, span.end]

    def _read_span(self, data: Json) -> Span:
        source, start, end = (whole(part) for part in listed(data, 3))
        require(source < len(self._sources), "a place is in a source that is not there")
        found = self._sources[source]
        require(start <= end <= len(found.text), "a place is outside its source")
        return Span(found, start, end)

    def _write_cause(self, cause: Cause) -> Json:
        return self.cause_number(cause)

    def _read_cause(self, data: Json) -> Cause:
        found = whole(data)
        require(found < len(self.causes), "something is caused by a step that is not there")
        return self.causes[found]


# --- parts of JSON --------------------------------------------------------------------------------


def number(data: Json) -> float:
    """Return a finite number."""
    require(isinstance(data, int | float) and not isinstance(data, bool), "a number is missing")
    require(-LARGEST <= data <= LARGEST, "a number is too large")
    return float(data)


def whole(data: Json) -> int:
    """Return a whole number; `number` of a place in a table is never negative."""
    require(isinstance(data, int) and not isinstance(data, bool), "a whole number is missing")
    require(abs(data) <= LARGEST_WHOLE, "a number is too large")
    return data


def text(data: Json) -> str:
    """Return characters."""
    require(isinstance(data, str), "a text is missing")
    require(_HALF.search(data) is None, "a text has half a character")
    return data


def truth(data: Json) -> bool:
    """Return true or false."""
    require(isinstance(data, bool), "a yes or no is missing")
    return data


def listed(data: Json, count: int | None = None) -> list[Json]:
    """Return a list, of so many items."""
    require(isinstance(data, list), "a list is missing")
    require(count is None or len(data) == count, "a list has another length")
    return data


def named(data: Json) -> dict[str, Json]:
    """Return named parts."""
    require(isinstance(data, dict), "named parts are missing")
    for name in data:
        text(name)
    return data


def _same(value: Any) -> Json:
    return value


def _write_number(value: float) -> Json:
    if not abs(value) <= LARGEST:
        raise Unwritable(f"{value} is too large")
    return float(value)


def _write_pose(X: Pose) -> Json:
    return [*X.rotation, *X.translation]


def _read_pose(data: Json) -> Pose:
    return pose_of_numbers([number(part) for part in listed(data, 12)])


def pose_of_numbers(numbers: Sequence[float]) -> Pose:
    """Return the pose of nine numbers of a rotation and three of a translation [m]."""
    return Pose(tuple(numbers[:9]), tuple(numbers[9:]))  # type: ignore[arg-type]


def joints_of_numbers(numbers: Sequence[float]) -> Joints:
    """Return the configuration of six numbers [rad]."""
    return tuple(numbers)  # type: ignore[return-value]


def _read_rule(data: Json) -> Rule:
    code, slug = (text(part) for part in listed(data, 2))
    known = re.fullmatch(r"V\d{3}", code) and re.fullmatch(r"[a-z0-9-]{1,40}", slug)
    require(bool(known), "a finding has no code")
    return Rule(code, slug)


def _enumerated(kind: type[Enum]) -> Pair:
    values = {member.value: member for member in kind}

    def read(data: Json) -> Enum:
        known = isinstance(data, str) and data in values
        require(known, f"there is no {kind.__name__} `{data}`")
        return values[data]

    def write(member: Enum) -> Json:
        return member.value

    return Pair(write, read)


def _write_value(value: "float | str | Pose | Joints") -> Json:
    if isinstance(value, Pose):
        return {"pose": _write_pose(value)}
    if isinstance(value, tuple):
        return {"joints": list(value)}
    return value


def _read_value(data: Json) -> "float | str | Pose | Joints":
    if isinstance(data, str):
        return text(data)
    if not isinstance(data, dict):
        return number(data)
    parts = named(data)
    if "pose" in parts:
        return _read_pose(parts["pose"])
    require("joints" in parts, "a value is missing")
    return joints_of_numbers([number(part) for part in listed(parts["joints"], 6)])


def _write_datum(value: Any) -> Json:
    if isinstance(value, tuple):
        return [_write_datum(part) for part in cast(tuple[Any, ...], value)]
    if isinstance(value, float) and not math.isfinite(value):
        return {"number": repr(value)}
    return value


def _read_datum(data: Json, depth: int = 0) -> Any:
    if isinstance(data, list):
        require(depth < DEEPEST, "a finding is nested too deep")
        return tuple([_read_datum(part, depth + 1) for part in cast(list[Json], data)])
    if isinstance(data, dict):
        said = named(data).get("number")
        require(said in ("inf", "-inf", "nan"), "a number is missing")
        return float(said)  # type: ignore[arg-type]
    if isinstance(data, float):
        return number(data)
    return text(data) if isinstance(data, str) else data


DATUM = Pair(_write_datum, _read_datum)
