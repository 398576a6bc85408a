"""Lines that stand where they mean nothing: data in programs, steps outside of them, odd ends."""

import re
from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.diagnostic import Rule
from vrts.lang.problems import Problems
from vrts.lang.vocabulary.lookup import look_up

MISSING_PROGRAM_LINE = Rule("V140", "missing-program-line")
MISSING_END_LINE = Rule("V141", "missing-end-line")
MISPLACED_DATA = Rule("V165", "misplaced-data")
MISPLACED_END = Rule("V166", "dotted-end")

DEFAULT_PROGRAM = "main"  # name given to steps outside any program [assumed]

_NUMBER = r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?"
_DATA = re.compile(
    rf"(?P<name>#?[A-Za-z][\w.]*)[ \t]*(?:\[[ \t\d,]*\])?[ \t]*(?P<equals>=[ \t]*)?(?<![\w.])"
    rf"(?P<values>{_NUMBER}(?:[ \t]*,[ \t]*{_NUMBER}|[ \t]+{_NUMBER})*)$",
    re.ASCII,
)
_UNSIGNED = re.compile(r"\d[ \t]+[.\d]")  # no sum: a number behind another
_HEADER = re.compile(  # of a program in another language
    r"(?:def|void|proc|sub|func|fun|function|procedure|program)[ \t]+[A-Za-z]", re.IGNORECASE
)
_MANY = 3  # numbers: one or two may be a step with a slip in it
_ONE_NUMBER = re.compile(rf"[A-Za-z][\w.]*(?:\[[ \t\d,]*\])?[ \t]+{_NUMBER}$", re.ASCII)
_ENDS = re.compile(
    r"END(?:[ \t_]*(?:PROGRAM|PROG|PROCEDURE|PROC|SUB|FUNCTION|FUNC|DEF|MAIN"
    r"|LOCATIONS?|REALS?|STRINGS?))?[ \t]*[.;:]?$",
    re.IGNORECASE,
)
_OPENS = re.compile(
    r"(?:\d+[ \t]+)?(?:IF\b(?!.*\bGOTO\b)|(?:FOR|WHILE|CASE)\b(?![ \t]*=))", re.IGNORECASE
)
_PLAIN_END = re.compile(r"(?:\d+[ \t]+)?END$", re.IGNORECASE)


_NO_STEP = re.compile(  # comments and what other languages have above their programs
    r"#|//|/\*|\(\*|--|'|%|!|.*\*/$|REM\b"
    r"|(?:IMPORT|FROM|USING|INCLUDE|VAR|DIM|CONST|MODULE)\b(?![ \t]*=)",
    re.IGNORECASE,
)


class Place(NamedTuple):
    """Text and range of a line, or of several."""

    text: str
    start: int
    end: int


def is_data(text: str, problems: Problems) -> bool:
    """Return whether a line gives several values to a name, as only data sections do."""
    if not text[-1:].isdecimal() and text[-1:] != ".":
        return False
    match = _DATA.match(text)
    if match is None or len(match["values"].split()) < _MANY:
        return False
    if match["equals"] and _UNSIGNED.search(match["values"]) is None:
        return False
    return look_up(match["name"], problems.dialect).word is None


def is_value(text: str, problems: Problems) -> bool:
    """Return whether a line outside of any section gives a name one value: `pitch 25.4`."""
    if _ONE_NUMBER.match(text) is None:
        return False
    found = look_up(re.split(r"[ \t\[]", text)[0], problems.dialect)
    return found.word is None and not found.candidates


def report_data(problems: Problems, lines: Sequence[Place], program_end: int | None) -> None:
    """Report values among the steps of a program.

    `program_end` is where its `.END` begins, if nothing but values stands before it.
    """
    first = lines[0]
    more = len(lines) - 1
    fix = None
    if program_end is not None:
        fix = problems.replace(first.start, first.start, ".END\n.LOCATIONS\n")
    problems.error(
        MISPLACED_DATA,
        "values of a location stand among the steps of a program",
        first.start,
        first.end,
        "this is no step",
        notes=(f"so {'does' if more == 1 else 'do'} {more} more below",) if more else (),
        help=("end the program by `.END` before them, and begin their section by `.LOCATIONS`",),
        fix=fix,
    )


