"""`mask B_AND 1`, `"NG" in $reply`, `x.^2`: operators of other languages inside a step."""

import re
from collections.abc import Callable
from typing import NamedTuple

from vrts.lang.dialect import Dialect
from vrts.lang.steps.idioms.tables import MOST_CHARACTERS
from vrts.lang.steps.idioms.wording import smallest_change
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.steps.repair import Repair

_STRING = re.compile(r'"[^"]*"')
_TEXT = r'(?:"\x00+"|\.?\$[A-Za-z][\w.]*(?:\[[^\[\]]*\])?)'
_VALUE = r"(?:\.?[A-Za-z][\w.]*(?:\[[^\[\]]*\]|\([^()]*\))?|[-+]?\d[\d.]*)"
_BEFORE = r"(?<=[\w)\]\"])[ \t]+"
_ALL_BITS = 10  # of a shift that is written as a factor


class _Sign(NamedTuple):
    """An operator, and how a step is written with what the dialect has for it."""

    pattern: re.Pattern[str]
    instead: "str | Callable[[re.Match[str], Dialect], str]"
    says: str


def _word(words: str, sign: str, why: str = "") -> _Sign:
    pattern = re.compile(rf"{_BEFORE}(?P<word>{words})[ \t]+(?=[\w(^\".$-])", re.IGNORECASE)
    return _Sign(pattern, f" {sign} ", why or "{w} is no operator of VAL-II")


def _found(match: re.Match[str], dialect: Dialect) -> str:
    """`"a" in $s`, `$s contains "a"`: whether a text stands in another."""
    groups = match.groupdict()
    part = groups.get("part") or groups.get("part2") or ""
    whole = groups.get("whole") or groups.get("whole2") or ""
    place = f"INSTR({whole}, {part})" if dialect.is_as else f"POS({whole}, {part})"
    return f"({place} == 0)" if groups.get("no") else f"({place} > 0)"


def _one_of(match: re.Match[str], _dialect: Dialect) -> str:
    """`x in (1, 2, 3)`: whether a number is one of several."""
    of, values = match["of"], [value.strip() for value in match["values"].split(",")]
    sign, join = ("<>", "AND") if match["no"] else ("==", "OR")
    return "(" + f" {join} ".join(f"({of} {sign} {value})" for value in values) + ")"


def _within(match: re.Match[str], _dialect: Dialect) -> str:
    """`x between 1 and 5`: whether a number lies between two others."""
    of = match["of"]
    return f"({of} >= {match['low']}) AND ({of} <= {match['high']})"


def _in_range(match: re.Match[str], _dialect: Dialect) -> str:
    of = match["of"]
    return f"({of} >= {match['low']}) AND ({of} < {match['high']})"


def _shifted(match: re.Match[str], _dialect: Dialect) -> str:
    """`x << 2`, `x >> 2`: bits shifted."""
    factor = 2 ** int(match["by"]) if int(match["by"]) <= _ALL_BITS else 0
    of = match["of"]
    return f"{of}*{factor}" if match["sign"] == "<<" else f"INT({of}/{factor})"


def _off(match: re.Match[str], _dialect: Dialect) -> str:
    return f"SIG(-{match['signal']})"


