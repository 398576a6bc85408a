"""Operators and quotes of other languages inside a step, one kind of them at a time."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from vrts.lang.decimal_commas import readings


class Signs(NamedTuple):
    """A kind of sign, and what VAL-II writes for it."""

    pattern: re.Pattern[str]  # what is replaced; strings are hidden from it
    instead: str  # as `re.sub` takes it
    says: str
    help: str
    sure: bool = True  # whether what is written instead is surely meant


DECIMAL = Signs(re.compile(","), ".", "a decimal number has a point", "write the point")
_OPERAND = r"(?:[\w.]+(?:\[[^\[\]]*\]|\([^()]*\))?|\([^()]*\))"

SIGNS = (
    Signs(
        re.compile(r"(?<![\w.,])(\d{1,3})[.'](\d{3}),(\d{1,2})(?![\w.,])"),
        r"\1\2.\3",
        "a number has a decimal point, and no sign between its thousands",
        "write the point alone",
    ),
    Signs(
        re.compile(r"(?<=\d)['_ ](?=\d{3}(?![\d.]))"),
        "",
        "a number has no sign between its thousands",
        "write the digits alone",
    ),
    Signs(re.compile(r"'([^'\"]*)'"), r'"\1"', "text stands between double quotes", 'write `"`'),
    Signs(
        re.compile(r"[ \t]*(?<=[\w)\] \t])%[ \t]*(?=[\w(-])"),
        " MOD ",
        "`%` is not an operator of VAL-II",
        "write `MOD` for the remainder of a division",
    ),
    Signs(
        re.compile(r"(?<=\d)[ \t]*%"),
        "",
        "`%` has no meaning here",
        "leave the percent sign out: SPEED takes percent",
    ),
    Signs(
        re.compile(r"\b0[xX]([0-9A-Fa-f]+)\b"),
        r"^H\1",
        "`0x` begins no number of VAL-II",
        "begin hexadecimal numbers with `^H`, as in `^HFF`",
    ),
    Signs(
        re.compile(r"\b0[bB]([01]+)\b"),
        r"^B\1",
        "`0b` begins no number of VAL-II",
        "begin binary numbers with `^B`, as in `^B1010`",
    ),
    Signs(
        re.compile(r"(?<![\w.^$#])(\d+(?:\.\d*)?)[Oo](?![\w.])"),
        r"\g<1>0",
        "a letter stands in a number",
        "write the digit 0 for the letter O",
    ),
    Signs(
        re.compile(r"(?<![\w.^])(\d+(?:\.\d+)?)(?![eE](?:[-+\d]|\b))([A-Za-z][\w.]*)"),
        r"\1*\2",
        "`*` is missing behind a number",
        "write the `*`: nothing multiplies by itself",
    ),
    Signs(
        re.compile(r"(?<=[\w)\]])[ \t]+\.?lt\.?[ \t]+", re.I),
        " < ",
        "LT is not an operator of VAL-II",
        "write `<`",
    ),
    Signs(
        re.compile(r"(?<=[\w)\]])[ \t]+\.?gt\.?[ \t]+", re.I),
        " > ",
        "GT is not an operator of VAL-II",
        "write `>`",
    ),
    Signs(
        re.compile(r"(?<=[\w)\]])[ \t]+\.?le\.?[ \t]+", re.I),
        " <= ",
        "LE is not an operator of VAL-II",
        "write `<=`",
    ),
    Signs(
        re.compile(r"(?<=[\w)\]])[ \t]+\.?ge\.?[ \t]+", re.I),
        " >= ",
        "GE is not an operator of VAL-II",
        "write `>=`",
    ),
    Signs(
        re.compile(r"\bleft\$[ \t]*\(([^(),]*),[ \t]*([^(),]*)\)", re.I),
        r"$MID(\1, 1, \2)",
        "functions of strings begin with `$`",
        "write `$MID`",
    ),
    Signs(
        re.compile(r"\bstr\$(?=[ \t]*\()", re.I),
        "$ENCODE",
        "functions of strings begin with `$`",
        "write `$ENCODE`",
    ),
    Signs(
        re.compile(r"\b([A-Za-z][\w.]*)\$"),
        r"$\1",
        "`$` stands before the name of a string, not behind",
        "write `$a` instead of `a$`",
    ),
    Signs(
        re.compile(r"(\w\[[^\[\]]*)\][ \t]*\[([^\[\]]*\])"),
        r"\1, \2",
        "subscripts stand in one pair of brackets",
        "write `a[r, c]`",
    ),
    Signs(re.compile(r"\bgo[ \t]+to\b", re.I), "GOTO", "GO TO is one word", "write `GOTO`"),
    Signs(
        re.compile(r"#(?=\d)"),
        "",
        "a number has no `#`",
        "leave `#` out: it begins joint locations",
    ),
    *(
        Signs(
            re.compile(rf"(?<=[\w)\]])[ \t]+(?:{words})[ \t]+(?=[\w(])", re.I),
            sign,
            "sums are written with signs in VAL-II",
            f"write `{sign}`",
        )
        for words, sign in (
            ("plus", "+"),
            ("minus", "-"),
            ("times", "*"),
            ("divided by", "/"),
        )
    ),
    Signs(
        re.compile(r"(?<=[\w)\]])[ \t]+x[ \t]+(?=[\w(])", re.I),
        "*",
        "`x` is no operator: it is a name",
        "write `*` to multiply",
    ),
    Signs(re.compile(r"~="), "<>", "`~=` is not an operator of VAL-II", "write `<>`"),
    Signs(re.compile(r"/="), "<>", "`/=` is not an operator of VAL-II", "write `<>`"),
    Signs(re.compile(r"==="), "==", "`===` is not an operator of VAL-II", "write `==`"),
    Signs(re.compile(r"!=="), "<>", "`!==` is not an operator of VAL-II", "write `<>`"),
    Signs(
        re.compile(r"(?<![\w)\]])!(?!=)[ \t]*"),
        "NOT ",
        "`!` is not an operator of VAL-II",
        "write `NOT`",
    ),
    Signs(re.compile(r"~(?!=)[ \t]*"), "NOT ", "`~` is not an operator of VAL-II", "write `NOT`"),
    Signs(
        re.compile(r"[ \t]*(?<!&)&(?!&)[ \t]*(?=\^[BH]|\d+[ \t]*\))", re.I),
        " BAND ",
        "`&` is not an operator of VAL-II",
        "write `BAND` for the bits of numbers, `AND` for conditions",
    ),
    Signs(
        re.compile(r"(?<=[-=(+*/,<>])([ \t]*)\|([^|]+)\|"),
        r"\1ABS(\2)",
        "`|` is not an operator of VAL-II",
        "write `ABS(x)` for the size of a number",
    ),
    Signs(
        re.compile(r"[ \t]*(?<!\|)\|(?!\|)[ \t]*(?=\^[BH]|\d+[ \t]*(?:\)|$))", re.I),
        " BOR ",
        "`|` is not an operator of VAL-II",
        "write `BOR` for the bits of numbers, `OR` for conditions",
    ),
    Signs(
        re.compile(r'(?<=")[ \t]*&(?!&)[ \t]*|[ \t]*(?<!&)&(?!&)[ \t]*(?=["$])'),
        "+",
        "`&` is not an operator of VAL-II",
        "write `+` to join strings",
    ),
    Signs(
        re.compile(r"[ \t]*(?<!&)&(?!&)[ \t]*"),
        " AND ",
        "`&` is not an operator of VAL-II",
        "write `AND`",
    ),
    Signs(
        re.compile(r"[ \t]*(?<!\|)\|(?!\|)[ \t]*"),
        " OR ",
        "`|` is not an operator of VAL-II",
        "write `OR`",
    ),
    Signs(
        re.compile(rf"({_OPERAND})[ \t]*(?:\^|\*\*)[ \t]*2(?![\d.])"),
        r"SQR(\1)",
        "VAL-II has no power operator",
        "write `SQR(x)` for a square",
    ),
    Signs(
        re.compile(rf"({_OPERAND})[ \t]*(?:\^|\*\*)[ \t]*3(?![\d.])"),
        r"\1*\1*\1",
        "VAL-II has no power operator",
        "multiply: `x*x*x`",
    ),
    Signs(
        re.compile(rf"({_OPERAND})[ \t]*(?:\^|\*\*)[ \t]*0\.5(?!\d)"),
        r"SQRT(\1)",
        "VAL-II has no power operator",
        "write `SQRT(x)` for a square root",
    ),
    Signs(
        re.compile(rf"({_OPERAND})[ \t]*(?://|\\|\bdiv\b)[ \t]*({_OPERAND})", re.I),
        r"INT(\1/\2)",
        "`//`, `\\` and `DIV` are no operators of VAL-II",
        "write `INT(a/b)`",
    ),
    Signs(
        re.compile(r"\bmod[ \t]*\(([^(),]*),[ \t]*([^(),]*)\)", re.I),
        r"\1 MOD \2",
        "MOD is an operator",
        "write `a MOD b`",
    ),
    Signs(
        re.compile(r"(?<=.)\bsig[ \t]*\[([^\[\]]*)\]", re.I),
        r"SIG(\1)",
        "SIG takes parentheses, not brackets",
        "write `SIG(1001)`",
    ),
    Signs(
        re.compile(
            r"\b(?:\$in|di|din|input|digitalread|get_digital_in|in)[ \t]*[\[(]([^\[\]()]*)[\])]",
            re.I,
        ),
        r"SIG(\1)",
        "a signal is asked for by SIG",
        "write `SIG(1001)`",
    ),
    Signs(
        re.compile(r"(?<=.)\bsig(?:nal)?[ \t]+(\d+)", re.I),
        r"SIG(\1)",
        "SIG without parentheses",
        "write `SIG(1001)`",
    ),
    Signs(
        re.compile(r"(?<=.)\bsignal[ \t]*\(([^()]*)\)", re.I),
        r"SIG(\1)",
        "SIGNAL switches, SIG asks",
        "write `SIG(1001)`",
    ),
    Signs(
        re.compile(r"\b(?:is[ \t]+)?(?:greater|bigger|larger|more|above)(?:[ \t]+than)?\b", re.I),
        ">",
        "comparisons are signs in VAL-II",
        "write `>`",
    ),
    Signs(
        re.compile(r"\b(?:is[ \t]+)?(?:less|smaller|lower|below)(?:[ \t]+than)?\b", re.I),
        "<",
        "comparisons are signs in VAL-II",
        "write `<`",
    ),
    Signs(
        re.compile(r"\b(?:is[ \t]+not|isnt|not[ \t]+equal|ne)\b", re.I),
        "<>",
        "comparisons are signs in VAL-II",
        "write `<>`",
    ),
    Signs(
        re.compile(r"\b(?:equals|is|eq)\b", re.I),
        "==",
        "`is`, `equals` and `eq` are no operators: comparisons are signs in VAL-II",
        "write `==`",
    ),
    Signs(
        re.compile(r"\band[ \t]+also\b|\bandalso\b", re.I), "AND", "VAL-II has AND", "write `AND`"
    ),
    Signs(
        re.compile(r"(?<=\d),(?=\d{3}(?![\d.,]))"),
        "",
        "a comma stands in no number",
        "write the digits alone for thousands, and a point for a decimal number",
        sure=False,
    ),
    DECIMAL,
    Signs(re.compile(r"[ \t]*;[ \t]*$"), "", "", "leave it out"),
    Signs(re.compile(r"[ \t]*[{:.,][ \t]*$"), "", "", "leave it out"),
    Signs(re.compile(r"\\"), "/", "`\\` is not an operator of VAL-II", "write `/` to divide"),
)
_STRING = re.compile(r'"[^"]*"')
_COMPOUND_BEGUN = re.compile(r"^[ \t]*(?:here|set|move[st]?|movest|appros?)\b.*:[ \t]*$", re.I)


def replaced(text: str) -> Iterator[tuple[Signs, str]]:
    """Return a step with one kind of foreign signs replaced after the other."""
    strings = _STRING.findall(text)
    hidden = _STRING.sub(_HIDDEN, text)
    if _COMPOUND_BEGUN.search(hidden):
        return  # a name is missing behind the colon
    for signs in SIGNS:
        if signs is DECIMAL:
            yield from decimals(text)
            continue
        found = signs.pattern.sub(signs.instead, hidden)
        if found != hidden:
            yield signs, _shown(found, strings)


def decimals(text: str) -> Iterator[tuple[Signs, str]]:
    """Return a step with points where it may have decimal commas, the likeliest first."""
    for reading in readings(text):
        yield DECIMAL._replace(sure=reading.sure), reading.text


_HIDDEN = '"\0"'


def _shown(text: str, strings: list[str]) -> str:
    following = iter(strings)
    return re.sub('"\0"', lambda _: next(following, '""'), text)
