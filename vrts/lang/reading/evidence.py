"""What in the text of a file speaks for one language of the family, and against the others.

Each kind of evidence is at home in some languages, by their columns, and costs every other language
its weight. The same word counts at most three times: a slip is no habit, a habit is no proof.
"""

import re
from collections.abc import Iterator
from typing import NamedTuple

from vrts.ir.expressions import Function
from vrts.lang.vocabulary.functions import FUNCTIONS
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

NAMED_LABEL = "labels with a name"
MOST_TIMES = 3  # that one word or sign counts
MOST_TEXT = 40_000  # characters of a file that are looked at: what it is, shows there

DECLARING = frozenset({"AUTO", "GLOBAL", "LOCAL"})  # no slip: VAL-II declares nothing
_QUIET = re.compile(r'"[^"\n]*"|;[^\n]*')
_FIRST_WORDS = re.compile(
    r"^[ \t]*(?:\d+[ \t]+|[A-Za-z]\w*:[ \t]*)?([A-Za-z][\w.]*)(?![\w.:]|[ \t]*[=\[:])",
    re.MULTILINE,
)
_APPLIED = re.compile(r"(?<![\w.$#])([$#]?[A-Za-z][\w.]*)[ \t]*\(")
_NAMES_PROGRAM = re.compile(
    r"^[ \t]*(?:(?:\d+[ \t]+)?CALL[ \t][^\n]*|\.PROGRAM[ \t]+[A-Za-z][\w.]*)",
    re.MULTILINE | re.IGNORECASE,
)


class Evidence(NamedTuple):
    """Something that stands in a text."""

    what: str  # as messages name it
    columns: str  # of the languages in which it is at home
    weight: float
    start: int
    end: int


class _Sign(NamedTuple):
    """A shape that tells languages apart."""

    pattern: re.Pattern[str]
    what: str  # empty: as it is written
    columns: str
    weight: float
    needs: str  # letters without which the pattern is not tried, in upper case


def _sign(pattern: str, columns: str, weight: float, what: str = "", needs: str = "") -> _Sign:
    return _Sign(re.compile(pattern, re.MULTILINE | re.IGNORECASE), what, columns, weight, needs)


_SIGNS = (
    _sign(
        r"^[ \t]*\.(?:TRANS|JOINTS|ROBOTDATA\d*|SYSDATA|AUXDATA|OPE_INFO\d*|INTER_PANEL\w*|NETCONF)"
        r"\b(?=[^=\n]*$)",
        "a",
        6.0,
    ),
    _sign(r"^[ \t]*\.(?:LOCATIONS|DOUBLES)\b(?=[^=\n]*$)", "12+", 3.0),
    _sign(
        r"^[ \t]*\.PROGRAM[ \t]+[\w.]+[ \t]*\([^)\n]*\)[ \t]*(?:@[\d/]+[ \t:\d]*)?#\d+",
        "a",
        4.0,
        "headers with the number of a program",
    ),
    _sign(r"(?<![\w.)\]$#])\.[&@]?[$#]?[a-z]\w*(?=[ \t]*[=\[,+\-*/)])", "a", 3.0),  # .x = 1
    _sign(r"(?<![\w.])[$#]\.[a-z]\w*", "a", 3.0),
    _sign(r"\#\[", "a", 3.0, "joints in `#[...]`", "#["),
    _sign(r"(?<=[\w.)\] \t])(?:MM|CM|DEG)/(?:S|MIN)\b", "a", 3.0, "", "/"),
    _sign(r"^[ \t]*(?:CP|REP_ONCE|QTOOL|[a-z]+\.[\w.]+)[ \t]+O(?:N|FF)[ \t]*$", "a", 2.0),
    _sign(r"(?<=[(,])[ \t]*&[a-z]", "a", 3.0, "locations as `&name`", "&"),
    _sign(r"^[ \t]*FN\d+[ \t]*\[", "a", 4.0, "FN words", "FN"),
    _sign(r"[ \t]ACCU\d+[ \t]+TIMER\d", "a", 6.0, "block steps", " ACCU"),
    _sign(r"^[ \t]*(?:TYPE|PRINT|PCEXECUTE|PCABORT|PCEND)[ \t]+\w+:", "a", 3.0, "`PRINT 2:`"),
    _sign(r"\bGOTO[ \t]+[a-z]", "a", 2.0, NAMED_LABEL, "GOTO"),
    _sign(r"^[ \t]*\.PROGRAM[ \t]+[\w.]+[ \t]*\([ \t]*\)", "+a", 0.5, "empty parentheses"),
    _sign(
        r"\bIF[ \t][^\n]*?[ \t](?:EQ|NE|LT|GT|LE|GE)[ \t][^\n]*\bTHEN[ \t]+\d",
        "1",
        4.0,
        "",
        "THEN ",
    ),
    _sign(r"\bSPEED[ \t][^\n]*\bMONITOR\b", "+", 3.0, "SPEED ... MONITOR", "MONITOR"),
    _sign(r"(?<=[\w)\]])[ \t]*:[ \t]*(?=[a-z#(])(?!=)", "12+", 1.0, "compounds with `:`", ":"),
    _sign(r"(?<=[\w)\]])[ \t]*\+[ \t]*(?:TRANS|R[XYZ])[ \t]*\(", "a", 3.0, "`+ TRANS(...)`", "+"),
    _sign(r"^[ \t]*(?:SET|MOVES?|APPROS?|DEPARTS?)[ \t]+[a-z#]", "12+", 1.0, "MOVE and SET"),
)


