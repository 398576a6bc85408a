"""Arrays, kinds and copies of values in URScript: sections 3 to 8 of the script manual, SW 5.11.

Written later than the interpreter, from that manual, by somebody who knew what the export writes.
"""

from typing import Any


class NotTaken(Exception):  # noqa: N818 -- names the situation
    """What the manual does not allow."""


def element(held: Any, number: Any) -> Any:
    """Return an element of an array, from 0 (section 4)."""
    if not isinstance(number, int) or isinstance(number, bool):
        raise NotTaken("an element has a whole number")
    if kind_of(held) not in ("list", "pose") or not 0 <= number < len(list(held)):
        raise NotTaken(f"there is no element {number}")
    return held[number]


def member(held: Any, name: str) -> Any:
    """Return a member of a struct, as the page on time() of the manual has them."""
    if not isinstance(held, Struct) or name not in held:
        raise NotTaken(f"there is no member {name}")
    return held[name]


class Struct(dict[str, Any]):
    """Values by name."""


KINDS: tuple[tuple[type, str], ...] = (
    (bool, "bool"),
    (int, "number"),
    (float, "number"),
    (str, "string"),
    (tuple, "pose"),
    (list, "list"),
    (Struct, "struct"),
)


def kind_of(value: object) -> str:
    """Return the fundamental type, as section 3 of the manual lists them."""
    named = (name for kind, name in KINDS if isinstance(value, kind))
    return next(named, type(value).__name__.lower())


def copied(value: Any) -> Any:
    """Return a value as arguments are passed: arrays too by value (section 6)."""
    return [*value] if kind_of(value) == "list" else value
