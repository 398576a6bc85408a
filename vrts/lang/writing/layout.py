"""The canonical layout of a file: keywords upper case, names lower case, structures indented.

Lines are never added, removed or joined, so the steps keep their numbers. A line that does not
parse stays as it is, byte for byte, and so do comments and blank lines.
"""

from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.base.stack import deep_stack
from vrts.lang.dialect import Dialect
from vrts.lang.meaning.structure import word_of
from vrts.lang.problems import Problems
from vrts.lang.reading.headers import read_header
from vrts.lang.reading.sections.lines import Line, Section, comment_start
from vrts.lang.reading.splitter import split
from vrts.lang.steps.labels import read_label
from vrts.lang.steps.step_parser import StepParser
from vrts.lang.syntax.program import Step
from vrts.lang.syntax.statements import Bad, Rest
from vrts.lang.syntax.token import Token
from vrts.lang.writing.spelling_of_tokens import written

GUTTER = 8  # columns for labels, before the first level
INDENT = 4  # columns of a level; VALUE and ANY stand half a level inside their CASE
MAX_LEVELS = 20
NAME_WIDTH = 16  # columns of a name in a data section
BLANKS = " \t"  # of no use at the end of a line; another sign there may be half of a letter

_OPENERS = frozenset({"IF", "WHILE", "FOR", "CASE", "DO"})
_CLOSERS = frozenset({"END", "UNTIL"})
_GROUPS = frozenset({"VALUE", "ANY"})


class Layout(NamedTuple):
    """The text of a file in canonical layout."""

    rows: tuple[str, ...]  # as many as there were lines
    unread: tuple[
        int, ...
    ]  # numbers, from 1, of lines that stay as they are since nobody reads them

    @property
    def text(self) -> str:
        """All rows."""
        return "\n".join(self.rows)


@deep_stack()
def laid_out(source: SourceFile, dialect: Dialect) -> Layout:
    """Return a file in canonical layout, and which lines could not be read."""
    found = _Layout(source, dialect)
    return Layout(tuple(found.run()), tuple(found.unread))


def layout(source: SourceFile, dialect: Dialect) -> str:
    """Return the text of a file in canonical layout; the same again for what it returns."""
    return laid_out(source, dialect).text


def program_text(source: SourceFile, dialect: Dialect) -> dict[str, str]:
    """Return the canonical text of every program of a file, by name, header and .END included."""
    found = _Layout(source, dialect)
    found.run()
    return {name: "".join(rows) for name, rows in found.programs.items()}


class _Place(NamedTuple):
    """What a line of the file is."""

    kind: str  # "header", "step", "end"
    section: Section
    line: Line | None


