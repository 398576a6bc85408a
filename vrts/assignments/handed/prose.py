"""Tolerances that a teacher's own words name, held against those of the task.

Words are read as far as a number with a unit follows a word for a tolerance: "within 10 mm",
"± 5 degrees", "no longer than 12 s", "out of 20 points", also in German. What stands in a block of
code is shown, not said, and is left out.
"""

import re
from bisect import bisect_right
from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from vrts.assignments.handed.words import number
from vrts.base.diagnostic import Diagnostic, Label, Rule, warning
from vrts.base.source import SourceFile, Span

CONTRADICTS = Rule("V686", "readme-contradicts")

_UNITS = {
    "mm": ("mm", Fraction(1)),
    "cm": ("mm", Fraction(10)),
    "millimetre": ("mm", Fraction(1)),
    "millimeter": ("mm", Fraction(1)),
    "degree": ("degrees", Fraction(1)),
    "deg": ("degrees", Fraction(1)),
    "°": ("degrees", Fraction(1)),
    "grad": ("degrees", Fraction(1)),
    "s": ("s", Fraction(1)),
    "second": ("s", Fraction(1)),
    "sekunde": ("s", Fraction(1)),
    "point": ("points", Fraction(1)),
    "punkt": ("points", Fraction(1)),
}
_VALUE = (
    r"(\d{1,6}(?:[.,]\d{1,6})?)[\s-]?"
    r"(mm|cm|millimet(?:re|er)s?n?|deg(?:rees?)?|°|grad|s|sec|seconds?|sekunden?|points?|punkten?|"
    r"punkte)(?![\w/²])"
)
_BEFORE = (
    r"(?:\b(?:within(?:\sa\sradius\sof)?|tolerances?(?:\s(?:of|is)|\s?[:=])?|accuracy\sof|"
    r"accurate\sto|precise\sto|at\smost|(?:no|not)\s(?:more|longer|farther|further)\sthan|out\sof|"
    r"innerhalb(?:\svon)?|im\sumkreis\svon|höchstens|maximal|toleranz(?:\svon|\s?[:=])?|"
    r"genauigkeit\svon|nicht\s(?:mehr|länger)\sals)|±|\+/-)"
    r"\s*(?:(?:about|circa|ca\.|etwa)\s)?[*_]{0,2}"
)
_AFTER = r"(?=[*_]{0,2}\s(?:tolerance|accuracy|or\sless|at\smost|toleranz|oder\sweniger|genau\b))"
_PHRASE = re.compile(
    rf"{_BEFORE}{_VALUE}(?:\s*(?:,|and|or|und|oder)\s*{_VALUE})?|\b{_VALUE}{_AFTER}", re.IGNORECASE
)
_GROUPS = (1, 3, 5)  # numbers; behind each is its unit
_FENCE = re.compile(r"^ {0,3}(`{3,}|~{3,})([^\n]*)$", re.MULTILINE)


class Said(NamedTuple):
    """A tolerance in words."""

    value: Fraction  # in the unit
    unit: str
    slack: Fraction  # how far it may be rounded
    start: int
    end: int


def said(text: str) -> Iterator[Said]:
    """Yield every tolerance that words name."""
    for found in _PHRASE.finditer(text):
        for group in _GROUPS:
            if found[group] is None:
                continue
            unit, by = _unit(found[group + 1].casefold())
            if unit == "points" and not found[0].casefold().startswith("out"):
                continue  # of a part of the mark, not of all of it
            value = Fraction(found[group].replace(",", "."))
            decimals = len(found[group].replace(",", ".").partition(".")[2])
            slack = Fraction(1, 2 * 10**decimals) if unit == "s" and decimals else Fraction(0)
            yield Said(value * by, unit, slack, found.start(group), found.end(group + 1))


def contradictions(
    source: SourceFile, words: str, without: tuple[int, int] | None = None, within: str = ""
) -> Iterator[Diagnostic]:
    """Yield what a teacher's words say otherwise than the task.

    Args:
        source: The text.
        words: What the task says: the part that is written from it.
        without: Start and end of a part of the text that does not count.
        within: What the text is called, if not by the name of its file.
    """
    true: dict[str, set[Fraction]] = {}
    for one in said(words):
        true.setdefault(one.unit, set()).add(one.value)
    fences = _fences(source.text)
    for one in said(source.text):
        if without is not None and without[0] <= one.start < without[1]:
            continue
        if bisect_right(fences, one.start) % 2:
            continue  # in a block of code
        known = true.get(one.unit, set())
        if any(abs(one.value - value) <= one.slack for value in known):
            continue
        listed = ", ".join(number(float(value)) for value in sorted(known))
        saying = f"the task says {listed} {one.unit}" if known else "the task says no such number"
        text = source.text[one.start : one.end]
        yield warning(
            CONTRADICTS,
            f"{within or f'`{source.name}`'} says {text}, and {saying}",
            Label(Span(source, one.start, one.end)),
            help=("write what the task says, or leave the number to the part written from it",),
        )


def _fences(text: str) -> list[int]:
    """Return where blocks of code begin and end, in turn; one that does not end goes to the end."""
    found: list[int] = []
    mark = ""
    for fence in _FENCE.finditer(text):
        if not mark:
            mark = fence[1]
        elif not fence[1].startswith(mark) or fence[2].strip():
            continue  # inside the block
        else:
            mark = ""
        found.append(fence.start())
    return found


def _unit(word: str) -> tuple[str, Fraction]:
    for name, unit in _UNITS.items():
        if word == name:
            return unit
    longest = max((name for name in _UNITS if word.startswith(name)), key=len)
    return _UNITS[longest]
