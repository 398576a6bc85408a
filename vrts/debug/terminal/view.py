"""What the user of the terminal looks at: a line chosen, what was said, a page, a question."""

from bisect import bisect_left
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from vrts.debug.terminal.fitting import cut, wrapped
from vrts.debug.terminal.line import Line

TERMINAL_ROWS = 4  # of what is said, or of the program's terminal


@dataclass(slots=True)
class Page:
    """Text over the whole screen, as far as it fits; the rest is scrolled to."""

    title: str
    lines: list[str]
    top: int = 0  # row that stands first, once wrapped
    goes: Sequence[int | None] = ()  # beside the lines: the number of what it leads to
    chosen: int = 0  # line, from 0
    table: bool = False  # each line is one row, cut where it is longer

    @property
    def choices(self) -> list[int]:
        """Return the lines that lead somewhere."""
        return [k for k, go in enumerate(self.goes) if go is not None]

    def drawn(self, width: int) -> list[tuple[int, str]]:
        """Return the rows of a screen of some width, each with its line."""
        pieces = (
            [cut(line, width - 1)] if self.table else wrapped([line], width) for line in self.lines
        )
        return [(k, row) for k, rows in enumerate(pieces) for row in rows]


@dataclass(slots=True)
class Question:
    """A line that is being typed."""

    words: str  # before it
    line: Line
    answer: Callable[[str], None]
    hints: list[str] = field(default_factory=list[str])  # above it


@dataclass(slots=True)
class View:
    """What is looked at."""

    cursor: int | None = None  # line chosen; None: the one that is executed
    said: list[str] = field(default_factory=list[str])
    page: Page | None = None
    question: Question | None = None
    width: int = 80  # of the screen as it was drawn last
    height: int = 24

    @property
    def most_said(self) -> int:
        """Return how many rows what is said may take beside the text."""
        return max(TERMINAL_ROWS, self.height // 3)

    def say(self, title: str, lines: list[str]) -> None:
        """Show lines: below the text, or as a page where they are too many for that."""
        self.said = lines
        if len(wrapped(lines, self.width)) > self.most_said:
            self.page = Page(title, lines)

    def scroll(self, rows: int) -> None:
        """Show later rows of the page, or earlier ones; in a list choose them."""
        choices = self.page.choices if self.page is not None else []
        if self.page is not None and choices:
            k = bisect_left(choices, self.page.chosen)
            self.page.chosen = choices[max(0, min(k + rows, len(choices) - 1))]
        elif self.page is not None:
            all_rows = len(self.page.drawn(self.width))
            self.page.top = max(0, min(self.page.top + rows, all_rows - self.page_rows))

    @property
    def page_rows(self) -> int:
        """Return how many rows of a page are seen at once."""
        return max(self.height - 2, 1)
