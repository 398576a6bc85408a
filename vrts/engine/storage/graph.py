"""Objects of the engine as lists, numbers, texts and bytes, and back: what is shared stays shared.

Made for states of a machine, which have no plain form of their own: cells are shared by frames and
memory, records point at records. What is read makes objects of this package only, and calls nothing
of theirs: values are put in their places.
"""

import sys
from array import array
from collections.abc import Mapping
from enum import Enum
from types import MappingProxyType
from typing import Any, Final, Literal, TypeAlias, cast

from vrts.base.stack import deep_stack
from vrts.engine.storage.damage import Damaged, require

Form: TypeAlias = Any

PACKAGES: Final = tuple(
    f"vrts.{name}." for name in ("base", "controllers", "ir", "robots", "scene", "engine")
)
_AGAIN, _GIVEN, _LIST, _TUPLE, _DICT, _VIEW, _SET, _FROZEN = range(8)
_ARRAY, _ENUM, _RECORD, _OBJECT, _FRESH, _CALLED = range(8, 14)
_PLAIN = (int, float, str, bytes, bool, type(None))


class GraphWriter:
    """Writes objects; each once, however often it is met."""

    def __init__(self, given: Mapping[str, object], fresh: tuple[type, ...] = ()) -> None:
        """Take what the reader has already, by name, and kinds of which it makes new ones."""
        self._given = {id(value): name for name, value in given.items()}
        self._fresh = fresh
        self._numbers: dict[int, int] = {}
        self._held: list[object] = []  # so that no id is used twice
        self._classes: dict[type, int] = {}

    @deep_stack()
    def write(self, value: object) -> Form:
        """Return the form of an object, with the names of the classes in it.

        Raises:
            TypeError: It holds something that is none of the engine's.
        """
        form = self._write(value)
        names = [f"{kind.__module__}:{kind.__qualname__}" for kind in self._classes]
        return [names, form]

    def _write(self, value: Any) -> Form:
        kind = value.__class__
        if kind in _PLAIN:
            return value
        if isinstance(value, Enum):
            return [_ENUM, self._class(kind), value.name]
        known = self._numbers.get(id(value))
        if known is not None:
            return [_AGAIN, known]
        given = self._given.get(id(value))
        if given is not None:
            return [_GIVEN, given]
        self._numbers[id(value)] = len(self._numbers)
        self._held.append(value)
        if kind is tuple:
            return [_TUPLE, *map(self._write, value)]
        if kind is list:
            return [_LIST, *map(self._write, value)]
        if kind is array:
            return [_ARRAY, value.typecode, value.tobytes()]
        if kind is dict or kind is MappingProxyType:
            items = [self._write(part) for item in value.items() for part in item]
            return [_DICT if kind is dict else _VIEW, *items]
        if kind is set or kind is frozenset:
            return [_SET if kind is set else _FROZEN, *map(self._write, sorted(value, key=repr))]
        if kind in self._fresh:
            return [_FRESH, self._class(kind)]
        if isinstance(value, tuple):
            parts = cast(tuple[object, ...], value)
            return [_RECORD, self._class(kind), *map(self._write, parts)]
        if callable(value) and not kind.__module__.startswith(PACKAGES):
            return [_CALLED]  # who takes it over puts its own in this place
        return [_OBJECT, self._class(kind), *map(self._write, _values(value, kind))]

    def _class(self, kind: type) -> int:
        if not f"{kind.__module__}.".startswith(PACKAGES):
            raise TypeError(f"{kind} is none of the engine's")
        return self._classes.setdefault(kind, len(self._classes))


class GraphReader:
    """Reads what a writer has written."""

    def __init__(self, given: Mapping[str, object]) -> None:
        """Take what was given to the writer, by name."""
        self._given = given
        self._known: list[Any] = []
        self._classes: list[Any] = []

    @deep_stack()
    def read(self, form: Form) -> Any:
        """Return the object.

        Raises:
            Damaged: The form is none.
        """
        try:
            names, what = form
            self._classes = [_class_named(name) for name in names]
            return self._read(what)
        except (TypeError, ValueError, LookupError, AttributeError) as problem:
            raise Damaged(f"a state cannot be read: {problem}") from problem

    def _read(self, form: Form) -> Any:
        if form.__class__ is not list:
            return form
        tag = form[0]
        if tag == _ENUM:
            kind = self._classes[form[1]]
            require(issubclass(kind, Enum), "a state has no such choice")
            return cast(type[Enum], kind)[form[2]]
        if tag == _AGAIN:
            return self._known[form[1]]
        if tag == _GIVEN:
            return self._given[form[1]]
        place = len(self._known)
        self._known.append(None)
        if tag in (_LIST, _DICT, _SET, _OBJECT):  # what may hold itself
            return self._filled(form, place)
        found = self._known[place] = self._made(form)
        return found

    def _filled(self, form: Form, place: int) -> Any:
        """Return what may hold itself, so it has its number before its parts."""
        tag = form[0]
        if tag == _LIST:
            items: list[Any] = []
            self._known[place] = items
            items.extend(map(self._read, form[1:]))
            return items
        if tag == _DICT:
            named: dict[Any, Any] = {}
            self._known[place] = named
            named.update(self._pairs(form))
            return named
        if tag == _SET:
            members: set[Any] = set()
            self._known[place] = members
            members.update(map(self._read, form[1:]))
            return members
        kind = self._classes[form[1]]
        made = self._known[place] = kind.__new__(kind)
        slots, present, others = [self._read(part) for part in form[2:]]
        names = [name for k, name in enumerate(_slots(kind)) if present >> k & 1]
        for name, value in (*zip(names, slots, strict=True), *others.items()):
            object.__setattr__(made, name, value)
        return made

    def _made(self, form: Form) -> Any:
        tag = form[0]
        if tag == _TUPLE:
            return tuple([self._read(part) for part in form[1:]])
        if tag == _RECORD:
            kind = self._classes[form[1]]
            return cast(Any, tuple).__new__(kind, [self._read(part) for part in form[2:]])
        if tag == _ARRAY:
            found: array[int] = array(cast(Literal["I"], form[1]))
            found.frombytes(form[2])
            return found
        if tag == _FROZEN:
            return frozenset([self._read(part) for part in form[1:]])
        if tag == _VIEW:
            return MappingProxyType(self._pairs(form))
        if tag == _FRESH:
            return self._classes[form[1]]()
        require(tag == _CALLED, "a state has a part of no kind")
        return _nothing

    def _pairs(self, form: Form) -> dict[Any, Any]:
        parts = [self._read(part) for part in form[1:]]
        return dict(zip(parts[::2], parts[1::2], strict=True))


def _slots(kind: type) -> list[str]:
    return [name for base in kind.__mro__ for name in base.__dict__.get("__slots__", ())]


def _values(value: object, kind: type) -> tuple[list[object], int, dict[str, object]]:
    """Return the slots of an object that have values, which those are, and what else it has."""
    names = _slots(kind)
    present = [name for name in names if hasattr(value, name)]
    others = dict(getattr(value, "__dict__", {}))
    if isinstance(value, BaseException):
        others["args"] = value.args
    return (
        [getattr(value, name) for name in present],
        sum(1 << k for k, name in enumerate(names) if name in present),
        others,
    )


def _class_named(name: str) -> Any:
    module, _, title = name.partition(":")
    require(f"{module}.".startswith(PACKAGES), "a state has a class of another package")
    found = getattr(sys.modules[module], title)
    require(isinstance(found, type), "a state has a class that is none")
    return found


def _nothing(*_: object) -> int:
    return 0
