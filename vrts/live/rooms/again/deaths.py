"""How often a session has died at the same place of its log."""

from dataclasses import dataclass
from typing import Final

MOST: Final = 4  # in a row, after which a room waits for its supervisor
WELL_S: Final = 60.0  # a session that went on for so long has not died of what came before
_FIRST_S: Final = 0.25


@dataclass(slots=True)
class Deaths:
    """A row of deaths; what is recorded in between, or going on for a while, ends the row."""

    row: int = 0
    at: int = 0  # the last command that the log had then

    def died(self, at: int, went_on_s: float) -> bool:
        """Count a death; return whether there were too many.

        Args:
            at: Number of the last command in the log; 0: none.
            went_on_s: For how long it was ready [s]; what it repeats before does not count.
        """
        if at != self.at or went_on_s > WELL_S:
            self.row = 0
        self.at = at
        self.row += 1
        return self.row >= MOST

    def forget(self) -> None:
        """End the row: somebody has chosen how to go on."""
        self.row = 0

    @property
    def pause_s(self) -> float:
        """How long to wait before it is tried again [s]."""
        return _FIRST_S * 2.0**self.row
