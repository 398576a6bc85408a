"""Tolerances that a teacher's own words name, held against those of the task.

Words are read as far as a number with a unit follows a word for a tolerance: "within 10 mm",
"± 5 degrees", "no longer than 12 s", "out of 20 points", also in German. A number is held against
those of the things that its sentence names. Blocks of code and comments are left out, and so is
what is likely to be about something else, such as "opens at most 80 mm".
"""

import re
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from vrts.assignments.handed.facts import Fact
from vrts.assignments.handed.markdown import blocks, within
from vrts.assignments.handed.words import number
from vrts.base.diagnostic import Diagnostic, Label, Rule, warning
from vrts.base.source import SourceFile, Span
from vrts.base.written_numbers import Doubtful, read_number

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
_MOST = r"at\smost|(?:no|not)\s(?:more|longer)\sthan|höchstens|maximal|nicht\s(?:mehr|länger)\sals"
_NEAR = (
    r"within(?:\sa\sradius\sof)?|tolerances?(?:\s(?:of|is)|\s?[:=])?|accuracy\sof|accurate\sto|"
    r"precise\sto|(?:no|not)\s(?:farther|further)\sthan|innerhalb(?:\svon)?|im\sumkreis\svon|"
    r"toleranz(?:\svon|\s?[:=])?|genauigkeit\svon"
)
_BEFORE = (
    rf"(?:\b(?:(?P<most>{_MOST})|(?P<total>out\sof)|{_NEAR})|±|\+/-)"
    r"\s*(?:(?:about|circa|ca\.|etwa)\s)?[*_]{0,2}"
)
_AFTER = (
    r"(?=[*_]{0,2}\s(?:tolerance|accuracy|toleranz|genau\b|"
    r"(?P<less>or\sless|at\smost|oder\sweniger)))"
)


def _value(nth: int) -> str:
    return (
        rf"(?P<value{nth}>\d{{1,6}}(?:[.,]\d{{1,6}}){{0,2}})[\s-]?(?P<unit{nth}>mm|cm|"
        r"millimet(?:re|er)s?n?|deg(?:rees?)?|°|grad|s|sec|seconds?|sekunden?|points?|punkten?|"
        r"punkte)(?![\w/²])"
    )


_PHRASE = re.compile(
    rf"{_BEFORE}{_value(1)}(?:\s*(?:,|and|or|und|oder)\s*{_value(2)})?|\b{_value(3)}{_AFTER}",
    re.IGNORECASE,
)
_END = re.compile(r"[.!?;]\s|\n\s*\n|\n[ \t]*(?:[-*+|#>]|\d+[.)]\s)")  # of a sentence
REACH = 300  # characters of a sentence before and behind a number
FARTHEST = Fraction(200)  # [mm] what is longer is a distance, and no tolerance

_PROGRAM = re.compile(r"\b(?:program|run|task|bonus|solution|programm|lauf|lösung)", re.IGNORECASE)
_OTHER = re.compile(  # that takes time
    r"\b(?:hands?|grippers?|fingers?|open|close|signals?|outputs?|wait|delay|greifer|öffne|schließ|"
    r"warte)",
    re.IGNORECASE,
)
_ONE = r"(?:the|an?|each|every|its|this|that|der|die|das|dem|den|jeder?|jedes)\s+[*_`]{0,2}"


class Said(NamedTuple):
    """A tolerance in words."""

    values: tuple[Fraction, ...]  # in the unit; two where 1,000 may be a thousand or not
    unit: str
    slack: Fraction  # how far it may be rounded
    start: int
    end: int
    most: bool  # whether it is a bound such as "at most"


def said(text: str) -> Iterator[Said]:
    """Yield every tolerance that words name."""
    for found in _PHRASE.finditer(text):
        most = found["most"] is not None or found["less"] is not None
        for nth in "123":
            written = found[f"value{nth}"]
            if written is None:
                continue
            unit, by = _unit(found[f"unit{nth}"].casefold())
            if (unit == "points") != (found["total"] is not None):
                continue  # of a part of the mark, not of all of it
            decimals = len(re.split("[.,]", written)[-1]) if re.search("[.,]", written) else 0
            slack = Fraction(1, 2 * 10**decimals) if unit == "s" and decimals else Fraction(0)
            values = tuple(value * by for value in _readings(written))
            yield Said(
                values, unit, slack, found.start(f"value{nth}"), found.end(f"unit{nth}"), most
            )