_IN_TEXT = "texts are searched by a function: {w} is no operator of VAL-II"
_SIGNS = (
    _Sign(
        re.compile(
            rf"(?P<part>{_TEXT})[ \t]+(?P<no>NOT[ \t]+)?(?P<word>IN)[ \t]+(?P<whole>{_TEXT})"
            rf"|(?P<whole2>{_TEXT})(?:[ \t]+|\.)(?:CONTAINS|HAS|INCLUDES|LIKE|MATCHES)"
            rf"[ \t]*\(?[ \t]*(?P<part2>{_TEXT})\)?",
            re.IGNORECASE,
        ),
        _found,
        _IN_TEXT,
    ),
    _Sign(
        re.compile(
            rf"(?P<of>{_VALUE})[ \t]+(?P<no>NOT[ \t]+)?(?P<word>IN)[ \t]+"
            r"RANGE[ \t]*\((?P<low>[^(),]+),(?P<high>[^(),]+)\)",
            re.IGNORECASE,
        ),
        _in_range,
        "IN is no operator of VAL-II: compare with both ends",
    ),
    _Sign(
        re.compile(
            rf"(?P<of>{_VALUE})[ \t]+(?P<no>NOT[ \t]+)?(?P<word>IN)[ \t]*"
            r"[(\[{](?P<values>[^()\[\]{}]+)[)\]}]",
            re.IGNORECASE,
        ),
        _one_of,
        "IN is no operator of VAL-II: compare with each value",
    ),
    _Sign(
        re.compile(
            rf"(?P<of>{_VALUE})[ \t]+(?P<word>BETWEEN)[ \t]+(?P<low>{_VALUE})[ \t]*"
            rf"(?:AND|TO|,|\.\.)[ \t]*(?P<high>{_VALUE})",
            re.IGNORECASE,
        ),
        _within,
        "BETWEEN is no operator of VAL-II: compare with both ends",
    ),
    _Sign(
        re.compile(rf"(?P<of>{_VALUE})[ \t]*(?P<sign>(?P<word><<|>>))[ \t]*(?P<by>\d+)"),
        _shifted,
        "{w} is no operator of VAL-II: a bit more is twice the number",
    ),
    _Sign(
        re.compile(
            r"(?<![\w.])SIG[ \t]*\((?P<signal>[^(),]+)\)[ \t]+(?:(?:IS|=|==)[ \t]+)?"
            r"(?P<word>OFF|LOW|FALSE)\b",
            re.IGNORECASE,
        ),
        _off,
        "SIG asks whether a signal is on, and with a minus whether it is off",
    ),
    _Sign(
        re.compile(
            r"(?<=\))[ \t]+(?:IS[ \t]+)?(?P<word>ON|HIGH|TRUE|ACTIVE)\b(?![ \t]*[=(])", re.I
        ),
        "",
        "SIG is true by itself while its signal is on: {w} does not belong here",
    ),
    _word("B_AND|BIT_?AND|LAND|BITWISE_AND", "BAND"),
    _word("B_OR|BIT_?OR|LOR|BITWISE_OR", "BOR"),
    _word("B_E?XOR|BIT_?XOR|LXOR|BITWISE_XOR", "BXOR"),
    _word("EXOR|EOR|EXCLUSIVE_OR", "XOR"),
    _word("ANDIF|AND_?ALSO|AND[ \\t]+THEN|UND|ET", "AND"),
    _word("ORIF|OR_?ELSE|OR[ \\t]+ELSE|ODER|OU", "OR"),
    _word("MODULO|MODULUS|REM|REMAINDER", "MOD"),
    _Sign(
        re.compile(r"(?<![\w.])(?P<word>B_NOT|BIT_?NOT)[ \t]+(?=[\w(^.])", re.IGNORECASE),
        "COM ",
        "{w} is no operator of VAL-II",
    ),
    _Sign(
        re.compile(r"(?<=[\w)\] \t])\.(?P<word>AND|OR|NOT|XOR)\.(?=[ \t]*[\w(.])", re.IGNORECASE),
        r" \g<word> ",
        "an operator stands without points, not as in Fortran",
    ),
    _Sign(
        re.compile(r"(?<![\w)\]])\.(?P<word>TRUE|FALSE)\.(?!\w)", re.IGNORECASE),
        r"\g<word>",
        "TRUE and FALSE stand without points",
    ),
    *(
        _Sign(
            re.compile(rf"(?<=[\w)\]])[ \t]*\.(?P<word>{word})\.[ \t]*(?=[\w(.-])", re.IGNORECASE),
            f" {sign} ",
            "comparisons are signs in VAL-II, not as in Fortran",
        )
        for word, sign in (
            ("EQ", "=="),
            ("NE", "<>"),
            ("LT", "<"),
            ("GT", ">"),
            ("LE", "<="),
            ("GE", ">="),
        )
    ),
    _Sign(
        re.compile(r"(?<=[\w)\]])[ \t]*\.(?P<word>)(?=[\^*/](?!\*))"),
        "",
        "a `.` before an operator is MATLAB: leave the point out, VAL-II takes one number each",
    ),
    _Sign(re.compile(r"(?P<word>=!)(?!=)"), "<>", "`=!` is not an operator of VAL-II"),
)


def word_between(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a step that is right with another operator."""
    if len(text) > MOST_CHARACTERS:
        return None
    strings = _STRING.findall(text)
    hidden = _STRING.sub(lambda found: f'"{chr(0) * (len(found.group()) - 2)}"', text)
    for sign in _SIGNS:
        first = sign.pattern.search(hidden)
        if first is None:
            continue
        meant = _replaced(sign, hidden, strings, dialect)
        tried = repair.steps(meant)
        if tried is None:
            continue
        word = f"`{(first['word'] or '').strip()}`" if first["word"] else "it"
        start, end, instead = smallest_change(text, tried.text)
        return Meant(
            INVALID_EXPRESSION,
            sign.says.replace("{w}", word),
            start,
            end,
            (f"write `{tried.text}`",),
            instead,
            sure=True,
            notes=("VAL-II says *Illegal operator*",),
        )
    return None


def _replaced(sign: _Sign, hidden: str, strings: list[str], dialect: Dialect) -> str:
    """Return a text with an operator replaced, and its strings shown again."""
    following = iter(strings)
    shown = "".join(
        next(following) if number % 2 else piece
        for number, piece in enumerate(re.split('("\0*")', hidden))
    )
    if isinstance(sign.instead, str):
        return _by_places(sign.pattern, sign.instead, hidden, shown)
    made: list[str] = []
    at = 0
    for found in sign.pattern.finditer(hidden):
        instead = sign.instead(found, dialect)
        for group in ("part", "part2", "whole", "whole2"):
            if group in found.re.groupindex and found[group] is not None:
                instead = instead.replace(found[group], shown[slice(*found.span(group))], 1)
        made.append(shown[at : found.start()] + instead)
        at = found.end()
    return "".join(made) + shown[at:]


def _by_places(pattern: re.Pattern[str], instead: str, hidden: str, shown: str) -> str:
    made: list[str] = []
    at = 0
    for found in pattern.finditer(hidden):
        made.append(shown[at : found.start()] + found.expand(instead))
        at = found.end()
    return "".join(made) + shown[at:]
