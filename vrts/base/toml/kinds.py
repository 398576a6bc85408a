"""Kinds of values: each takes the value of a key as it is wanted, or says why it cannot."""

import math
from collections.abc import Callable, Iterable, Mapping
from datetime import datetime
from difflib import get_close_matches
from typing import NamedTuple, TypeAlias, TypeVar, cast

from vrts.base.diagnostic import NO_DATA, Datum, Rule

WRONG_TYPE = Rule("V604", "wrong-type")
OUT_OF_RANGE = Rule("V605", "out-of-range")
UNKNOWN_CHOICE = Rule("V606", "unknown-choice")

LARGEST_INTEGER = 10**15  # that is taken for a number

Fields: TypeAlias = dict[str, object]
T = TypeVar("T")


class Wrong(NamedTuple):
    """Why a value is not of its kind."""

    rule: Rule
    headline: str
    text: str = ""  # beside the value
    element: int | None = None  # of a list; None: the whole value
    notes: tuple[str, ...] = ()
    help: tuple[str, ...] = ()
    instead: str = ""  # what to write for the value
    data: Mapping[str, Datum] = NO_DATA


Kind: TypeAlias = Callable[[str, object], T | Wrong]  # of a key and its value


def text(choices: Iterable[str] | None) -> Kind[str]:
    """Return the kind of a text, one of `choices` when they are given."""

    def read(key: str, value: object) -> str | Wrong:
        if not isinstance(value, str):
            return _wrong_type(key, "text in quotation marks", value)
        known = None if choices is None else tuple(choices)
        return value if known is None or value in known else _unknown_choice(key, value, known)

    return read


def number(
    minimum: float = -math.inf, maximum: float = math.inf, above: float = -math.inf
) -> Kind[float]:
    """Return the kind of a finite number within bounds."""

    def read(key: str, value: object) -> float | Wrong:
        found = _finite(value)
        if found is None:
            return _wrong_type(key, "a number", value)
        return _outside(f"`{key}`", found, minimum, maximum, above) or found

    return read


def integer(
    minimum: float = -math.inf, maximum: float = math.inf, above: float = -math.inf
) -> Kind[int]:
    """Return the kind of a whole number within bounds."""

    def read(key: str, value: object) -> int | Wrong:
        if not isinstance(value, int) or isinstance(value, bool):
            return _wrong_type(key, "a whole number", value)
        return _outside(f"`{key}`", value, minimum, maximum, above) or value

    return read


def boolean(key: str, value: object) -> bool | Wrong:
    """Take true or false."""
    return value if isinstance(value, bool) else _wrong_type(key, "true or false", value)


def time(key: str, value: object) -> datetime | Wrong:
    """Take a date with a time and its offset from UTC."""
    wanted = "a date with time and offset, such as 2026-11-30T23:59:00+01:00"
    if not isinstance(value, datetime):
        return _wrong_type(key, wanted, value)
    if value.tzinfo is None:
        return _not(key, wanted)._replace(text="this has no offset from UTC", data={"key": key})
    return value


def numbers(
    counts: tuple[int, ...] | None,
    minimum: float = -math.inf,
    maximum: float = math.inf,
    above: float = -math.inf,
) -> Kind[tuple[float, ...]]:
    """Return the kind of a list of finite numbers within bounds, of one of the lengths."""
    length = " or ".join(str(count) for count in counts or ())
    wanted = f"a list of {length} numbers" if counts else "a list of numbers"

    def read(key: str, value: object) -> tuple[float, ...] | Wrong:
        if not isinstance(value, list):
            return _wrong_type(key, wanted, value)
        items = cast("list[object]", value)
        if counts and len(items) not in counts:
            wrong = _not(key, f"{wanted}, not of {len(items)}")
            return wrong._replace(data={"key": key, "count": len(items)})
        found: list[float] = []
        for index, item in enumerate(items):
            taken = _finite(item)
            if taken is None:
                return _not(key, wanted)._replace(text=f"this is {_word(item)}", element=index)
            beyond = _outside(f"every number of `{key}`", taken, minimum, maximum, above)
            if beyond is not None:
                return beyond._replace(element=index)
            found.append(taken)
        return tuple(found)

    return read


