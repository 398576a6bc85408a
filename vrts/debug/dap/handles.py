"""Numbers by which a client asks for frames and for what opens; valid while it stands still."""

from collections.abc import Sequence
from typing import Any, NamedTuple

from vrts.debug.frames import Frame
from vrts.debug.values import Scope, Shown

MOST = 10_000  # names below one that are sent


class Opened(NamedTuple):
    """What a number stands for."""

    shown: Sequence[Shown]
    frame: Frame | None  # whose arguments and automatic variables they are


class Handles:
    """Gives numbers to what can be opened."""

    def __init__(self) -> None:
        """Begin at 1."""
        self._known: list[Opened] = []

    def clear(self) -> None:
        """Forget all of them."""
        self._known.clear()

    def of(self, shown: Sequence[Shown], frame: Frame | None = None) -> int:
        """Return a number for what is below something; 0 when nothing is."""
        if not shown:
            return 0
        self._known.append(Opened(shown, frame))
        return len(self._known)

    def scope(self, scope: Scope) -> dict[str, Any]:
        """Return a scope as the protocol has it."""
        return {
            "name": scope.name,
            "variablesReference": self.of(scope.shown, scope.frame),
            "expensive": False,
            "namedVariables": len(scope.shown),
        }

    def variables(self, number: int, start: int = 0, count: int = 0) -> list[dict[str, Any]]:
        """Return what a number opens.

        Raises:
            KeyError: It is not known (any more).
        """
        opened = self._opened(number)
        end = start + min(count or MOST, MOST)
        return [self._variable(item, opened.frame) for item in opened.shown[start:end]]

    def named(self, number: int, name: str) -> Shown:
        """Return what has a name below a number; something without value when nothing has.

        Raises:
            KeyError: The number is not known (any more).
        """
        for item in self._opened(number).shown:
            if item.name == name:
                return item
        return Shown(name, "")

    def frame(self, number: int) -> Frame | None:
        """Return whose arguments and automatic variables a number opens; None for all others.

        Raises:
            KeyError: It is not known (any more).
        """
        return self._opened(number).frame

    def _opened(self, number: int) -> Opened:
        if not 1 <= number <= len(self._known):
            raise KeyError("this is no longer shown")
        return self._known[number - 1]

    def _variable(self, item: Shown, frame: Frame | None) -> dict[str, Any]:
        found: dict[str, Any] = {
            "name": item.name,
            "value": item.value,
            "variablesReference": self.of(item.parts, frame),
        }
        if item.variable and (frame is None or frame.innermost):
            found["evaluateName"] = item.variable
        else:
            found["presentationHint"] = {"attributes": ["readOnly"]}
        return found
