"""Source lines with what is to be said about them, laid out as rustc does.

```
 --> pick.v2:3:9
  |
3 |   MOVES part:grip
  |         ^^^^^^^^^ needs 412 deg/s; the limit is 240 deg/s
```
"""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Label
from vrts.base.source import SourceFile, Span
from vrts.report.plain import bare_name, one_line, shown, width
from vrts.report.screen.palette import BY_SEVERITY, Palette, Style

MOST_COLUMNS = 140  # longer lines are cut around what is marked
BEFORE = 30  # columns kept before the first mark of a cut line
ALL_LINES = 4  # longer spans show their first and last line only


class Mark(NamedTuple):
    """A part of one line to underline, and the words for it."""

    start: int  # offset in the line
    end: int
    text: str
    primary: bool


class Marked(NamedTuple):
    """A line of an excerpt. `gap` says that lines were left out before it."""

    line: int
    marks: tuple[Mark, ...]
    gap: bool


class Block(NamedTuple):
    """Lines shown together, all of one source."""

    source: SourceFile
    lines: tuple[Marked, ...]


def blocks(primary: Label | None, secondary: Sequence[Label]) -> list[Block]:
    """Return what to show: primary label first; labels on a line already shown join it."""
    found: list[Block] = []
    labels = ([(primary, True)] if primary else []) + [(label, False) for label in secondary]
    for label, is_primary in labels:
        lines = _marked(label, primary=is_primary)
        for at, block in enumerate(found):
            if block.source is label.span.source and _covers(block, lines):
                found[at] = _joined(block, lines)
                break
        else:
            found.append(Block(label.span.source, lines))
    return found


def excerpt(d: Diagnostic, palette: Palette, *, bare: bool = False) -> list[str]:
    """Return the excerpt's lines, from ` --> place` on; empty without any label.

    Args:
        d: What was found.
        palette: Paints the parts.
        bare: Whether files are named without their folders, for readers on other machines.
    """
    primary = d.primary
    parts = blocks(primary, d.secondary)
    if not parts:
        return []
    digits = gutter_width(parts)
    blank = palette.paint(Style.GUTTER, " " * digits + " |")
    style = BY_SEVERITY[d.severity]
    source: SourceFile | None = None
    rows: list[str] = []
    for block in parts:
        if block.source is not source:
            arrow = "-->" if source is None else ":::"
            rows.append(
                palette.paint(Style.GUTTER, " " * digits + arrow)
                + " "
                + _place(block, primary, bare=bare)
            )
            source = block.source
        rows.append(blank)
        for marked in block.lines:
            if marked.gap:
                rows.append(palette.paint(Style.GUTTER, "..."))
            rows += _line_rows(block.source, marked, digits, palette, style)
    return rows


def gutter_width(parts: Sequence[Block]) -> int:
    """Return the number of digits of the largest line number shown."""
    return len(str(max(marked.line for block in parts for marked in block.lines)))


def place(span: Span) -> str:
    """Return `name:line:column`."""
    return f"{one_line(span.source.name)}:{span.line}:{span.column}"


def _place(block: Block, primary: Label | None, *, bare: bool) -> str:
    name = bare_name(block.source.name) if bare else block.source.name
    line, column = block.lines[0].line, min(mark.start for mark in block.lines[0].marks) + 1
    if primary is not None and primary.span.source is block.source:
        line, column = primary.span.line, primary.span.column
    return f"{one_line(name)}:{line}:{column}"


def _marked(label: Label, *, primary: bool) -> tuple[Marked, ...]:
    span = label.span
    source = span.source
    first = source.line_of(span.start)
    last = source.line_of(max(span.start, span.end - 1))
    text = one_line(label.text)
    if first == last:
        start = span.start - source.line_starts[first - 1]
        end = max(start + 1, span.end - source.line_starts[first - 1])
        return (Marked(first, (Mark(start, end, text, primary),), gap=False),)
    every = last - first < ALL_LINES
    numbers = range(first, last + 1) if every else (first, last)
    lines: list[Marked] = []
    for number in numbers:
        line = source.line_text(number)
        offset = source.line_starts[number - 1]
        start = max(span.start - offset, len(line) - len(line.lstrip()))
        end = max(start + 1, min(span.end - offset, len(line)))
        words = text if number == last else ""
        lines.append(
            Marked(number, (Mark(start, end, words, primary),), gap=not every and number == last)
        )
    return tuple(lines)


