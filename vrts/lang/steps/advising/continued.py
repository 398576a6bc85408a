"""Steps that go on in the next line, as other languages have it."""

import re

from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.advising.adviser import Advised, Adviser, Line

MOST_LINES = 4  # of one step
_OPEN = re.compile(r"(?P<step>.*?)[ \t]*(?P<sign>\.\.\.|\\|&|(?<=[\s,(+*/-])_)$|.*[,(+*/-]$")


class ContinuedAdvice(Adviser):
    """Explains a line that is a step together with those below it."""

    joined_to = 0  # offset: lines that begin before it belong to a step above

    def explain(self, line: Line, mark: int) -> Advised | None:
        """Tell of a step on several lines once, and join them."""
        found = _OPEN.fullmatch(line.text)
        if found is None:
            return None
        text = self.problems.source.text
        plain, at = found["step"] or line.text, line.at + len(line.text)
        for _ in range(1, MOST_LINES):
            begin = text.find("\n", at) + 1
            if not begin:
                return None
            end = text.find("\n", begin)
            at = end if end >= 0 else len(text)
            row = text[begin:at].partition(";")[0].strip()
            if not found["sign"] and self._is_right(row):
                return None  # a step of its own, and what is above lacks an operand
            going_on = _OPEN.fullmatch(row)
            plain = f"{plain} {going_on['step'] or row if going_on else row}"
            tried = self.repair.at_once(plain)
            if tried is not None:
                self._told(line, mark, found["sign"] or "", tried.text, at)
                return Advised(self._word_of(tried.text))
            if going_on is None:
                return None
        return None

    def _told(self, line: Line, mark: int, sign: str, joined: str, end: int) -> None:
        self.joined_to = end
        self.problems.forget(mark)
        start = line.at + len(line.text) - len(sign)
        headline = "a step stands on one line: it cannot go on in the next"
        self.problems.error(
            UNEXPECTED_TEXT,
            f"`{sign}` joins no lines: a step stands on one line" if sign else headline,
            start if sign else line.at,
            line.at + len(line.text),
            notes=("VAL-II says *Illegal expression syntax*",),
            help=(f"write all of it on one line: `{joined}`",),
            fix=self.problems.replace(line.at, end, joined),
        )
        self.habits.note(self.problems, f"continued lines {sign}")
