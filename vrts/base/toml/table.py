"""Tables whose getters report what is wrong where it stands.

A getter that finds something wrong records one located diagnostic in the shared `Problems` and
returns the default, so that a reader goes on and reports everything in one pass.
"""

from collections.abc import Iterable
from datetime import datetime
from difflib import get_close_matches
from fractions import Fraction
from typing import TypedDict, TypeVar, Unpack, overload

from vrts.base.diagnostic import Diagnostic, Fix, Rule
from vrts.base.source import Span
from vrts.base.toml import kinds
from vrts.base.toml.kinds import Fields, Kind, Wrong
from vrts.base.toml.places import Place
from vrts.base.toml.problems import Problems

UNKNOWN_KEY = Rule("V602", "unknown-key")
MISSING_KEY = Rule("V603", "missing-key")

T = TypeVar("T")
D = TypeVar("D")


class Bounds(TypedDict, total=False):
    """What a number must be: at least, at most, and more than."""

    minimum: float
    maximum: float
    above: float


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
        return self._get(key, kinds.text(choices), default, required=required)

    @overload
    def number(self, key: str, default: float, **bounds: Unpack[Bounds]) -> float: ...
    @overload
    def number(
        self,
        key: str,
        default: None = None,
        *,
        required: bool = False,
        **bounds: Unpack[Bounds],
    ) -> float | None: ...
    def number(
        self,
        key: str,
        default: float | None = None,
        *,
        required: bool = False,
        **bounds: Unpack[Bounds],
    ) -> float | None:
        """Return a finite number within bounds."""
        return self._get(key, kinds.number(**bounds), default, required=required)

    @overload
    def fraction(self, key: str, default: Fraction, **bounds: Unpack[Bounds]) -> Fraction: ...
    @overload
    def fraction(
        self,
        key: str,
        default: None = None,
        *,
        required: bool = False,
        **bounds: Unpack[Bounds],
    ) -> Fraction | None: ...
    def fraction(
        self,
        key: str,
        default: Fraction | None = None,
        *,
        required: bool = False,
        **bounds: Unpack[Bounds],
    ) -> Fraction | None:
        """Return a number exactly as written: 0.1 is one tenth."""
        number = self._get(key, kinds.number(**bounds), None, required=required)
        return default if number is None else Fraction(repr(number))

    @overload
    def integer(self, key: str, default: int, **bounds: Unpack[Bounds]) -> int: ...
    @overload
    def integer(
        self,
        key: str,
        default: None = None,
        *,
        required: bool = False,
        **bounds: Unpack[Bounds],
    ) -> int | None: ...
    def integer(
        self,
        key: str,
        default: int | None = None,
        *,
        required: bool = False,
        **bounds: Unpack[Bounds],
    ) -> int | None:
        """Return a whole number within bounds."""
        return self._get(key, kinds.integer(**bounds), default, required=required)

    @overload
    def boolean(self, key: str, default: bool) -> bool: ...
    @overload
    def boolean(self, key: str, default: None = None, *, required: bool = False) -> bool | None: ...
    def boolean(
        self, key: str, default: bool | None = None, *, required: bool = False
    ) -> bool | None:
        """Return true or false."""
        return self._get(key, kinds.boolean, default, required=required)

    def time(self, key: str, *, required: bool = False) -> datetime | None:
        """Return a date with a time and its offset from UTC: an instant everywhere."""
        return self._get(key, kinds.time, None, required=required)

    # lists

    def numbers(
        self,
        key: str,
        default: tuple[float, ...] | None = None,
        *,
        count: int | tuple[int, ...] | None = None,
        required: bool = False,
        **bounds: Unpack[Bounds],
    ) -> tuple[float, ...] | None:
        """Return a list of finite numbers, of the given length (or one of the lengths)."""
        counts = (count,) if isinstance(count, int) else count
        return self._get(key, kinds.numbers(counts, **bounds), default, required=required)

    def strings(
        self, key: str, default: tuple[str, ...] | None = None, *, required: bool = False
    ) -> tuple[str, ...] | None:
        """Return a list of texts."""
        return self._get(key, kinds.texts, default, required=required)

    def array(self, key: str, *, required: bool = False) -> list[object]:
        """Return a list of at least one value of any kind; [] where it is missing or wrong."""
        return self._get(key, kinds.array, list[object](), required=required)

    def names(
        self, key: str, *, choices: Iterable[str] | None, required: bool = False
    ) -> tuple[str, ...]:
        """Return one of `choices`, or a list of some of them; () where it is missing or wrong.

        Without choices it may be any text.
        """
        return self._get(key, kinds.names(choices), (), required=required)

    # tables

    def table(self, key: str, *, required: bool = False) -> "Table | None":
        """Return the table `[key]`."""
        path = self._joined(key)
        fields = self._get(key, kinds.fields(path), None, required=required)
        return None if fields is None else Table(self.problems, path, fields, self._place_of(key))

    def holds_table(self, key: str) -> bool:
        """Return whether a key holds a table, where it may hold another kind of value too."""
        return isinstance(self._fields.get(key), dict)

    def tables(self, key: str, *, required: bool = False) -> "tuple[Table, ...]":
        """Return the tables `[[key]]`, in order."""
        path = self._joined(key)
        items = self._get(key, kinds.list_of_fields(path), None, required=required)
        if items is None:
            return ()
        elements = self._place_of(key).items or []
        return tuple(
            Table(self.problems, f"{path} {number}", item, place)
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

    def _get(self, key: str, kind: Kind[T], default: D, *, required: bool) -> T | D:
        """Return the value of a key, or the default where it is missing or wrong: that is said."""
        value = self._take(key, required=required)
        if value is None:
            return default
        found = kind(key, value)
        if isinstance(found, Wrong):
            self._report(key, found)
            return default
        return found

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

    def _report(self, key: str, wrong: Wrong) -> None:
        at = wrong.element
        span = self.value_span(key) if at is None else self.element_span(key, at)
        self.problems.error(
            wrong.rule,
            wrong.headline,
            span,
            wrong.text,
            notes=wrong.notes,
            help=wrong.help,
            fix=Fix(span, wrong.instead) if wrong.instead else None,
            data=wrong.data,
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
