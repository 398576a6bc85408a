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


KINDS: tuple[tuple[type, str], ...] = (
    (bool, "bool"),
    (int, "number"),
    (float, "number"),
    (str, "string"),
    (tuple, "pose"),
    (list, "list"),
)


def kind_of(value: object) -> str:
    """Return the fundamental type, as section 3 of the manual lists them."""
    return next((name for kind, name in KINDS if isinstance(value, kind)), "none")


def copied(value: Any) -> Any:
    """Return a value as arguments are passed: arrays too by value (section 6)."""
    return [*value] if kind_of(value) == "list" else value
