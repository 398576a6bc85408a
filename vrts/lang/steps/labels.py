"""The label of a line: a number, or in AS also a name and a colon."""

import re

from vrts.base.diagnostic import Rule
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.reading.splitter import Line
from vrts.lang.steps.tolerated import Tolerated
from vrts.lang.syntax.program import Label

INVALID_LABEL = Rule("V133", "invalid-label")
LARGE_LABEL = Rule("V154", "large-label")

MAX_LABEL = 65535  # [manual language/programs#labels]
MAX_VAL2_LABEL = 32767  # beyond it VAL-II may refuse what V+ takes [assumed]
_DIGITS = re.compile(r"\d+")
_LISTED = re.compile(r"\d+\.(?=[ \t]*\?)[ \t]*\?|\d+\.(?=[ \t]|$)")  # `12.  MOVE a` of a listing
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
        if named is not None and named["name"].upper() not in ("ANY", "VALUE"):
            rest = text[named.end() :].lstrip()
            label = Label(key(named["name"]), line.start, line.start + named.end() - 1)
            return label, rest, line.end - len(rest)
    return None, text, line.start


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
    if rest.startswith("."):
        listed = _LISTED.match(line.text)
        if listed is not None and problems.dialect.tolerant:
            tolerated.note("step numbers of a listing", start, line.start + listed.end())
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
