"""What the search asks of whoever certifies motion."""

from collections.abc import Sequence
from typing import Protocol

from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Event


class Touch(Protocol):
    """Two bodies that touch in a future."""

    @property
    def future(self) -> int:
        """Number of the future."""
        ...

    @property
    def time_s(self) -> float:
        """When it is seen [s]."""
        ...

    @property
    def first(self) -> str:
        """One of the two."""
        ...

    @property
    def second(self) -> str:
        """The other one."""
        ...

    @property
    def depth_m(self) -> float:
        """How deep they are in each other [m]."""
        ...


class Certifies(Protocol):
    """Certifies that nothing touches, once for what futures share."""

    def look(self, machine: Machine, until_s: float, future: int) -> None:
        """Note what a future moves from now to a time."""
        ...

    def happened(self, machine: Machine, events: Sequence[Event]) -> None:
        """Note what has happened in a tick."""
        ...

    def state(self, machine: Machine) -> object:
        """Return what rules about contacts remember."""
        ...

    def certify(self) -> Sequence[Touch]:
        """Return what touches in what is new since this was asked last."""
        ...


class Nobody:
    """Looks at no contact."""

    def look(self, machine: Machine, until_s: float, future: int) -> None:
        """Note nothing."""

    def happened(self, machine: Machine, events: Sequence[Event]) -> None:
        """Note nothing."""

    def state(self, machine: Machine) -> object:
        """Return that nothing is remembered."""
        return None

    def certify(self) -> Sequence[Touch]:
        """Return that nothing touches."""
        return ()
