"""Numbers by which a client asks for frames and for what opens; valid while it stands still."""

from collections.abc import Sequence
from typing import Any, NamedTuple

from vrts.debug.values import Scope, Shown

MOST = 10_000  # names below one that are sent


class Opened(NamedTuple):
    """What a number stands for."""

    shown: Sequence[Shown]


class Handles:
    """Gives numbers to what can be opened."""

    def __init__(self) -> None:
        """Begin at 1."""
        self._known: list[Opened] = []

    def clear(self) -> None:
        """Forget all of them."""
        self._known.clear()

    def of(self, shown: Sequence[Shown]) -> int:
        """Return a number for what is below something; 0 when nothing is."""
        if not shown:
            return 0
        self._known.append(Opened(shown))
        return len(self._known)

    def scope(self, scope: Scope) -> dict[str, Any]:
        """Return a scope as the protocol has it."""
        self._known.append(Opened(scope.shown))
        return {
            "name": scope.name,
            "variablesReference": len(self._known),
            "expensive": False,
            "namedVariables": len(scope.shown),
        }

    def variables(self, number: int, start: int = 0, count: int = 0) -> list[dict[str, Any]]:
        """Return what a number opens.

        Raises:
            KeyError: It is not known (any more).
        """
        shown = self._shown(number)
        end = start + min(count or MOST, MOST)
        return [self._variable(item) for item in shown[start:end]]

    def named(self, number: int, name: str) -> Shown:
        """Return what has a name below a number.

        Raises:
            KeyError: There is none.
        """
        return next(item for item in (*self._shown(number), _nobody(name)) if item.name == name)

    def _shown(self, number: int) -> Sequence[Shown]:
        if not 1 <= number <= len(self._known):
            raise KeyError("this is no longer shown")
        return self._known[number - 1].shown

    def _variable(self, item: Shown) -> dict[str, Any]:
        found: dict[str, Any] = {
            "name": item.name,
            "value": item.value,
            "variablesReference": self.of(item.parts),
        }
        if item.variable:
            found["evaluateName"] = item.variable
        else:
            found["presentationHint"] = {"attributes": ["readOnly"]}
        return found


def _nobody(name: str) -> Shown:
    return Shown(name, "")
