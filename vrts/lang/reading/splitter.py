"""A file to sections and lines, by hand. Never fails: what is odd is kept and reported.

Steps are numbered as the controller numbers them: from 1, blank and comment lines included, the
.PROGRAM line not counted [manual language/programs#steps].
"""

import re
from typing import NamedTuple

from vrts.base.diagnostic import Rule
from vrts.lang.joined import parts
from vrts.lang.problems import Problems
from vrts.lang.reading.characters import OPENING_QUOTES

MISSING_PROGRAM_LINE = Rule("V140", "missing-program-line")
MISSING_END_LINE = Rule("V141", "missing-end-line")
INVALID_HEADER = Rule("V142", "invalid-header")
UNKNOWN_SECTION = Rule("V144", "unknown-section")
LINE_TOO_LONG = Rule("V105", "line-too-long")
LONG_LINE = Rule("V106", "long-line")
TOO_MANY_STEPS = Rule("V115", "too-many-steps")

LONG = 132
MAX_DATA_LINE = 4096  # twelve values with all their digits
MAX_LINES = 150_000  # of all sections that hold something: with more it would not fit into memory
MAX_STEPS = 65_000  # of a program; more are refused before they are parsed

_DATA_SECTIONS = {
    ".LOCATIONS": "locations",
    ".TRANS": "locations",
    ".JOINTS": "locations",
    ".REALS": "reals",
    ".DOUBLES": "reals",
    ".STRINGS": "strings",
}
_DOTTED = re.compile(r"\.[A-Za-z_*][\w*]*")
_LOCAL = re.compile(r"\.[A-Za-z][\w.]*[ \t]*[=\[]", re.ASCII)  # a local name of AS, assigned
_STARS = re.compile(r"\.\*")  # lines of stars and words that AS writes between sections
_UNDOTTED = re.compile(r"PROGRAM[ \t]+[A-Za-z][\w.]*(?:[ \t]*\(.*\))?$", re.IGNORECASE)
_QUOTES = re.escape(OPENING_QUOTES)
_STRING_OR_COMMENT = re.compile(rf"""("[^"]*("|$)|[{_QUOTES}][^{_QUOTES}"]*[{_QUOTES}"]|'.)|(;)""")

DEFAULT_PROGRAM = "main"  # name given to steps outside any program [assumed]


class Line(NamedTuple):
    """What stands on a line before its comment, blanks stripped."""

    number: int  # in its section, from 1
    text: str
    start: int
    end: int


class Section(NamedTuple):
    """A program or a data section."""

    kind: str  # "program", "locations", "reals", "strings"
    header: Line
    lines: tuple[Line, ...]  # the ones that hold something
    line_count: int  # blank and comment lines included
    finish: tuple[int, int]  # range of its .END, or of the end of its last line


class _Open:
    def __init__(self, kind: str, header: Line) -> None:
        self.kind = kind
        self.header = header
        self.lines: list[Line] = []
        self.count = 0
        self.last = header.end


def split(problems: Problems) -> list[Section]:
    """Return the sections of the source."""
    return _Splitter(problems).run()


