"""How many texts may be tried out as steps, so that advice on any line takes a bounded time.

Advice tries texts, whose advice tries others. A line that somebody wrote needs at most some
seventy; one of a hundred words alike would need a million.
"""

MOST_OF_LINE = 200
MOST_OF_FILE = 6_000


class Trials:
    """Counts trials, those within trials too."""

    def __init__(self) -> None:
        self._line = MOST_OF_LINE
        self._file = MOST_OF_FILE

    def begin_line(self) -> None:
        """Begin with another line of the file."""
        self._line = MOST_OF_LINE

    def take(self) -> bool:
        """Return whether one more may be tried, which counts."""
        if self._line <= 0 or self._file <= 0:
            return False
        self._line -= 1
        self._file -= 1
        return True
