"""Where `go` leads: a numbered row of what was shown last, or a mark."""

from collections.abc import Sequence

from vrts.debug.evaluating import CannotTell
from vrts.debug.marks.marks import Marks, stop_at
from vrts.debug.stops.stop import Stop
from vrts.engine.run import Run


class Goals:
    """The rows that were shown last, and the marks."""

    def __init__(self, run: Run) -> None:
        """Begin without any."""
        self.marks = Marks()
        self._rows: Sequence[Stop] = ()
        self._of = run

    def show(self, run: Run, rows: Sequence[Stop]) -> None:
        """Let numbers lead to places of a run, from 1 on."""
        self._of, self._rows = run, rows

    def stop(self, run: Run, text: str) -> Stop:
        """Return where a number or the name of a mark leads.

        Raises:
            CannotTell: Nowhere, or to a place of another future.
        """
        word = text.strip() or "1"
        if not word.isdecimal():
            return stop_at(run, self.marks.named(word))
        if len(word) > 6 or not 1 <= int(word) <= len(self._rows):
            many = len(self._rows)
            listed = f"1 to {many}" if many > 1 else "only 1" if many else "nothing yet"
            raise CannotTell(
                "`go` takes the number of a row that was shown last, or a mark: " + listed
            )
        if self._of is not run:
            raise CannotTell("that row is of another future: ask again")
        return self._rows[int(word) - 1]