def evidence(text: str) -> Iterator[Evidence]:
    """Yield what a text tells of its language, each kind at most three times."""
    quiet = _QUIET.sub(lambda match: " " * len(match.group()), text[:MOST_TEXT])
    upper = quiet.upper()
    yield from _words(quiet)
    yield from _functions(quiet)
    for sign in _SIGNS:
        if sign.needs not in upper:
            continue
        for times, match in enumerate(sign.pattern.finditer(quiet)):
            if times >= MOST_TIMES:
                break
            if sign.what == NAMED_LABEL and _is_assigned(quiet, match.end() - 1):
                continue  # `GOTO k` of who takes a variable for a label
            written = " ".join(match.group().split()).upper()
            yield Evidence(
                sign.what or written, sign.columns, sign.weight, match.start(), match.end()
            )


def _is_assigned(text: str, at: int) -> bool:
    """Whether the name at an offset is given a value anywhere."""
    name = re.match(r"[\w.]+", text[at:])
    assigned = rf"^[ \t]*(?:\d+[ \t]+)?{re.escape(name.group() if name else '')}[ \t]*=(?!=)"
    return re.search(assigned, text, re.MULTILINE | re.IGNORECASE) is not None


def _words(text: str) -> Iterator[Evidence]:
    times: dict[str, int] = {}
    for match in _FIRST_WORDS.finditer(text):
        upper = match.group(1).upper()
        word = INSTRUCTIONS.get(upper)
        if word is None:
            continue
        times[upper] = times.get(upper, 0) + 1
        if times[upper] <= MOST_TIMES:
            weight = 2.0 if upper in DECLARING else 1.0
            yield Evidence(word.text, word.dialects, weight, match.start(1), match.end(1))


def _functions(text: str) -> Iterator[Evidence]:
    text = _NAMES_PROGRAM.sub(lambda match: " " * len(match.group()), text)  # names of programs
    times: dict[str, int] = {}
    for match in _APPLIED.finditer(text):
        lower = match.group(1).lower()
        signature = FUNCTIONS.get(lower)
        if signature is None:
            continue
        times[lower] = times.get(lower, 0) + 1
        if times[lower] <= MOST_TIMES:
            columns = signature.dialects
            if signature.function is not Function.OPAQUE and "+" in columns:
                columns += "2"  # V+ speaks for VAL-II
            yield Evidence(signature.name.upper(), columns, 1.0, match.start(1), match.end(1))
