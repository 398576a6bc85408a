"""Comments of the files that students get, held against the numbers of the task.

Comments of `task.toml` and of `start.v2` go into the zip for students as they are. What is no
comment is blanked, so that places stay what they are.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from vrts.assignments.handed.facts import Fact
from vrts.assignments.handed.first_ones import first_ones
from vrts.assignments.handed.prose import contradictions
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile, Span
from vrts.pipeline.files import TASK_FILE, member_bytes, shown

START = "start.v2"
LARGEST = 1_000_000  # bytes of a file that is looked at

_IN_TOML = re.compile(
    r'"""(?:\\.|[^\\])*?"""|\'\'\'.*?\'\'\'|"(?:\\.|[^"\\\n])*"|\'[^\'\n]*\'|(?P<comment>#[^\n]*)',
    re.DOTALL,
)
_IN_PROGRAM = re.compile(r'"[^"\n]*"|(?P<comment>;[^\n]*)')
_SEEN = re.compile(r"[^\n]")


def comment_findings(folder: Path, facts: Sequence[Fact]) -> tuple[Diagnostic, ...]:
    """Return where a comment that students read says otherwise than the task.

    Args:
        folder: Of the task.
        facts: The numbers of the task.
    """
    found: list[Diagnostic] = []
    for name, pattern in ((TASK_FILE, _IN_TOML), (START, _IN_PROGRAM)):
        found += _in_file(folder / name, pattern, facts)
    return tuple(found)


def _in_file(place: Path, pattern: re.Pattern[str], facts: Sequence[Fact]) -> Iterator[Diagnostic]:
    if not place.is_file():
        return
    text = member_bytes(place)[:LARGEST].decode("utf-8", "replace").replace("\r\n", "\n")
    whole = SourceFile(shown(place), text)
    said = f"a comment in `{whole.name}`"
    comments = SourceFile(whole.name, comments_of(text, pattern))
    for one in first_ones(contradictions(comments, facts, called=said), "number"):
        if one.primary is None:
            yield one
            continue
        span = one.primary.span
        yield replace(one, primary=one.primary._replace(span=Span(whole, span.start, span.end)))


def comments_of(text: str, pattern: re.Pattern[str]) -> str:
    """Return a text of which only comments are left, each at its place.

    Args:
        text: The whole file.
        pattern: Finds strings, and comments as its group `comment`.
    """
    parts: list[str] = []
    before = 0
    for found in pattern.finditer(text):
        if found["comment"] is None:
            continue
        parts += [_SEEN.sub(" ", text[before : found.start()]), found[0]]
        before = found.end()
    return "".join([*parts, _SEEN.sub(" ", text[before:])])
