"""`JMOVE # park`, `$ name`, `0..5`: a blank within a name, or a sign of a number twice."""

import re

from vrts.base.diagnostic import Rule
from vrts.lang.reading.odd_signs import INVALID_NAME
from vrts.lang.steps.idioms.tables import MOST_CHARACTERS
from vrts.lang.steps.idioms.wording import smallest_change
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.steps.repair import Repair

_STRING = re.compile(r'"[^"]*"?')
_PARTED = re.compile(r"(?P<sign>[$#@])[ \t]+(?=[A-Za-z.])")
_DOTTED = re.compile(r"(?<![\w)\]])(?P<sign>\.)[ \t]+(?=[$#]?[A-Za-z])")  # a local name of AS
_POINTS = re.compile(r"(?<=\d)\.\.+(?=\d)(?![^\[]*\])")  # and no range of an array
_NUMBER_APART = re.compile(r"(?<=\d)[ \t]+\.(?=\d)|(?<=\d\.)[ \t]+(?=\d)")
_RANGED = re.compile(r"(?:VALUE|FOR|CASE)\b", re.IGNORECASE)
_KINDS = {"$": "a string", "#": "a precision point", "@": "a timer", ".": "a local variable"}


def parted_name(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a step with a blank between a sign and its name."""
    for pattern in (_PARTED, _DOTTED):
        found = pattern.search(_hidden(text))
        if found is None:
            continue
        sign = found["sign"]
        meant = _replaced(pattern, sign, text)
        says = f"the name of {_KINDS[sign]} begins with `{sign}`, without a blank behind it"
        told = _told(text, meant, says, INVALID_NAME, repair)
        if told is not None:
            return told
    return None


def odd_points(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a step with two points in a number, or a blank beside its point."""
    if _RANGED.match(text) is not None:
        return None  # `VALUE 2..4:`
    for pattern in (_POINTS, _NUMBER_APART):
        if pattern.search(_hidden(text)) is None:
            continue
        meant = _replaced(pattern, ".", text)
        says = "a number has one decimal point, and no blank beside it"
        told = _told(text, meant, says, INVALID_EXPRESSION, repair)
        if told is not None:
            return told
    return None


def _told(text: str, meant: str, says: str, rule: Rule, repair: Repair) -> Meant | None:
    tried = repair.steps(meant) if len(text) <= MOST_CHARACTERS else None
    if tried is None:
        return None
    start, end, instead = smallest_change(text, tried.text)
    return Meant(
        rule,
        says,
        start,
        end,
        (f"write `{tried.text}`",),
        instead,
        sure=True,
        notes=("VAL-II says *Illegal expression syntax*",),
    )


def _hidden(text: str) -> str:
    """Return a text with its strings hidden, as long as it was."""
    return _STRING.sub(lambda found: '"' * len(found.group()), text)


def _replaced(pattern: re.Pattern[str], instead: str, text: str) -> str:
    made: list[str] = []
    at = 0
    for found in pattern.finditer(_hidden(text)):
        made.append(text[at : found.start()] + instead)
        at = found.end()
    return "".join(made) + text[at:]
