"""Steps tried out: whether a text is a step, with the fixes that it needs."""

from collections.abc import Callable
from typing import NamedTuple, TypeAlias

from vrts.base.mending import edits_of, mendable, with_edits
from vrts.base.source import SourceFile
from vrts.lang.dialect import Dialect
from vrts.lang.problems import Problems
from vrts.lang.syntax.statements import Bad, Statement

Parse: TypeAlias = Callable[[Problems, str], Statement | None]  # one step, tried out

MOST_FIXES = 6  # of one step, one after the other
MOST_LINES = 5


class Tried(NamedTuple):
    """A text that is steps."""

    text: str
    fixes: int  # passes until it was


class Repair:
    """Tries out what could be meant by a step."""

    def __init__(self, dialect: Dialect, parse: Parse, plain: Parse) -> None:
        """Know how a text is read: with advice where it is none, or `plain`, which is quick."""
        self._dialect = dialect
        self._parse = parse
        self._plain = plain

    def at_once(self, text: str) -> Tried | None:
        """Return a text of one or more lines as steps; None where it is none, or needs a fix."""
        rows = text.split("\n")
        if len(rows) > MOST_LINES or not all(self._stands(row.strip()) for row in rows):
            return None
        return Tried("\n".join(row.rstrip() for row in rows), 0)

    def _stands(self, text: str) -> bool:
        if not text:
            return False
        problems = Problems(SourceFile("", text), self._dialect)
        node = self._plain(problems, text)
        return node is not None and not _is_wrong(node, problems)

    def steps(self, text: str) -> Tried | None:
        """Return a text of one or more lines as steps; None where it is none."""
        rows = text.split("\n")
        if len(rows) > MOST_LINES:
            return None
        tried = [self._step(row) for row in rows]
        good = [row for row in tried if row is not None]
        if len(good) < len(tried):
            return None
        return Tried("\n".join(row.text for row in good), max(row.fixes for row in good))

    def _step(self, row: str) -> Tried | None:
        indent = row[: len(row) - len(row.lstrip())]
        text = row.strip()
        for passed in range(MOST_FIXES):
            if not text:
                return None
            source = SourceFile("", text)
            problems = Problems(source, self._dialect)
            node = self._parse(problems, text)
            if not _is_wrong(node, problems):
                return Tried(indent + text, passed) if node is not None else None
            after = with_edits(text, edits_of(mendable(source, problems.found)))
            if after == text or "\n" in after:
                return None
            text = after.strip()
        return None


def _is_wrong(node: Statement | None, problems: Problems) -> bool:
    return problems.any_error or bool(problems.look_alikes) or isinstance(node, Bad)