def texts(key: str, value: object) -> tuple[str, ...] | Wrong:
    """Take a list of texts."""
    wanted = "a list of texts"
    if not isinstance(value, list):
        return _wrong_type(key, wanted, value)
    found: list[str] = []
    for index, item in enumerate(cast("list[object]", value)):
        if not isinstance(item, str):
            return _not(key, wanted)._replace(text=f"this is {_word(item)}", element=index)
        found.append(item)
    return tuple(found)


def array(key: str, value: object) -> list[object] | Wrong:
    """Take a list of at least one value, of whatever kind."""
    if not isinstance(value, list):
        return _wrong_type(key, "a list", value)
    return cast("list[object]", value) or Wrong(OUT_OF_RANGE, f"`{key}` names nothing")


def names(choices: Iterable[str] | None) -> Kind[tuple[str, ...]]:
    """Return the kind of one of `choices`, or of a list of some of them, each once."""
    known = None if choices is None else tuple(choices)

    def read(key: str, value: object) -> tuple[str, ...] | Wrong:
        if isinstance(value, str):
            fits = known is None or value in known
            return (value,) if fits else _unknown_choice(key, value, known or ())
        if not isinstance(value, list):
            return _wrong_type(key, "text in quotation marks, or a list of texts", value)
        found = texts(key, cast("object", value))
        if isinstance(found, Wrong):
            return found
        for index, name in enumerate(found):
            if known is not None and name not in known:
                return _unknown_choice(key, name, known)._replace(element=index)
            if name in found[:index]:
                return Wrong(OUT_OF_RANGE, f"`{key}` names `{name}` twice", element=index)
        return found or Wrong(OUT_OF_RANGE, f"`{key}` names nothing")

    return read


def fields(path: str) -> Kind[Fields]:
    """Return the kind of a table with the header `[path]`."""

    def read(key: str, value: object) -> Fields | Wrong:
        if not isinstance(value, dict):
            return _wrong_type(key, f"a table `[{path}]`", value)
        return cast("Fields", value)

    return read


def list_of_fields(path: str) -> Kind[list[Fields]]:
    """Return the kind of tables with headers `[[path]]`."""

    def read(key: str, value: object) -> list[Fields] | Wrong:
        items = cast("list[object]", value) if isinstance(value, list) else None
        if items is None or not all(isinstance(item, dict) for item in items):
            return _wrong_type(key, f"tables with headers `[[{path}]]`", cast("object", value))
        return cast("list[Fields]", items)

    return read


def _not(key: str, wanted: str) -> Wrong:
    return Wrong(WRONG_TYPE, f"`{key}` must be {wanted}")


def _wrong_type(key: str, wanted: str, value: object) -> Wrong:
    return _not(key, wanted)._replace(text=f"this is {_word(value)}", data={"key": key})


def _unknown_choice(key: str, value: str, known: tuple[str, ...]) -> Wrong:
    close = get_close_matches(value, known, 1, 0.6)
    return Wrong(
        UNKNOWN_CHOICE,
        f"unknown `{key}`: `{value}`",
        notes=(f"known: {', '.join(f'`{name}`' for name in known)}",),
        help=(f"did you mean `{close[0]}`?",) if close else (),
        instead=f'"{close[0]}"' if close else "",
        data={"key": key, "value": value},
    )


def _outside(what: str, value: float, minimum: float, maximum: float, above: float) -> Wrong | None:
    """Return what a number must be when it is not: at least, at most, or more than a bound."""
    if minimum <= value <= maximum and value > above:
        return None
    low = f"more than {above:g}" if above >= minimum else f"at least {minimum:g}"
    high = f"at most {maximum:g}"
    if max(minimum, above) == -math.inf:
        wanted = high
    else:
        wanted = low if maximum == math.inf else f"{low} and {high}"
    return Wrong(OUT_OF_RANGE, f"{what} must be {wanted}", data={"value": value})


def _finite(value: object) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    if isinstance(value, int) and abs(value) > LARGEST_INTEGER:
        return None
    return float(value) if math.isfinite(value) else None


def _word(value: object) -> str:
    match value:
        case bool():
            return "true or false"
        case str():
            return "text"
        case int() | float():
            if isinstance(value, int):
                return "a whole number"
            return "a number" if math.isfinite(value) else "not a finite number"
        case list():
            return "a list"
        case dict():
            return "a table"
        case _:
            return "a date or time"