class _Splitter:
    def __init__(self, problems: Problems) -> None:
        self.problems = problems
        self.sections: list[Section] = []
        self.open: _Open | None = None
        self.skipping = False
        self.kept = 0  # lines, sections, formals
        self.stopped = False  # as there were too many
        self.long_lines: list[tuple[int, int]] = []

    def run(self) -> list[Section]:
        for at, text in parts(self.problems.source):
            self._file(text, at)
        self._report_long_lines()
        return self.sections

    def _file(self, text: str, at: int) -> None:
        for raw in text.split("\n"):
            if self.kept > MAX_LINES:
                self._stop(at)
                return
            self._line(raw, at)
            at += len(raw) + 1
        self.skipping = False
        if self.open is not None:
            self._close_without_end(None)

    def _stop(self, at: int) -> None:
        if not self.stopped:
            self.problems.error(
                TOO_MANY_STEPS,
                f"there are more than {MAX_LINES:,} steps and lines of data up to here",
                at,
                at,
                notes=("what follows is not read",),
                help=("split the file",),
            )
        self.stopped = True
        if self.open is not None:
            self._close((self.open.last, self.open.last))

    def _line(self, raw: str, at: int) -> None:
        cut = comment_start(raw)
        body = raw if cut < 0 else raw[:cut]
        text = body.strip()
        start = at + (len(body) - len(body.lstrip()) if text else 0)
        line = Line(0, text, start, start + len(text))
        if len(raw) > LONG and len(text) <= self.problems.dialect.max_line:
            self.long_lines.append((start, at + len(raw)))
        if _STARS.match(text):
            return
        if text.startswith(".") and self._is_section(text):
            self._dotted(line)
        elif _UNDOTTED.match(text):
            self._begin("program", line)
        elif self.skipping:
            return
        elif self.open is not None:
            self._keep(self.open, line)
        elif text:
            self._stray(line)

    def _is_section(self, text: str) -> bool:
        """Whether a line is `.PROGRAM` or its like, and no step on a local name of AS, `.x = 1`."""
        if _DOTTED.match(text) is None:
            return False
        return not (self.problems.dialect.has("a") and _LOCAL.match(text))

    def _keep(self, section: _Open, line: Line) -> None:
        section.count += 1
        if not line.text:
            return
        section.last = line.end
        most = self.problems.dialect.max_line if section.kind == "program" else MAX_DATA_LINE
        if len(line.text) > most:
            self.problems.error(
                LINE_TOO_LONG,
                f"this line has {len(line.text):,} characters; a line has at most {most}",
                line.start,
                line.start + 40,
                help=("compute parts of it in lines of their own",),
                data={"characters": len(line.text)},
            )
            return
        if section.kind == "program" and section.count > MAX_STEPS:
            return
        self.kept += 1
        section.lines.append(line._replace(number=section.count))

    def _dotted(self, line: Line) -> None:
        match = _DOTTED.match(line.text)
        assert match is not None
        word = match.group().upper()
        if word == ".END":
            self._end(line, match.end())
        elif word == ".PROGRAM":
            self._begin("program", line)
        elif word in _DATA_SECTIONS:
            self._begin(_DATA_SECTIONS[word], line)
        else:
            self._unknown(line, word)

    def _begin(self, kind: str, header: Line) -> None:
        if self.open is not None:
            self._close_without_end(header)
        self.skipping = False
        self.kept += 1 + header.text.count(",")  # formals take room as well
        self.open = _Open(kind, header)

    def _end(self, line: Line, word_end: int) -> None:
        if line.text[word_end:].strip():
            self.problems.warning(
                UNKNOWN_SECTION,
                "text after .END is ignored",
                line.start + word_end,
                line.end,
            )
        if self.skipping:
            self.skipping = False
        elif self.open is None:
            self.problems.warning(
                MISSING_PROGRAM_LINE,
                "this .END ends nothing",
                line.start,
                line.end,
                help=("begin each program with `.PROGRAM name`, or take this line out",),
            )
        else:
            self._close((line.start, line.end))

    def _unknown(self, line: Line, word: str) -> None:
        if self.open is not None:
            self._close_without_end(line)
        self.skipping = True
        self.problems.warning(
            UNKNOWN_SECTION,
            f"the section {word} is not known and is skipped",
            line.start,
            line.start + len(word),
            help=("sections are .PROGRAM, .LOCATIONS, .REALS and .STRINGS",),
        )

    def _stray(self, line: Line) -> None:
        """Steps outside any program, as in real files [manual language/programs#loose-steps]."""
        self.problems.warning(
            MISSING_PROGRAM_LINE,
            "these steps stand outside any program",
            line.start,
            line.end,
            f"taken as the first step of a program `{DEFAULT_PROGRAM}`",
            help=(f"write `.PROGRAM {DEFAULT_PROGRAM}` above and `.END` below",),
        )
        self.kept += 1
        self.open = _Open("program", Line(0, "", line.start, line.start))
        self._keep(self.open, line)

    def _close_without_end(self, noticed: Line | None) -> None:
        section = self.open
        assert section is not None
        header = section.header
        if header.text:
            where = (
                (self.problems.label(noticed.start, noticed.end, "the next section begins here"),)
                if noticed is not None
                else ()
            )
            self.problems.warning(
                MISSING_END_LINE,
                f"the {_named(section.kind)} that begins here has no .END",
                header.start,
                header.end,
                secondary=where,
                help=("write .END after its last line",),
            )
        self._close((section.last, section.last))

    def _close(self, finish: tuple[int, int]) -> None:
        section = self.open
        assert section is not None
        if section.count > MAX_STEPS and section.kind == "program":
            self.problems.error(
                TOO_MANY_STEPS,
                f"this program has {section.count:,} steps",
                section.header.start,
                section.header.end,
                notes=(f"the limit is {MAX_STEPS:,} steps a program",),
                help=("split it into several programs",),
                data={"steps": section.count},
            )
        self.sections.append(
            Section(section.kind, section.header, tuple(section.lines), section.count, finish)
        )
        self.open = None

    def _report_long_lines(self) -> None:
        if not self.long_lines:
            return
        start, end = self.long_lines[0]
        more = len(self.long_lines) - 1
        self.problems.warning(
            LONG_LINE,
            f"this line is longer than {LONG} characters",
            start,
            min(end, start + 40),
            notes=(f"so {'is' if more == 1 else 'are'} {more} more",) if more else (),
            help=("an original controller may cut it off",),
        )


def comment_start(line: str) -> int:
    """Return where the comment of a line begins (its `;`), or -1."""
    first = line.find(";")
    if first < 0:
        return -1
    for match in _STRING_OR_COMMENT.finditer(line):
        if match.group(3):
            return match.start()
    return -1


def _named(kind: str) -> str:
    return "program" if kind == "program" else f"section of {kind}"
