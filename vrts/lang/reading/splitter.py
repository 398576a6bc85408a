"""A file to sections and lines, by hand. Never fails: what is odd is kept and reported.

Steps are numbered as the controller numbers them: from 1, blank and comment lines included, the
.PROGRAM line not counted [manual language/programs#steps].
"""

import re

from vrts.base.diagnostic import Fix, Rule
from vrts.base.made import made
from vrts.lang.joined import parts
from vrts.lang.problems import Problems
from vrts.lang.reading.sections.lines import Line, Section, comment_start
from vrts.lang.reading.sections.misplaced_lines import (
    MISSING_END_LINE,
    Place,
    is_data,
    is_end_without_dot,
    is_value,
    open_structures,
    report_data,
    report_dotted_end,
    report_end_of_nothing,
    report_end_without_dot,
    report_steps_outside,
    report_values_outside,
    tells_itself,
)
from vrts.lang.reading.sections.section_heads import SectionHead, foreign_head, section_head

INVALID_HEADER = Rule("V142", "invalid-header")
UNKNOWN_SECTION = Rule("V144", "unknown-section")
LINE_TOO_LONG = Rule("V105", "line-too-long")
LONG_LINE = Rule("V106", "long-line")
TOO_MANY_STEPS = Rule("V115", "too-many-steps")

LONG = 132
MAX_DATA_LINE = 4096  # twelve values with all their digits
MAX_LINES = 150_000  # of all sections that hold something: with more it would not fit into memory
MAX_STEPS = 65_000  # of a program; more are refused before they are parsed

_LOCAL = re.compile(r"\.[A-Za-z][\w.]*[ \t]*[=\[]", re.ASCII)  # a local name of AS, assigned
_STARS = ".*"  # lines of stars and words that AS writes between sections


