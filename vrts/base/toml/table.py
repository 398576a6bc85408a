"""Tables whose getters report what is wrong where it stands.

A getter that finds something wrong records one located diagnostic in the shared `Problems` and
returns the default, so that a reader goes on and reports everything in one pass.
"""

import math
from collections.abc import Iterable
from datetime import datetime
from difflib import get_close_matches
from fractions import Fraction
from typing import TypeAlias, cast, overload

from vrts.base.diagnostic import Diagnostic, Fix, Rule
from vrts.base.source import Span
from vrts.base.toml.places import Place
from vrts.base.toml.problems import Problems

UNKNOWN_KEY = Rule("V602", "unknown-key")
MISSING_KEY = Rule("V603", "missing-key")
WRONG_TYPE = Rule("V604", "wrong-type")
OUT_OF_RANGE = Rule("V605", "out-of-range")
UNKNOWN_CHOICE = Rule("V606", "unknown-choice")

Fields: TypeAlias = dict[str, object]


class Table:
    """A table of a TOML file. Ask for every key it may have, then `finish()`."""

    def __init__(self, problems: Problems, path: str, fields: Fields, place: Place) -> None:
        """Wrap the values of a table; `path` is what its header says ("" for the whole file)."""
        self.problems = problems
        self.path = path
        self._fields = fields
        self._place = place
        self._asked: list[str] = []
        self._missing: dict[str, Diagnostic] = {}  # reported as missing

    # what there is

    @property
    def title(self) -> str:
        """The table in words: "`[objects.can1]`"."""
        return f"`[{self.path}]`" if self.path else "the file"

    @property
    def span(self) -> Span:
        """The header of the table, or its braces; the start of the file for the whole file."""
        return self._span(self._place.value)

    @property
    def name_span(self) -> Span:
        """The last part of the table's name in its header."""
        return self._span(self._place.key)

    @property
    def keys(self) -> tuple[str, ...]:
        """Every key, in the order of the file."""
        return tuple(self._fields)

    def __contains__(self, key: str) -> bool:
        return key in self._fields

    def span_of(self, key: str) -> Span:
        """Return where a key stands; the table's header when it is not given."""
        place = self._child(key)
        return self.span if place is None else self._span(place.key)

    def value_span(self, key: str) -> Span:
        """Return where the value of a key stands; the table's header when it is not given."""
        place = self._child(key)
        return self.span if place is None else self._span(place.value)

    def element_span(self, key: str, index: int) -> Span:
        """Return where an element of an array stands."""
        place = self._child(key)
        if place is None or place.items is None:
            return self.value_span(key)
        return self._span(place.items[index].value)

    def overlaid(self, upper: "Table") -> "Table":
        """Return this table with the keys of another one of the same file in place of its own."""
        place = Place(self._place.key, self._place.value)
        place.fields = {**(self._place.fields or {}), **(upper._place.fields or {})}
        return Table(self.problems, self.path, {**self._fields, **upper._fields}, place)

    # plain values

    @overload
    def string(self, key: str, default: str, *, choices: Iterable[str] | None = None) -> str: ...
    @overload
    def string(
        self,
        key: str,
        default: None = None,
        *,
        choices: Iterable[str] | None = None,
        required: bool = False,
    ) -> str | None: ...
    def string(
        self,
        key: str,
        default: str | None = None,
        *,
        choices: Iterable[str] | None = None,
        required: bool = False,
    ) -> str | None:
        """Return a text, one of `choices` when they are given."""
        value = self._take(key, required=required)
        if value is None:
            return default
        if not isinstance(value, str):
            self._wrong_type(key, "text in quotation marks", value)
            return default
        if choices is None:
            return value
        known = tuple(choices)
        if value in known:
            return value
        self._unknown_choice(key, value, known)
        return default

    @overload
    def number(
        self,
        key: str,
        default: float,
        *,
        minimum: float = -math.inf,
        maximum: float = math.inf,
        above: float = -math.inf,
    ) -> float: ...
    @overload
    def number(
        self,
        key: str,
        default: None = None,
        *,
        minimum: float = -math.inf,
        maximum: float = math.inf,
        above: float = -math.inf,
        required: bool = False,
    ) -> float | None: ...
    def number(
        self,
        key: str,
        default: float | None = None,
        *,
        minimum: float = -math.inf,
        maximum: float = math.inf,
        above: float = -math.inf,
        required: bool = False,
    ) -> float | None:
        """Return a finite number: at least `minimum`, at most `maximum`, more than `above`."""
        value = self._take(key, required=required)
        if value is None:
            return default
        number = _number(value)
        if number is None:
            self._wrong_type(key, "a number", value)
            return default
        complaint = _outside(number, minimum, maximum, above)
        if complaint:
            self._out_of_range(f"`{key}`", complaint, self.value_span(key), number)
            return default
        return number

    @overload
    def fraction(
        self, key: str, default: Fraction, *, minimum: float = -math.inf, maximum: float = math.inf
    ) -> Fraction: ...
    @overload
    def fraction(
        self,
        key: str,
        default: None = None,
        *,
        minimum: float = -math.inf,
        maximum: float = math.inf,
        required: bool = False,
    ) -> Fraction | None: ...
    def fraction(
        self,
        key: str,
        default: Fraction | None = None,
        *,
        minimum: float = -math.inf,
        maximum: float = math.inf,
        required: bool = False,
    ) -> Fraction | None:
        """Return a number exactly as written: 0.1 is one tenth."""
        number = self.number(key, minimum=minimum, maximum=maximum, required=required)
        return default if number is None else Fraction(repr(number))

    @overload
    def integer(
        self, key: str, default: int, *, minimum: float = -math.inf, maximum: float = math.inf
    ) -> int: ...
    @overload
    def integer(
        self,
        key: str,
        default: None = None,
        *,
        minimum: float = -math.inf,
        maximum: float = math.inf,
        required: bool = False,
    ) -> int | None: ...
    def integer(
        self,
        key: str,
        default: int | None = None,
        *,
        minimum: float = -math.inf,
        maximum: float = math.inf,
        required: bool = False,
    ) -> int | None:
        """Return a whole number within bounds."""
        value = self._take(key, required=required)
        if value is None:
            return default
        if not isinstance(value, int) or isinstance(value, bool):
            self._wrong_type(key, "a whole number", value)
            return default
        complaint = _outside(value, minimum, maximum, -math.inf)
        if complaint:
            self._out_of_range(f"`{key}`", complaint, self.value_span(key), value)
            return default
        return value

    @overload
    def boolean(self, key: str, default: bool) -> bool: ...
    @overload
    def boolean(self, key: str, default: None = None, *, required: bool = False) -> bool | None: ...
    def boolean(
        self,
        key: str,
        default: bool | None = None,
        *,
        required: bool = False,
    ) -> bool | None:
        """Return true or false."""
        value = self._take(key, required=required)
        if value is None:
            return default
        if not isinstance(value, bool):
            self._wrong_type(key, "true or false", value)
            return default
        return value

    def time(self, key: str, *, required: bool = False) -> datetime | None:
        """Return a date with a time and its offset from UTC: an instant everywhere."""
        value = self._take(key, required=required)
        if value is None:
            return None
        wanted = "a date with time and offset, such as 2026-11-30T23:59:00+01:00"
        if not isinstance(value, datetime):
            self._wrong_type(key, wanted, value)
            return None
        if value.tzinfo is None:
            span = self.value_span(key)
            headline = f"`{key}` must be {wanted}"
            self.problems.error(
                WRONG_TYPE, headline, span, "this has no offset from UTC", data={"key": key}
            )
            return None
        return value

    # lists

    def numbers(
        self,
        key: str,
        default: tuple[float, ...] | None = None,
        *,
        count: int | tuple[int, ...] | None = None,
        minimum: float = -math.inf,
        maximum: float = math.inf,
        above: float = -math.inf,
        required: bool = False,
    ) -> tuple[float, ...] | None:
        """Return a list of finite numbers, of the given length (or one of the lengths)."""
        value = self._take(key, required=required)
        if value is None:
            return default
        counts = (count,) if isinstance(count, int) else count
        wanted = f"a list of {_counted(counts)} numbers" if counts else "a list of numbers"
        if not isinstance(value, list):
            self._wrong_type(key, wanted, value)
            return default
        items = cast("list[object]", value)
        if counts and len(items) not in counts:
            headline = f"`{key}` must be {wanted}, not of {len(items)}"
            self.problems.error(
                WRONG_TYPE, headline, self.value_span(key), data={"key": key, "count": len(items)}
            )
            return default
        found: list[float] = []
        for index, item in enumerate(items):
            number = _number(item)
            span = self.element_span(key, index)
            if number is None:
                headline = f"`{key}` must be {wanted}"
                self.problems.error(WRONG_TYPE, headline, span, f"this is {_kind(item)}")
                return default
            complaint = _outside(number, minimum, maximum, above)
            if complaint:
                self._out_of_range(f"every number of `{key}`", complaint, span, number)
                return default
            found.append(number)
        return tuple(found)

    def strings(
        self, key: str, default: tuple[str, ...] | None = None, *, required: bool = False
    ) -> tuple[str, ...] | None:
        """Return a list of texts."""
        value = self._take(key, required=required)
        if value is None:
            return default
        if not isinstance(value, list):
            self._wrong_type(key, "a list of texts", value)
            return default
        found: list[str] = []
        for index, item in enumerate(cast("list[object]", value)):
            if not isinstance(item, str):
                span = self.element_span(key, index)
                headline = f"`{key}` must be a list of texts"
                self.problems.error(WRONG_TYPE, headline, span, f"this is {_kind(item)}")
                return default
            found.append(item)
        return tuple(found)

    # tables

    def table(self, key: str, *, required: bool = False) -> "Table | None":
        """Return the table `[key]`."""
        value = self._take(key, required=required)
        if value is None:
            return None
        if not isinstance(value, dict):
            self._wrong_type(key, f"a table {_header(self._joined(key))}", value)
            return None
        place = self._place_of(key)
        return Table(self.problems, self._joined(key), cast("Fields", value), place)

    def tables(self, key: str, *, required: bool = False) -> "tuple[Table, ...]":
        """Return the tables `[[key]]`, in order."""
        value = self._take(key, required=required)
        if value is None:
            return ()
        path = self._joined(key)
        wanted = f"tables with headers `[[{path}]]`"
        items = cast("list[object]", value) if isinstance(value, list) else None
        if items is None or not all(isinstance(item, dict) for item in items):
            self._wrong_type(key, wanted, cast("object", value))
            return ()
        elements = self._place_of(key).items or []
        return tuple(
            Table(self.problems, f"{path} {number}", cast("Fields", item), place)
            for number, (item, place) in enumerate(zip(items, elements, strict=True), 1)
        )

    def named_tables(self, key: str) -> "tuple[tuple[str, Table], ...]":
        """Return the tables `[key.NAME]` with their names, in the order of the file."""
        parent = self.table(key)
        if parent is None:
            return ()
        found: list[tuple[str, Table]] = []
        for name in parent.keys:
            table = parent.table(name)
            if table is not None:
                found.append((name, table))
        return tuple(found)

    def finish(self) -> None:
        """Report every key that nobody asked for."""
        for key in self._fields:
            if key in self._asked:
                continue
            span = self.span_of(key)
            others = [name for name in self._asked if name not in self._fields]
            close = get_close_matches(key, others, 1, 0.6) or get_close_matches(
                key, self._asked, 1, 0.8
            )
            free = bool(close) and close[0] in others
            if close and close[0] in self._missing:  # misspelt, not missing: one cause
                self.problems.withdraw(self._missing.pop(close[0]))
            known = ", ".join(f"`{name}`" for name in sorted(set(self._asked)))
            self.problems.error(
                UNKNOWN_KEY,
                f"unknown key `{key}` in {self.title}",
                span,
                help=(f"did you mean `{close[0]}`?",) if close else (),
                notes=() if close or not known else (f"known here: {known}",),
                fix=Fix(span, close[0]) if free else None,
                data={"key": key},
            )

    # inside

    def _take(self, key: str, *, required: bool) -> object:
        self._asked.append(key)
        value = self._fields.get(key)
        if value is None and required:
            self.problems.error(
                MISSING_KEY,
                f"{self.title} needs `{key}`",
                self.span,
                data={"key": key},
            )
            self._missing[key] = self.problems.found[-1]
        return value

    def _wrong_type(self, key: str, wanted: str, value: object) -> None:
        self.problems.error(
            WRONG_TYPE,
            f"`{key}` must be {wanted}",
            self.value_span(key),
            f"this is {_kind(value)}",
            data={"key": key},
        )

    def _out_of_range(self, what: str, complaint: str, span: Span, value: float) -> None:
        self.problems.error(
            OUT_OF_RANGE, f"{what} must be {complaint}", span, data={"value": value}
        )

    def _unknown_choice(self, key: str, value: str, known: tuple[str, ...]) -> None:
        span = self.value_span(key)
        close = get_close_matches(value, known, 1, 0.6)
        self.problems.error(
            UNKNOWN_CHOICE,
            f"unknown `{key}`: `{value}`",
            span,
            notes=(f"known: {', '.join(f'`{name}`' for name in known)}",),
            help=(f"did you mean `{close[0]}`?",) if close else (),
            fix=Fix(span, f'"{close[0]}"') if close else None,
            data={"key": key, "value": value},
        )

    def _joined(self, key: str) -> str:
        return f"{self.path}.{key}" if self.path else key

    def _child(self, key: str) -> Place | None:
        return (self._place.fields or {}).get(key)

    def _place_of(self, key: str) -> Place:
        place = self._child(key)
        assert place is not None, "checked against tomllib when the file was read"
        return place

    def _span(self, place: tuple[int, int]) -> Span:
        return Span(self.problems.source, *place)


def _number(value: object) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    if isinstance(value, int) and abs(value) > 10**15:
        return None
    return float(value) if math.isfinite(value) else None


def _outside(value: float, minimum: float, maximum: float, above: float) -> str:
    """Return what a number must be when it is not, else nothing."""
    if minimum <= value <= maximum and value > above:
        return ""
    low = f"more than {above:g}" if above >= minimum else f"at least {minimum:g}"
    high = f"at most {maximum:g}"
    if max(minimum, above) == -math.inf:
        return high
    return low if maximum == math.inf else f"{low} and {high}"


def _kind(value: object) -> str:
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


def _counted(counts: tuple[int, ...]) -> str:
    return " or ".join(str(count) for count in counts)


def _header(path: str) -> str:
    return f"`[{path}]`"
