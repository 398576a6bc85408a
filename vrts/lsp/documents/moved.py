"""Where places of a text are in a later one: lines above and below what changed are the same."""

from vrts.base.source import SourceFile


class Moved:
    """The way from one text to a later one."""

    def __init__(self, before: SourceFile, after: SourceFile) -> None:
        """Compare two texts line by line, from both ends."""
        self._before, self._after = before, after
        old, new = before.text.split("\n"), after.text.split("\n")
        most = min(len(old), len(new))
        head = 0
        while head < most and old[head] == new[head]:
            head += 1
        tail = 0
        while tail < most - head and old[-1 - tail] == new[-1 - tail]:
            tail += 1
        self._old_lines, self._new_lines = len(old), len(new)
        self._head, self._tail = head, tail

    @property
    def changed(self) -> range:
        """Lines of the later text, from 0, that are new; with lines taken out, those beside."""
        end = self._new_lines - self._tail
        return range(self._head, end) if end > self._head else range(max(end - 1, 0), end + 1)

    def offset(self, offset: int) -> int | None:
        """Return where an offset of the earlier text is now; None in lines that have changed."""
        line = self._before.line_of(offset) - 1
        if self._head <= line < self._old_lines - self._tail:
            return None
        column = offset - self._before.line_starts[line]
        now = line if line < self._head else line + self._new_lines - self._old_lines
        return self._after.line_starts[now] + column
