"""What all advice about a line has in common: the line, and what its words are."""

from typing import NamedTuple

from vrts.base.diagnostic import Fix, Rule
from vrts.lang.grammar.shapes import LABEL_EXPECTED, TOO_MANY_OPERANDS, UNEXPECTED_TEXT
from vrts.lang.problems import Problems
from vrts.lang.reading.odd_signs import STRAY_CHARACTER
from vrts.lang.steps.habits import Habits
from vrts.lang.steps.idioms.wording import (
    first_word,
)
from vrts.lang.steps.missing_parts import MISSING_KEYWORD
from vrts.lang.steps.one_line import Rows, rows_of
from vrts.lang.steps.repair import Repair
from vrts.lang.steps.unknown_words import (
    MONITOR_COMMAND,
)
from vrts.lang.vocabulary.lookup import look_up, spellings

OTHER_LANGUAGE = Rule("V164", "other-language")
STRUCTURE = frozenset({"IF", "WHILE", "FOR", "CASE", "DO", "END", "UNTIL", "ELSE", "VALUE", "ANY"})

PRECISE = frozenset(
    {
        UNEXPECTED_TEXT,
        TOO_MANY_OPERANDS,
        LABEL_EXPECTED,
        MONITOR_COMMAND,
        STRAY_CHARACTER,
        MISSING_KEYWORD,
    }
)  # codes that say what it is, whatever language it comes from


class Advised(NamedTuple):
    """A line that was explained: the structure word it stands for, and the steps that are meant."""

    word: str | None
    meant: str | None = None


class Line(NamedTuple):
    """The statement of a line in its file."""

    text: str
    at: int
    raw: str  # with what would be its comment
    kept: str | None  # the structure word that the parser knows


class Adviser:
    """Explains lines of one kind that are no steps, each by one diagnostic."""

    def __init__(self, problems: Problems, repair: Repair, habits: Habits) -> None:
        self.problems = problems
        self.repair = repair
        self.habits = habits

    def _apart(self, text: str) -> Rows | None:
        """Return the steps that stand on one line."""
        return rows_of(text, spellings(self.problems.dialect), self._is_right)

    def _is_right(self, text: str) -> bool:
        return self.repair.at_once(text) is not None

    def _without(self, line: Line) -> Fix:
        """Return a fix that takes a step out: its whole line, where nothing else stands there."""
        text = self.problems.source.text
        begin = text.rfind("\n", 0, line.at) + 1
        end = line.at + len(line.text)
        finish = text.find("\n", end)
        finish = len(text) if finish < 0 else finish + 1
        if text[begin : line.at].strip() or text[end:finish].strip(" \t;\n"):
            return self.problems.replace(line.at, end, "")
        return self.problems.replace(begin, finish, "")

    def _word_of(self, text: str) -> str | None:
        """Return the structure word that steps begin with."""
        first = text.split("\n")[0].strip()
        word = look_up(first_word(first), self.problems.dialect).word if first else None
        if word is None or word.text not in STRUCTURE:
            return word.text if word is not None else None
        if "\n" in text and text.rstrip().upper().endswith("END"):
            return None  # it closes what it opens
        if word.text == "IF" and " GOTO " in first.upper():
            return None
        return word.text

    def _indent(self, line: Line) -> str:
        text = self.problems.source.text
        begin = text.rfind("\n", 0, line.at) + 1
        before = text[begin : line.at]
        return before if not before.strip() else " " * len(before.expandtabs(8))