class _Layout:
    def __init__(self, source: SourceFile, dialect: Dialect) -> None:
        self.source = source
        self.dialect = dialect
        self.problems = Problems(source, dialect)
        self.sections = split(self.problems)
        self.parser = StepParser(self.problems)
        self.parser.program_names = frozenset(
            read_header(s, Problems(source, dialect))[0]
            for s in self.sections
            if s.kind == "program"
        )
        self.open: list[tuple[str, int]] = []  # structure words and their indentation
        self.name = ""  # of the program that a row stands in
        self.programs: dict[str, list[str]] = {}
        self.unread: list[int] = []

    def run(self) -> list[str]:
        places = self._places()
        rows: list[str] = []
        at = 0
        inside: Section | None = None
        for raw in self.source.text.split("\n"):
            place = self._place(places, at, raw)
            if place is not None and place.kind == "header":
                inside, self.open = place.section, []
                self.name = read_header(inside, Problems(self.source, self.dialect))[0]
            rows.append(self._row(raw, at, place, inside))
            self._collect(rows[-1], inside, place)
            if place is not None and place.kind == "end":
                inside = None
            at += len(raw) + 1
        return rows

    def _collect(self, row: str, inside: Section | None, place: _Place | None) -> None:
        if inside is None or inside.kind != "program":
            return
        self.programs.setdefault(self.name, []).append(row + "\n")

    def _places(self) -> dict[int, _Place]:
        """Return what begins at an offset: headers, steps and data lines, ends of sections."""
        places: dict[int, _Place] = {}
        for section in self.sections:
            places[section.header.start] = _Place("header", section, None)
            for line in section.lines:
                places[line.start] = _Place("step", section, line)
            start, end = section.finish
            if start != end:
                places[start] = _Place("end", section, None)
        return places

    def _place(self, places: dict[int, _Place], at: int, raw: str) -> _Place | None:
        return places.get(at + len(raw) - len(raw.lstrip())) if raw.strip() else None

    # --- lines ----------------------------------------------------------------------------------

    def _row(self, raw: str, at: int, place: _Place | None, inside: Section | None) -> str:
        cut = comment_start(raw)
        comment = raw[cut:].rstrip(BLANKS) if cut >= 0 else ""
        if place is None:
            return self._unplaced(raw, comment, inside)
        if place.kind == "end":
            return self._joined(raw, ".END", comment) if _is_bare_end(raw, cut) else raw
        if place.kind == "header":
            header = self._header(place.section, raw, cut)
            return raw if header is None else self._joined(raw, header, comment)
        assert place.line is not None
        program = place.section.kind == "program"
        row = self._step(place.line) if program else self._data(place.line)
        return raw if row is None else self._joined(raw, row, comment)

    def _unplaced(self, raw: str, comment: str, inside: Section | None) -> str:
        """A blank line, a comment, or text of a section that is not known."""
        if not raw.strip(BLANKS):
            return ""
        if not raw.strip().startswith(";"):
            return raw
        if raw[0] == ";" or inside is None or inside.kind != "program":
            return raw.rstrip(BLANKS)
        return " " * (GUTTER + self._level()) + comment

    def _joined(self, raw: str, row: str, comment: str) -> str:
        """Put a comment behind a line: in its old column where it can stay there."""
        if not comment:
            return row
        column = len(raw[: comment_start(raw)].expandtabs(8))
        return row.ljust(max(column, len(row) + 2)) + comment

    def _header(self, section: Section, raw: str, cut: int) -> str | None:
        if section.kind != "program":
            return section.header.text.upper() if _is_word(section.header.text) else None
        problems = Problems(self.source, self.dialect)
        name, formals = read_header(section, problems)
        if problems.found or not name or not section.header.text.startswith("."):
            return None
        text = self.source.text[section.header.start : section.header.end]
        opening = text.find("(")
        closing = text.find(")", opening) if opening >= 0 else -1
        tail = text[closing + 1 :].strip() if closing >= 0 else ""
        if tail or (opening < 0 and len(text.split()) > 2):
            return None  # dates and numbers of AS
        if opening < 0:
            return f".PROGRAM {text.split()[1].lower()}"
        inner = text[opening + 1 : closing]
        named = ", ".join(
            formal.name.text.lower() + ("[]" if formal.array else "") for formal in formals
        )
        if "".join(inner.lower().split()) != named.replace(" ", ""):
            return None  # names of AS with signs before them
        return f".PROGRAM {text[:opening].split()[1].lower()}({named})"

    def _data(self, line: Line) -> str | None:
        """A data line: name in its columns, values after it; those of AS keep their shape."""
        name, _, values = line.text.partition(" ")
        if self.dialect.is_as or not values or "\t" in line.text or "=" in line.text:
            return None
        if not name.isascii() or name[0] in "+-.0123456789":
            return None  # the second line of a location of twelve numbers
        if '"' in values:
            return f"{name.lower():<{NAME_WIDTH - 1}} {values.strip(BLANKS)}"
        if not values.isascii():
            return None
        numbers = values.replace(",", " , ").split()
        if "," in numbers:
            return None  # a value may be left out between commas
        return f"{name.lower():<{NAME_WIDTH - 1}} {' '.join(numbers)}"

    def _step(self, line: Line) -> str | None:
        found = len(self.problems.found)
        label, text, at = read_label(line, self.problems, self.parser.tolerated)
        step = self.parser.step(line)
        indent = self._indent(step)
        code = ""
        if isinstance(step.statement, Bad) or any(d.is_error for d in self.problems.found[found:]):
            self.unread.append(self.source.line_of(line.start))
            return None
        if isinstance(step.statement, Rest):
            word, rest = text[: len(step.statement.word)], text[len(step.statement.word) :]
            if word.upper() != step.statement.word:
                return None
            blank = " " if rest[:1].isspace() else ""  # none in POINT/OAT
            code = f"{word.upper()}{blank}{rest.strip()}".rstrip()
        elif text:
            found_tokens = self.parser.tokens(text, at)
            if found_tokens is None or step.statement is None:
                return None
            tokens, head = found_tokens
            if not self._covered(tokens, at, at + len(text)):
                return None
            code = written(tokens, head, self.source.text, self.dialect)
            if len(code) > self.dialect.max_line:
                return None
        gutter = ""
        if label is not None:
            shown = self.source.text[label.start : label.end].lower()
            gutter = f"{shown}:" if isinstance(label.number, str) else shown
        if self.source.text[line.start : at].strip().lower() != gutter:
            return None  # a step number of a listing
        width = GUTTER + indent if code else 0
        if len(gutter) >= width and gutter and code:
            return f"{gutter} {code}"
        return f"{gutter:<{width}}{code}"

    def _covered(self, tokens: list[Token], start: int, end: int) -> bool:
        """Whether the tokens are all that stands on a line: some signs of AS make none."""
        at = start
        for token in tokens:
            if self.source.text[at : token.start].strip():
                return False
            at = token.end
        return not self.source.text[at:end].strip()

    # --- structure ------------------------------------------------------------------------------

    def _level(self) -> int:
        """Return the indentation of a plain step."""
        if not self.open:
            return 0
        return min(self.open[-1][1] + INDENT, MAX_LEVELS * INDENT)

    def _indent(self, step: Step) -> int:
        word = word_of(step)
        if word in _CLOSERS and self.open:
            return self.open.pop()[1]
        if word == "ELSE" and self.open:
            return self.open[-1][1]
        if word in _GROUPS and self.open:
            return self.open[-1][1] + INDENT // 2
        indent = self._level()
        if word in _OPENERS:
            self.open.append((word or "", indent))
        return indent


def _is_bare_end(raw: str, cut: int) -> bool:
    return (raw if cut < 0 else raw[:cut]).strip().upper() == ".END"


def _is_word(text: str) -> bool:
    return len(text.split()) == 1