def _covers(block: Block, lines: Sequence[Marked]) -> bool:
    return {marked.line for marked in lines} <= {marked.line for marked in block.lines}


def _joined(block: Block, lines: Sequence[Marked]) -> Block:
    more = {marked.line: marked.marks for marked in lines}
    return Block(
        block.source,
        tuple(m._replace(marks=(*m.marks, *more.get(m.line, ()))) for m in block.lines),
    )


def _line_rows(
    source: SourceFile, marked: Marked, digits: int, palette: Palette, style: Style
) -> list[str]:
    line = source.line_text(marked.line)
    text, columns = shown(line)
    end = columns[-1]
    at = [
        (columns[min(m.start, len(line))], columns[min(m.end, len(line))] or 1, m)
        for m in marked.marks
    ]
    at = [(first, max(first + 1, last), m) for first, last, m in at]
    if end > MOST_COLUMNS:
        text, at = _cut(text, at)
    gutter = palette.paint(Style.GUTTER, f"{marked.line:>{digits}} |")
    blank = palette.paint(Style.GUTTER, " " * digits + " |")
    rows = [f"{gutter} {text}".rstrip()]
    return rows + [f"{blank} {row}" for row in _underlines(at, palette, style)]


def _cut(text: str, at: list[tuple[int, int, Mark]]) -> tuple[str, list[tuple[int, int, Mark]]]:
    """Return a window of a long line. Wide characters make it a little narrower, never wrong."""
    begin = max(0, min(first for first, _, _ in at) - BEFORE)
    kept: list[str] = []
    column = 0
    for character in text:
        if begin <= column < begin + MOST_COLUMNS:
            kept.append(character)
        column += width(character)
    shift = begin - 1 if begin else 0
    window = ("…" if begin else "") + "".join(kept) + "…"
    limit = MOST_COLUMNS + 1
    moved = [
        (min(first - shift, limit), min(max(last - shift, first - shift + 1), limit + 1), m)
        for first, last, m in at
    ]
    return window, moved


def _underlines(at: list[tuple[int, int, Mark]], palette: Palette, style: Style) -> list[str]:
    """Return the underline row and the rows of words hanging below it."""
    length = max(last for _, last, _ in at)
    signs = [" "] * length
    for primary in (False, True):
        for first, last, mark in at:
            if mark.primary is primary:
                signs[first:last] = ("^" if primary else "-") * (last - first)
    row = "".join(_painted(sign, palette, style) for sign in _runs(signs))
    words = sorted((entry for entry in at if entry[2].text), key=lambda entry: -entry[0])
    rows: list[str] = []
    if words and words[0][1] == length:
        first = words.pop(0)
        row += " " + palette.paint(_style(first[2], style), first[2].text)
    rows.append(row)
    if words:
        rows.append(_bars([first for first, _, _ in words], palette))
    for index, (first, _, mark) in enumerate(words):
        left = sorted({other for other, _, _ in words[index + 1 :] if other < first})
        bars = _bars(left, palette, until=first)
        rows.append(bars + palette.paint(_style(mark, style), mark.text))
    return rows


def _bars(columns: Sequence[int], palette: Palette, until: int | None = None) -> str:
    length = max(columns, default=-1) + 1 if until is None else until
    cells = [" "] * length
    for column in columns:
        cells[column] = "|"
    return "".join(palette.paint(Style.SECONDARY, c) if c == "|" else c for c in cells)


def _runs(signs: Sequence[str]) -> list[str]:
    runs: list[str] = []
    for sign in signs:
        if runs and runs[-1][0] == sign:
            runs[-1] += sign
        else:
            runs.append(sign)
    return runs


def _painted(run: str, palette: Palette, style: Style) -> str:
    if run[0] == " ":
        return run
    return palette.paint(style if run[0] == "^" else Style.SECONDARY, run)


def _style(mark: Mark, style: Style) -> Style:
    return style if mark.primary else Style.SECONDARY