def report_values_outside(
    problems: Problems, lines: Sequence[Place], head: str, *, ended: bool
) -> None:
    """Report values before the first section, or behind the end of one."""
    first, last = lines[0], lines[-1]
    text = problems.source.text[first.start : last.end]
    problems.error(
        MISPLACED_DATA,
        "these values stand outside of any section",
        first.start,
        first.end,
        help=(f"write `{head}` above them and `.END` below",),
        fix=problems.replace(first.start, first.start, f"{head}\n")
        if ended
        else problems.replace(first.start, last.end, f"{head}\n{text}\n.END"),
    )


def report_steps_outside(problems: Problems, line: Place, programs: Sequence[str]) -> None:
    """Report steps outside of any program, as in real files [manual language/programs#loose-steps].

    `programs` are the headers of those that the file has.
    """
    if _HEADER.match(line.text):
        return  # told where it is read as a step
    if not any(_names_main(header) for header in programs):
        problems.warning(
            MISSING_PROGRAM_LINE,
            "these steps stand outside any program",
            line.start,
            line.end,
            f"taken as the first step of a program `{DEFAULT_PROGRAM}`",
            help=(f"write `.PROGRAM {DEFAULT_PROGRAM}` above and `.END` below",),
        )
        return
    problems.error(
        MISSING_PROGRAM_LINE,
        "this step stands outside any program",
        line.start,
        line.end,
        "no program holds this step",
        help=("move it between the `.PROGRAM` line and the `.END` of a program",),
    )


def tells_itself(text: str) -> bool:
    """Return whether a line outside of any program is told by what it is: a comment, an import."""
    return _NO_STEP.match(text) is not None


def _names_main(header: str) -> bool:
    return re.match(rf"\W*\w+[ \t]+{DEFAULT_PROGRAM}\b", header, re.IGNORECASE) is not None


def is_end_without_dot(lines: Sequence[str], *, program: bool, braces: bool = False) -> bool:
    """Return whether the last line of a section without `.END` was meant to be it.

    Args:
        lines: What the section holds.
        program: Whether it is a program.
        braces: Whether `{` begins it, so that `}` ends it.
    """
    if braces and lines and lines[-1] == "}":
        return True
    if not lines or _ENDS.match(lines[-1]) is None:
        return False
    if not program or _PLAIN_END.match(lines[-1]) is None:
        return True
    return open_structures(lines) == -1


def open_structures(lines: Sequence[str]) -> int:
    """Return how many structures of a program want an END, by their first words alone."""
    opened = sum(_OPENS.match(text) is not None for text in lines)
    return opened - sum(_PLAIN_END.match(text) is not None for text in lines)


def report_dotted_end(problems: Problems, start: int, end: int) -> None:
    """Report `.END` where `END` belongs: steps of the program follow."""
    problems.error(
        MISPLACED_END,
        "`.END` ends the program, and a structure is still open",
        start,
        end,
        "steps follow that would stand outside any program",
        help=("write `END`, without the dot, to end the structure",),
        fix=problems.replace(start, end, "END"),
    )


def report_end_without_dot(problems: Problems, line: Place, what: str) -> None:
    """Report `END` where `.END` belongs."""
    problems.error(
        MISSING_END_LINE,
        f"`{line.text}` ends a structure, not a {what}: its dot is missing"
        if line.text.upper().rstrip(" .:;") == "END"
        else f"`{line.text}` ends no {what}: `.END` does",
        line.start,
        line.end,
        help=("write `.END`",),
        fix=problems.replace(line.start, line.end, ".END"),
    )


def report_end_of_nothing(problems: Problems, line: Place) -> None:
    """Report an `.END` behind another."""
    text = problems.source.text
    cut = text.find("\n", line.end)
    start = text.rfind("\n", 0, line.start) + 1
    problems.warning(
        MISSING_PROGRAM_LINE,
        "this .END ends nothing",
        line.start,
        line.end,
        help=("take this line out, or begin a program above it with `.PROGRAM name`",),
        fix=problems.replace(start, cut + 1 if cut >= 0 else len(text), ""),
    )