class _Open:
    def __init__(self, kind: str, header: Line) -> None:
        self.kind = kind
        self.header = header
        self.lines: list[Line] = []
        self.count = 0
        self.last = header.end
        self.foreign = False  # whether it begins as programs of other languages do
        self.told = False  # of steps outside any program: whether they are to be told
        self.data: list[Line] = []  # of a program: values that stand among its steps

    @property
    def ends_unsaid(self) -> bool:
        """Whether `def b():` may follow: what is open is such a program, or no step at all."""
        return self.foreign or not (self.header.text or self.told or self.kind != "program")


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
        self.strict = not problems.dialect.has("a")
        self.headers: list[str] = []  # of the programs
        self.outside: list[Line] = []  # the first steps of programs without a header
        self.unended = 0  # sections whose .END may still come, behind another section

    def run(self) -> list[Section]:
        for at, text in parts(self.problems.source):
            self._file(text, at)
        self._report_long_lines()
        for line in self.outside:
            report_steps_outside(self.problems, _place(line), self.headers)
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
        cut = comment_start(raw) if ";" in raw else -1
        body = raw if cut < 0 else raw[:cut]
        text = body.strip()
        start = at + (len(body) - len(body.lstrip()) if text else 0)
        line = made(Line, (0, text, start, start + len(text)))
        if len(raw) > LONG and len(text) <= self.problems.dialect.max_line:
            self.long_lines.append((start, at + len(raw)))
        if text[:2] == _STARS:
            return
        head = self._head(text) if text else None
        if head is not None:
            self._section(line, head)
        elif self.skipping:
            return
        elif self.open is not None:
            self._keep(self.open, line)
        elif text:
            self._stray(line)

    def _head(self, text: str) -> SectionHead | None:
        """Return the section of `.PROGRAM` and its like; `.x = 1` is a step on a local name."""
        inside = self.open is not None and self.open.kind == "program"
        if text[:1] == "." and (inside or self.problems.dialect.has("a")) and _LOCAL.match(text):
            return None
        head = section_head(text, strict=self.strict)
        if head is None and self.strict and (self.open is None or self.open.ends_unsaid):
            head = foreign_head(text)
        if inside and self.problems.dialect.is_as and head is not None and not head.kind:
            return None  # `.x` that lost its step: AS stores no unknown section inside a program
        return head

    def _keep(self, section: _Open, line: Line) -> None:
        section.count += 1
        if not line.text:
            return
        section.last = line.end
        text = line.text
        most = self.problems.dialect.max_line if section.kind == "program" else MAX_DATA_LINE
        if len(text) > most:
            self.problems.error(
                LINE_TOO_LONG,
                f"this line has {len(line.text):,} characters; a line has at most {most}",
                line.start,
                line.start + 40,
                help=("compute parts of it in lines of their own",),
                data={"characters": len(line.text)},
            )
            return
        if section.kind == "program":
            if section.count > MAX_STEPS:
                return
            if self.strict and is_data(text, self.problems):
                section.data.append(line)
                return
            if not section.header.text and not section.told and not tells_itself(line.text):
                section.told = True
                self.outside.append(line)
        self.kept += 1
        section.lines.append(made(Line, (section.count, text, line.start, line.end)))

    def _section(self, line: Line, head: SectionHead) -> None:
        if head.meant:
            written = line.text[: head.end]
            fix = self.problems.replace(line.start, line.start + head.end, head.meant)
            if head.behind:
                cut = self.problems.replace(line.end - head.behind, line.end, "")
                fix = Fix.from_edits((*fix.edits, *cut.edits))
                line = line._replace(text=line.text[: -head.behind], end=line.end - head.behind)
            self.problems.error(
                UNKNOWN_SECTION,
                _instead(head, written),
                line.start,
                line.start + head.end,
                help=(f"write `{head.meant}{line.text[head.end :]}`",)
                if head.kind == "program"
                else (f"write `{head.meant}`",),
                fix=fix,
            )
        if head.kind == "end":
            self._end(line, head.end)
        elif head.kind:
            self._begin(head.kind, line)
        else:
            self._unknown(line, head.end)

    def _begin(self, kind: str, header: Line) -> None:
        if self.open is not None:
            self._close_without_end(header)
        self.skipping = False
        self.kept += 1 + header.text.count(",")  # formals take room as well
        self.open = _Open(kind, header)
        self.open.foreign = header.text[:1] != "." and foreign_head(header.text) is not None
        if kind == "program":
            self.headers.append(header.text)

    def _end(self, line: Line, word_end: int) -> None:
        if line.text[word_end:].strip():
            self.problems.warning(
                UNKNOWN_SECTION,
                "text after .END is ignored",
                line.start + word_end,
                line.end,
                help=("write `.END` alone on its line",),
                fix=self.problems.replace(line.start + word_end, line.end, ""),
            )
        if self.skipping:
            self.skipping = False
        elif self.open is None and self._reopened():
            self._close((line.start, line.end))
        elif self.open is None:
            if not self.unended:
                report_end_of_nothing(self.problems, _place(line))
            self.unended = max(self.unended - 1, 0)
        else:
            self._close((line.start, line.end))

    def _unknown(self, line: Line, end: int) -> None:
        if self.open is not None:
            self._close_without_end(line)
        self.skipping = True
        self.problems.warning(
            UNKNOWN_SECTION,
            f"the section {line.text[:end].upper()} is not known and is skipped",
            line.start,
            line.start + end,
            help=("sections are .PROGRAM, .LOCATIONS, .REALS and .STRINGS",),
        )

    def _stray(self, line: Line) -> None:
        """Take steps and values outside any section as one without its first line."""
        kind = "program"
        if self.strict and is_data(line.text, self.problems):
            kind = "locations"
        elif self.strict and is_value(line.text, self.problems):
            kind = "reals"
        if kind == "program" and self._reopened():
            assert self.open is not None
            self._keep(self.open, line)
            return
        self.kept += 1
        self.open = _Open(kind, Line(0, "", line.start, line.start))
        self._keep(self.open, line)

    def _reopened(self) -> bool:
        """Go on with the program before, if its `.END` was meant to end a structure."""
        before = self.sections[-1] if self.sections else None
        if not self.strict or before is None or before.kind != "program":
            return False
        start, end = before.finish
        if not before.header.text or self.problems.source.text[start:end].upper() != ".END":
            return False
        if open_structures([line.text for line in before.lines]) < 1:
            return False
        del self.sections[-1]
        report_dotted_end(self.problems, start, end)
        self.open = _Open("program", before.header)
        self.open.lines = list(before.lines)
        self.open.count = before.line_count
        self._keep(self.open, Line(0, "END", start, end))
        return True

    def _close_without_end(self, noticed: Line | None) -> None:
        section = self.open
        assert section is not None
        header = section.header
        texts = [line.text for line in section.lines]
        program = section.kind == "program"
        braces = self.problems.source.text[header.end : header.end + 3].lstrip()[:1] == "{"
        if self.strict and is_end_without_dot(texts, program=program, braces=braces):
            end = section.lines.pop()
            report_end_without_dot(self.problems, _place(end), _named(section.kind))
            self._close((end.start, end.end))
            return
        if header.text:
            self.unended += noticed is not None
            named = _named(section.kind)
            last = section.lines[-1] if section.lines else header
            here = noticed or last
            self.problems.warning(
                MISSING_END_LINE,
                f"the {named} above this line has no .END"
                if noticed is not None
                else f"the {named} that ends here has no .END",
                here.start,
                here.end,
                secondary=(self.problems.label(header.start, header.end, "it begins here"),)
                if here is not header
                else (),
                help=("write .END after its last line",),
                fix=self._insert_end(section.last),
            )
        self._close((section.last, section.last))

    def _insert_end(self, last: int) -> Fix:
        text = self.problems.source.text
        at = text.find("\n", last)
        at = len(text) if at < 0 else at
        return self.problems.replace(at, at, "\n.END")

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
        if not section.header.text and section.kind != "program":
            places = [_place(line) for line in section.lines]
            head = f".{section.kind.upper()}"
            report_values_outside(self.problems, places, head, ended=finish[0] < finish[1])
        if section.data:
            self._close_data(section, finish)
        self.open = None

    def _close_data(self, section: _Open, finish: tuple[int, int]) -> None:
        """Report values among the steps of a program, and take them for a section of their own."""
        last = max((line.end for line in section.lines), default=0)
        ends = finish[0] < finish[1] and last < section.data[0].start
        report_data(
            self.problems, [_place(line) for line in section.data], finish[0] if ends else None
        )
        first = section.data[0]
        header = Line(0, "", first.start, first.start)
        lines = tuple(section.data)
        self.sections.append(Section("locations", header, lines, len(lines), finish))

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


def _instead(head: SectionHead, written: str) -> str:
    """Return the headline for a line that begins or ends a section in other words."""
    if head.kind == "end":
        return f"`{written}` ends no section"
    if written[:1].isalpha() and head.kind == "program":
        return f"`{written}` begins no program: `.PROGRAM` does"
    return f"`{written}` begins no section"


def _place(line: Line) -> Place:
    return Place(line.text, line.start, line.end)


def _named(kind: str) -> str:
    return "program" if kind == "program" else f"section of {kind}"
