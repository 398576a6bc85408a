"""What a supervised process does: it is told an order and answers with bytes."""

from pathlib import Path
from typing import Protocol, TypeVar

Order = TypeVar("Order", contravariant=True)


class Worker(Protocol[Order]):
    """Made once, in the parent; works once in every process."""

    def warm_up(self) -> None:
        """Load everything that all processes need; where processes are forked they inherit it."""
        ...

    def rest(self) -> None:
        """Give up what `warm_up` keeps for all processes: there are none any more."""
        ...

    def work(self, order: Order, folder: Path) -> bytes:
        """Carry out an order in a process of its own; may write files into a folder of its own."""
        ...

    def command(self, order: Order, folder: Path) -> tuple[list[str], bytes]:
        """Return the same as a command line and its standard input, where nothing is forked.

        The command limits itself with `impose` and writes the answer to its standard output.
        """
        ...
