"""Arguments of a request, taken for nothing but what they turn out to be."""

from collections.abc import Mapping
from typing import Any, cast

MOST_TEXT = 100_000  # characters
MOST_ITEMS = 10_000
MOST_NUMBER = 1e9


class BadRequest(ValueError):  # noqa: N818 -- names the situation
    """A request cannot be carried out; the text is for the user."""


class Fields:
    """Named values that somebody else has sent."""

    def __init__(self, values: object) -> None:
        """Take a JSON object; anything else has no fields."""
        self._values: Mapping[str, Any] = (
            cast("Mapping[str, Any]", values) if isinstance(values, Mapping) else {}
        )

    def text(self, name: str) -> str:
        """Return a text that has to be there."""
        found = self.optional(name)
        if found is None:
            raise BadRequest(f"`{name}` is missing")
        return found

    def optional(self, name: str) -> str | None:
        """Return a text; None where it is left out or empty."""
        found = self._values.get(name)
        if found is None or found == "":
            return None
        if not isinstance(found, str) or len(found) > MOST_TEXT or not _is_text(found):
            raise BadRequest(f"`{name}` is no text")
        return found

    def whole(self, name: str, otherwise: int | None = None) -> int:
        """Return a whole number."""
        found = self._values.get(name, otherwise)
        if isinstance(found, bool) or not isinstance(found, int) or abs(found) > 2**31:
            raise BadRequest(f"`{name}` is no whole number")
        return found

    def whole_or_none(self, name: str) -> int | None:
        """Return a whole number; None for anything else."""
        found = self._values.get(name)
        return found if isinstance(found, int) and not isinstance(found, bool) else None

    def number(self, name: str, otherwise: float) -> float:
        """Return a number."""
        found = self._values.get(name, otherwise)
        if isinstance(found, bool) or not isinstance(found, int | float):
            raise BadRequest(f"`{name}` is no number")
        if not abs(found) < MOST_NUMBER:  # no number as well: NaN
            raise BadRequest(f"`{name}` is no number")
        return float(found)

    def truth(self, name: str, *, otherwise: bool) -> bool:
        """Return true or false."""
        found = self._values.get(name, otherwise)
        if not isinstance(found, bool):
            raise BadRequest(f"`{name}` is true or false")
        return found

    def texts(self, name: str) -> list[str]:
        """Return a list of texts; none where it is left out."""
        found = self._list(name)
        if not all(isinstance(item, str) for item in found):
            raise BadRequest(f"`{name}` is a list of texts")
        return cast("list[str]", found)

    def part(self, name: str) -> "Fields":
        """Return what is inside a field."""
        return Fields(self._values.get(name))

    def parts(self, name: str) -> "list[Fields]":
        """Return a list of such; none where it is left out."""
        return [Fields(item) for item in self._list(name)]

    def _list(self, name: str) -> list[object]:
        found = self._values.get(name)
        if found is None:
            return []
        if not isinstance(found, list) or len(cast("list[object]", found)) > MOST_ITEMS:
            raise BadRequest(f"`{name}` is a list")
        return cast("list[object]", found)


def _is_text(text: str) -> bool:
    """Return whether a text can be written and name files: no zeros, no halves of characters."""
    return "\0" not in text and not any("\ud800" <= letter <= "\udfff" for letter in text)
