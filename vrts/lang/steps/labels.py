"""The label of a line: a number, or in AS also a name and a colon."""

import re

from vrts.base.diagnostic import Edit, Fix, Rule
from vrts.lang.names import key
from vrts.lang.problems import LIMIT, Problems
from vrts.lang.reading.sections.lines import Line
from vrts.lang.steps.advising.open_case import in_case
from vrts.lang.steps.tolerated import Odd, Tolerated
from vrts.lang.syntax.program import Label

INVALID_LABEL = Rule("V133", "invalid-label")
LARGE_LABEL = Rule("V154", "large-label")

MAX_LABEL = 65535  # [manual language/programs#labels]
MAX_VAL2_LABEL = 32767  # beyond it VAL-II may refuse what V+ takes [assumed]
_DIGITS = re.compile(r"\d+")
_LISTED = re.compile(r"\d+\.(?=[ \t]*\?)[ \t]*\?|\d+\.(?=[ \t]|$)")  # `12.  MOVE a` of a listing
_OF_LISTING = Odd("step numbers of a listing", "leave the numbers and their dots out")
_DECIMAL = re.compile(r"(?P<whole>\d+)\.(?P<part>\d+)(?=[ \t]|$)")
_ENDS = re.compile(r"^[ \t]*\.(?:PROGRAM|END)\b", re.IGNORECASE | re.MULTILINE)
_ALL_OTHERS = frozenset({"DEFAULT", "OTHERWISE", "OTHERS", "OTHER", "ELSE", "REST"})
_NAMED_LABEL = re.compile(r"(?P<name>[A-Za-z][\w.]*):", re.ASCII)


def read_label(
    line: Line, problems: Problems, tolerated: Tolerated
) -> tuple[Label | None, str, int]:
    """Return the label of a line, what follows it, and where that begins."""
    text = line.text
    if text[0].isdecimal():
        return _numbered(line, problems, tolerated)
    if problems.dialect.has("a"):
        named = _NAMED_LABEL.match(text)
        if named is not None and not _begins_group(line, named["name"].upper(), problems):
            rest = text[named.end() :].lstrip()
            label = Label(key(named["name"]), line.start, line.start + named.end() - 1)
            return label, rest, line.end - len(rest)
    return None, text, line.start


def _begins_group(line: Line, name: str, problems: Problems) -> bool:
    """Whether a word and its colon begin a group of a CASE, or are meant to: `DEFAULT:`."""
    if name in ("ANY", "VALUE"):
        return True
    text = problems.source.text
    if name not in _ALL_OTHERS or not in_case(text[: line.start]):
        return False
    return re.search(rf"\bGOTO[ \t]+{name}\b", text, re.IGNORECASE) is None


def _numbered(
    line: Line, problems: Problems, tolerated: Tolerated
) -> tuple[Label | None, str, int]:
    digits = _DIGITS.match(line.text)
    assert digits is not None
    rest = line.text[digits.end() :]
    if rest[:1].isalpha() or rest[:1] == "_":
        return None, line.text, line.start  # `3x = 1`: the tokeniser says what is wrong
    start, end = line.start, line.start + digits.end()
    text = rest.lstrip()
    decimal = _DECIMAL.match(line.text)
    if decimal is not None:
        _broken(line, decimal, problems)
        text = line.text[decimal.end() :].lstrip()
    elif rest.startswith("."):
        listed = _LISTED.match(line.text)
        if listed is not None and problems.dialect.tolerant:
            tolerated.note(_OF_LISTING, start, line.start + listed.end())
            text = line.text[listed.end() :].lstrip().removesuffix("@").rstrip()
            start = line.start + line.text.index(text, listed.end()) if text else line.end
            relabelled = line._replace(text=text, start=start, end=start + len(text))
            return read_label(relabelled, problems, tolerated) if text else (None, "", line.end)
        problems.error(
            INVALID_LABEL,
            "a label is a whole number followed by a blank",
            start,
            end + 1,
            notes=("VAL-II says *Invalid statement label*",),
            help=("take step numbers of a listing out of the file",),
        )
        text = rest[1:].lstrip()
    elif len(digits.group()) > 5 or int(digits.group()) > MAX_LABEL:
        problems.error(
            INVALID_LABEL,
            f"the label {digits.group()[:20]} is too large",
            start,
            end,
            notes=("VAL-II says *Invalid statement label*",),
            help=(f"use a number from 0 to {MAX_LABEL}",),
        )
    else:
        number = int(digits.group())
        if number > MAX_VAL2_LABEL and not problems.dialect.tolerant:
            problems.warning(
                LARGE_LABEL,
                f"the label {number} is larger than {MAX_VAL2_LABEL}",
                start,
                end,
                notes=("V+ takes labels up to 65535; a VAL-II controller may refuse this one",),
                help=("use a smaller number",),
            )
        return Label(number, start, end), text, line.end - len(text)
    return None, text, line.end - len(text)


def _broken(line: Line, decimal: re.Match[str], problems: Problems) -> None:
    """`10.5 MOVE a`: told once, with the jumps that name it."""
    written = decimal.group()
    start, end = line.start, line.start + len(written)
    edits: list[Edit] = []
    if len(problems.found) < LIMIT:
        first, last = _program_around(problems.source.text, start)
        body = problems.source.text[first:last]
        whole = next(
            (n for n in (decimal["whole"], decimal["whole"] + decimal["part"]) if _free(n, body)),
            None,
        )
        jumps = re.finditer(rf"\bGOTO[ \t]+({re.escape(written)})(?![\w.])", body, re.IGNORECASE)
        places = [(start, end), *((first + j.start(1), first + j.end(1)) for j in jumps)]
        edits = [Edit(problems.span(*place), whole) for place in places] if whole else []
    instead = edits[0].replacement if edits else "10"
    problems.error(
        INVALID_LABEL,
        f"the label {written} is no whole number",
        start,
        end,
        notes=("VAL-II says *Invalid statement label*",),
        help=(f"a label is a whole number: write `{instead}` here, and `GOTO {instead}`",),
        fix=Fix.from_edits(edits) if edits else None,
    )


def _program_around(text: str, at: int) -> tuple[int, int]:
    """Return where the program begins and ends that an offset lies in."""
    first, last = 0, len(text)
    for found in _ENDS.finditer(text):
        if found.start() > at:
            last = found.start()
            break
        first = found.end()
    return first, last


def _free(number: str, body: str) -> bool:
    """Whether no line of a program has a label."""
    taken = re.search(rf"^[ \t]*{number}(?![\w.])", body, re.MULTILINE)
    return taken is None and int(number) <= MAX_VAL2_LABEL