def _readings(written: str) -> tuple[Fraction, ...]:
    try:
        value = read_number(written, doubtful=",.")
    except Doubtful as both:
        return both.values
    return () if value is None else (value,)


def contradictions(
    source: SourceFile,
    facts: Sequence[Fact],
    without: tuple[int, int] | None = None,
    called: str = "",
) -> Iterator[Diagnostic]:
    """Yield what a teacher's words say otherwise than the task.

    Args:
        source: The text.
        facts: The numbers of the task.
        without: Start and end of a part of the text that does not count.
        called: What the text is called, if not by the name of its file.
    """
    text = source.text
    read, names = blocks(text), _Names(facts, text)
    for one in said(text):
        if without is not None and without[0] <= one.start < without[1]:
            continue
        if within(read.code, one.start) or within(read.comments, one.start):
            continue
        start, end = _sentence(text, one)
        if _of_something_else(one, text[start:end]):
            continue
        known = names.known(one.unit, start, end)
        if any(abs(value - fact) <= one.slack for value in one.values for fact in known):
            continue
        listed = ", ".join(number(float(value)) for value in sorted(known))
        saying = f"the task says {listed} {one.unit}" if known else "the task says no such number"
        yield warning(
            CONTRADICTS,
            f"{called or f'`{source.name}`'} says {text[one.start : one.end]}, and {saying}",
            Label(Span(source, one.start, one.end)),
            help=("write what the task says, or leave the number to the part written from it",),
        )


def _sentence(text: str, one: Said) -> tuple[int, int]:
    """Return start and end of the sentence, line of a table or of a list that a number is in."""
    first = max(0, one.start - REACH)
    before = [found.end() for found in _END.finditer(text, first, one.start)]
    behind = _END.search(text, one.end, one.end + REACH)
    end = min(len(text), one.end + REACH) if behind is None else behind.start()
    return (before[-1] if before else first), end


def _of_something_else(one: Said, sentence: str) -> bool:
    """Return whether a number is likely to be no tolerance and no time of a program."""
    match one.unit:
        case "mm":
            return one.most or any(value > FARTHEST for value in one.values)
        case "s":
            whole = one.most or _PROGRAM.search(sentence) is not None
            return not whole or _OTHER.search(sentence) is not None
        case _:
            return not one.values


class _Names:
    """Where a text names the things that numbers of a task are of."""

    def __init__(self, facts: Sequence[Fact], text: str) -> None:
        self.facts = facts
        self.of: dict[str, list[Fact]] = {}
        shared: dict[str, list[Fact]] = {}  # by a name without its number: "base" of "base1"
        for fact in facts:
            for name in (name.casefold() for name in fact.of):
                self.of.setdefault(name, []).append(fact)
                if name != (stem := name.rstrip("0123456789")) and stem:
                    shared.setdefault(stem, []).append(fact)
        self.starts: list[int] = []
        self.found: list[list[Fact]] = []
        if not self.of:
            return
        exact, stems = _either(self.of), _either(shared)
        pattern = rf"(?<![^\W_])(?:(?P<exact>{exact})"
        if shared:
            pattern += rf"|{_ONE}(?P<one>{stems})|(?P<many>{stems})s"
        for named in re.finditer(rf"{pattern})(?![^\W_])", text, re.IGNORECASE):
            name, stem = named["exact"], None
            if shared:
                stem = named["one"] or named["many"]
            self.starts.append(named.start())
            self.found.append(self.of[name.casefold()] if name else shared[(stem or "").casefold()])

    def known(self, unit: str, start: int, end: int) -> set[Fraction]:
        """Return the numbers of what is named between two places of the text, else of the task."""
        inside = slice(bisect_left(self.starts, start), bisect_left(self.starts, end))
        named = {fact.value for group in self.found[inside] for fact in group if fact.unit == unit}
        return named or {fact.value for fact in self.facts if fact.unit == unit}


def _either(names: dict[str, list[Fact]]) -> str:
    return "|".join(re.escape(name) for name in sorted(names, key=len, reverse=True))


def _unit(word: str) -> tuple[str, Fraction]:
    for name, unit in _UNITS.items():
        if word == name:
            return unit
    longest = max((name for name in _UNITS if word.startswith(name)), key=len)
    return _UNITS[longest]
