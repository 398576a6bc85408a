"""The part of a README.md that is written from the task: where it is, and where it differs."""

import re
from collections.abc import Iterator
from difflib import SequenceMatcher
from pathlib import PurePath
from typing import NamedTuple, TypeAlias

from vrts.assignments.handed.markdown import Area, Blocks, blocks, within
from vrts.base.diagnostic import Diagnostic, Label, Rule, error, warning
from vrts.base.source import SourceFile, Span
from vrts.report.plain import one_line

NAME = "README.md"
DIFFERS = Rule("V684", "readme-differs")
MARKERS = Rule("V685", "readme-markers")

BEGIN = "<!-- vrts: what counts, written from task.toml; change the task, not these lines -->"
END = "<!-- vrts: end of what counts -->"
LONGEST = 100  # characters of a line in a diagnostic

_BEGIN = re.compile(r"^[ \t]*<!-- vrts: what counts\b[^\n]*-->[ \t]*\r?$", re.MULTILINE)
_END = re.compile(r"^[ \t]*<!-- vrts: end of what counts -->[ \t]*\r?$", re.MULTILINE)


_Marks: TypeAlias = tuple[list[re.Match[str]], list[re.Match[str]]]  # beginnings, ends


class Part(NamedTuple):
    """Where the written part is, without its markers."""

    start: int
    end: int


def written(text: str, words: str) -> str:
    """Return a README with its part written again; where it has none, at the end.

    Args:
        text: With sound markers, see `marker_findings`; line ends as they are.
        words: What the part says.
    """
    part = part_of(text)
    if part is None:
        line = _line_end(text)
        gap = "" if not text else line if text.endswith("\n") else line * 2
        return f"{text}{gap}" + f"{BEGIN}\n\n{words}\n{END}\n".replace("\n", line)
    line = _line_end(text[: part.start])
    inside = f"\n{words}\n".replace("\n", line)
    return f"{text[: part.start]}{inside}{text[part.end :]}"


def part_of(text: str) -> Part | None:
    """Return where the written part is; None where there is none, or its markers are not sound."""
    return _part(text, _marks(text, blocks(text)))


def marker_findings(source: SourceFile) -> tuple[Diagnostic, ...]:
    """Return what is wrong with the markers; none at all is all right.

    Those in a block of code are shown, and do not count.
    """
    text = source.text
    read = blocks(text)
    begins, ends = marks = _marks(text, read)
    if _part(text, marks) is not None:
        return ()
    if not begins and not ends:
        return () if read.open is None else (_open_block(source, read.open),)
    last = (begins + ends)[-1] if len(begins) != len(ends) else ends[0]
    headline = (
        f"`{NAME}` has {len(begins)} beginnings and {len(ends)} ends of the part that is written "
        "from the task: it needs one of each, in this order, at the very beginning of their lines"
    )
    label = Label(Span(source, last.start(), last.end()))
    remedy = "delete the lines that begin with `<!-- vrts:`; then the part is written at the end"
    return (error(MARKERS, headline, label, help=(remedy,)),)


def _open_block(source: SourceFile, first: Area) -> Diagnostic:
    headline = f"`{NAME}` ends inside a block of code: nothing else can be written at its end"
    label = Label(Span(source, first.start, first.end), "the block begins here")
    return error(MARKERS, headline, label, help=("write the line that ends the block",))


def _marks(text: str, read: Blocks) -> _Marks:
    """Return the lines that begin and end the part, without those that are shown as code."""
    found = [
        [mark for mark in marker.finditer(text) if not within(read.code, mark.start())]
        for marker in (_BEGIN, _END)
    ]
    return found[0], found[1]


def _part(text: str, marks: _Marks) -> Part | None:
    begins, ends = marks
    if len(begins) != 1 or len(ends) != 1 or ends[0].start() <= begins[0].end():
        return None
    if any(text[mark.start()] != "<" for mark in (begins[0], ends[0])):
        return None  # indented: the part would not be where it seems to be
    return Part(begins[0].end() + 1, ends[0].start())


def _line_end(text: str) -> str:
    """Return how the last line of a text ends that has an end."""
    return "\r\n" if text[: text.rfind("\n") + 1].endswith("\r\n") else "\n"


def differences(source: SourceFile, words: str, folder: PurePath) -> Iterator[Diagnostic]:
    """Yield every line of the written part that differs from what the task says.

    Args:
        source: The README, with no other line ends than those of Unix, and sound markers.
        words: What the part has to say.
        folder: Of the task, as shown.
    """
    remedy = (
        f"write it again: `vrts task check {folder} --write`; `vrts task pack` does so in its zips"
    )
    part = part_of(source.text)
    if part is None:
        headline = f"`{NAME}` has no part that is written from the task"
        notes = ("without it nothing makes sure that students read the numbers of the task",)
        yield warning(DIFFERS, headline, notes=notes, help=(remedy,))
        return
    there = source.text[part.start : part.end].split("\n")
    wanted = ["", *words.rstrip("\n").split("\n"), "", ""]
    first = source.line_of(part.start)
    for kind, a, b, c, d in SequenceMatcher(None, there, wanted, False).get_opcodes():
        if kind == "equal":
            continue
        for k in range(max(b - a, d - c)):
            has = there[a + k] if a + k < b else None
            says = wanted[c + k] if c + k < d else None
            if (has or says or "").strip() or (has and says):
                yield _difference(source, first + min(a + k, max(a, b - 1)), has, says, remedy)


def _difference(
    source: SourceFile, line: int, has: str | None, says: str | None, remedy: str
) -> Diagnostic:
    start = source.line_starts[line - 1]
    label = Label(Span(source, start, start + len(source.line_text(line))))
    if has is None or not has.strip():
        headline = f"`{NAME}` does not say: {_short(says)}"
    elif says is None or not says.strip():
        headline = f"`{NAME}` says what the task does not"
    else:
        headline = f"`{NAME}` differs from the task, which says: {_short(says)}"
    return warning(DIFFERS, headline, label, help=(remedy,))


def _short(text: str | None) -> str:
    line = one_line(text or "")
    return line if len(line) <= LONGEST else f"{line[: LONGEST - 1]}…"
