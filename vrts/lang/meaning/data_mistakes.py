"""What is wrong with a line of data that gives no value: one message, and an edit where certain."""

import re
from typing import NamedTuple

from vrts.base.diagnostic import Rule
from vrts.lang.problems import Problems, short
from vrts.lang.reading.sections.lines import Line
from vrts.lang.vocabulary.lookup import look_up

INVALID_DATA = Rule("V145", "invalid-data-line")
VALUE_COUNT = Rule("V146", "value-count")

FORMS = {
    "locations": "name X Y Z O A T",
    "reals": "name value",
    "strings": '$name "text"',
}
_NUMBER = r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?"
_NAME = r"[$#]?[A-Za-z][\w.]*(?:[ \t]*\[[^\]]*\])?"
_PLAIN = re.compile(
    rf"{_NAME}(?:[ \t]*=[ \t]*|[ \t]+){_NUMBER}(?:[ \t]*,[ \t]*{_NUMBER}|[ \t]+{_NUMBER})*$",
    re.ASCII,
)
_SAID = re.compile(  # words before the name, and what is written round the values
    rf"(?P<word>[A-Za-z]+[ \t]+(?=[$#]?[A-Za-z]))?(?P<name>{_NAME})[ \t]*"
    rf"(?P<sign>:=|==|->|=|:|,)?[ \t]*(?P<call>#?[A-Za-z]+(?=[ \t]*[(\[]))?[ \t]*"
    rf"(?P<open>[(\[{{])?(?P<values>[^()\[\]{{}}]*)(?P<close>[)\]}}])?[ \t]*[,.]?$",
    re.ASCII,
)
_LETTERED = re.compile(rf"(?P<letter>[A-Za-z])[ \t]*[=:]?[ \t]*(?P<number>{_NUMBER})[ \t,]*")
_UNIT = re.compile(rf"({_NUMBER})[ \t]*(mm|deg|degrees|°)(?![\w.])", re.IGNORECASE)
_OTHER_UNIT = re.compile(rf"{_NUMBER}[ \t]*(cm|m|in|inch|inches|rad)(?![\w.])", re.IGNORECASE)
_NUMBERS = re.compile(rf"[ \t]*{_NUMBER}(?:[ \t]*,[ \t]*{_NUMBER}|[ \t]+{_NUMBER})*[ \t]*,?[ \t]*$")
_MISREAD = re.compile(r"(?<![\w.])[-+]?(?=[\dOoIl.]*\d)(?=[\d.]*[OoIl])[\dOoIl.]+(?![\w.])")
_AS_DIGITS = str.maketrans("OoIl", "0011")
_FORMULA = re.compile(
    r"[\w.)][ \t]*[*/+^][ \t]*[\w.(]|\w[ \t]*-[ \t]+\d|(?<=\d)-\d|[A-Za-z]\w*[ \t]*\("
)
_DASHED = re.compile(r"(?P<name>[$#]?[A-Za-z][\w.]*-\w[\w.]*)[ \t]+(?=[-+.\d])")
_TWO_WORDS = re.compile(r"(?P<name>[$#]?[A-Za-z][\w.]*[ \t]+[A-Za-z][\w.]*)[ \t]+(?=[-+.\d])")
_STEP = re.compile(r"(?P<word>[A-Za-z][\w.]*)[ \t]+[$#A-Za-z]")
_ORDER = "XYZOAT"
ODD_QUOTES = re.compile(
    r"(?P<name>\$[^'’‘`“”„]*?)(?P<quote>['’‘`“”„])(?P<text>[^\"'’‘`“”„]*)['’‘`“”„]$"
)
_WHOLE = re.compile(rf"(?:{_NUMBER}[ \t,]+){{6}}(?=[^\W\d])")  # all values, and a word
_DECIMAL_COMMA = re.compile(r"(?<=\d),(?=\d)")


class _Mistake(NamedTuple):
    headline: str
    help: str
    text: str = ""  # the line as it is meant, where that is certain


def plain(text: str) -> bool:
    """Return whether a line is a name and numbers."""
    return _PLAIN.match(text) is not None


def explain(line: Line, kind: str, problems: Problems) -> bool:
    """Report what stands in a line besides a name and numbers; return whether that was found."""
    for look in (_misread, _unnamed, _dashed, _dressed, _lettered, _units, _step, _formula, _words):
        found = look(line.text, kind, problems)
        if found is not None:
            problems.error(
                INVALID_DATA,
                found.headline,
                line.start,
                line.end,
                help=(found.help,),
                fix=problems.replace(line.start, line.end, found.text) if found.text else None,
            )
            return True
    return False


def _misread(text: str, kind: str, problems: Problems) -> _Mistake | None:
    """`45O`, `1l0`: a letter that looks like a digit."""
    name = re.match(_NAME, text)
    found = _MISREAD.search(text, name.end() if name is not None else 0)
    if found is None or name is None:
        return None
    meant = found.group().translate(_AS_DIGITS)
    mended = text[: found.start()] + meant + text[found.end() :]
    return _Mistake(
        f"`{found.group()}` is not a number: there is a letter in it",
        f"write the number `{meant}`",
        mended if plain(mended) else "",
    )


def _unnamed(text: str, kind: str, problems: Problems) -> _Mistake | None:
    """`450 -120 -250 90 90 0`."""
    if _NUMBERS.match(text) is None:
        return None
    return _Mistake("these values have no name", f"write a name before them: `{FORMS[kind]}`")


def _dressed(text: str, kind: str, problems: Problems) -> _Mistake | None:
    """`SET a = TRANS(1, 2, 3, 90, 90, 0)`, `a: 1 2 3`, `a (1, 2, 3)`, `REAL n = 5`."""
    match = _SAID.match(text)
    if match is None or _NUMBERS.match(match["values"]) is None:
        return None
    values = " ".join(match["values"].replace(",", " ").split())
    mended = f"{match['name']} {values}"
    sign, call, word = match["sign"], match["call"], (match["word"] or "").strip()
    if word and look_up(word, problems.dialect).word is None and word.upper() not in _BEGINNERS:
        return None  # a name with a blank in it
    if word:
        headline = f"a line of data holds a name and numbers, without {word.upper()}"
        help_ = f"leave {word.upper()} out: write `{mended}`"
    elif call:
        headline = f"a line of data holds a name and numbers, without {call.upper()}"
        help_ = f"leave {call.upper()} and the parentheses out: write `{mended}`"
    elif match["open"]:
        headline = f"the values of `{match['name']}` stand without `{match['open']}`"
        help_ = f"leave the parentheses out: write `{mended}`"
    elif sign not in (None, "="):
        headline = f"no `{sign}` stands between a name and its values"
        help_ = f"leave `{sign}` out: write `{mended}`"
    else:
        headline = "the line goes on behind its last value"
        help_ = f"write `{mended}`, without a sign at the end"
    return _Mistake(headline, help_, mended)


_BEGINNERS = frozenset(
    (
        *("LET", "DEF", "DEFINE", "VAR", "CONST", "REAL", "INT", "NUM", "DOUBLE", "FLOAT"),
        *("LOC", "LOCATION", "TRANS", "POSE", "POS", "POINT", "ROBTARGET", "FRAME", "TEACH"),
    )
)


def _lettered(text: str, kind: str, problems: Problems) -> _Mistake | None:
    """`a X=450 Y=-120 Z=-250`."""
    name = re.match(_NAME, text)
    if name is None:
        return None
    rest = text[name.end() :].lstrip(" \t=:{(").rstrip(")}")
    pairs = [(m["letter"].upper(), m["number"]) for m in _LETTERED.finditer(rest)]
    if len(pairs) < 2 or _LETTERED.sub("", rest).strip():
        return None
    letters = "".join(letter for letter, _ in pairs)
    return _Mistake(
        "the values of a location stand without letters",
        f"write only the numbers, in this order: `{FORMS['locations']}`",
        f"{name.group()} {' '.join(number for _, number in pairs)}" if letters == _ORDER else "",
    )


def _units(text: str, kind: str, problems: Problems) -> _Mistake | None:
    """`a 450mm -120mm`: values have no units."""
    mended = _UNIT.sub(r"\1", text)
    if mended != text and plain(mended):
        return _Mistake(
            "values are written without units",
            f"leave the units out, write only the numbers: `{mended}`",
            mended,
        )
    other = _OTHER_UNIT.search(text)
    if other is None:
        return None
    return _Mistake(
        f"values are written without units such as `{other.group(1)}`",
        "write only the numbers: lengths in mm, angles in degrees",
    )


def _dashed(text: str, kind: str, problems: Problems) -> _Mistake | None:
    """`part-two 450 -120`, `part two 450 -120`: what is no name."""
    match = _DASHED.match(text)
    if match is not None:
        joined = match["name"].replace("-", "_")
        return _Mistake(
            f"`{match['name']}` is not a name: it has a `-` in it",
            f"write `{joined}` here and in the program",
        )
    match = _TWO_WORDS.match(text)
    if match is None or look_up(match["name"].split()[0], problems.dialect).word is not None:
        return None
    joined = ".".join(match["name"].split())
    return _Mistake(
        f"`{match['name']}` is not a name: it has a blank in it",
        f"write it as one word, as `{joined}` or `{joined.replace('.', '_')}`",
    )


def _step(text: str, kind: str, problems: Problems) -> _Mistake | None:
    """`MOVE part`: an instruction."""
    match = _STEP.match(text)
    word = look_up(match["word"], problems.dialect).word if match is not None else None
    if word is None or match is None or match["word"].upper() != word.text:
        return None
    return _Mistake(
        f"{word.text} is a step of a program, and this is a section of data",
        f"move it between `.PROGRAM` and its `.END`; a line of data is `{FORMS[kind]}`",
    )


def _formula(text: str, kind: str, problems: Problems) -> _Mistake | None:
    """`pitch 2*25.4`."""
    name = re.match(_NAME, text)
    if name is None or kind == "strings" or _FORMULA.search(text, name.end()) is None:
        return None
    return _Mistake(
        "a line of data holds numbers, not a formula",
        f"write the value itself as a number: `{FORMS[kind]}`",
    )


def _words(text: str, kind: str, problems: Problems) -> _Mistake | None:
    """`mode fast`, `pitch`: what is no number, and nothing at all."""
    match = re.match(rf"(?P<name>{_NAME})[ \t]*=?[ \t]*(?P<rest>.*)$", text, re.ASCII)
    if match is None or '"' in text:
        return None
    if not match["rest"]:
        return _Mistake(
            f"`{match['name']}` has no value here", f"write its value behind it: `{FORMS[kind]}`"
        )
    whole = _WHOLE.match(match["rest"])
    if whole is not None and kind == "locations":
        at = match.start("rest") + whole.end()
        mended = f"{text[:at].rstrip()} ; {text[at:]}"
        return _Mistake(
            "words behind the six values are taken for values",
            f"a remark begins with `;`: write `{mended}`",
            mended,
        )
    odd = next((w for w in re.split(r"[ \t,]+", match["rest"]) if not _NUMBERS.match(w)), None)
    if odd is None:
        return None
    return _Mistake(f"`{short(odd)}` is not a number", f"write `{FORMS[kind]}`, with numbers only")


# --- strings --------------------------------------------------------------------------------------


def explain_string(line: Line, problems: Problems) -> None:
    """Report a line of a .STRINGS section that gives no string its value."""
    text = line.text
    match = re.match(r"(?P<name>[A-Za-z][\w.]*(?:\[[^\]]*\])?)(?P<rest>[ \t]*=?[ \t]*\".*)$", text)
    quotes = text.count('"')
    odd = ODD_QUOTES.match(text)
    fix = ""
    if match is not None and quotes == 2:
        headline = f"`{match['name']}` is not the name of a string: it has no `$`"
        help_ = f"write `${match['name']}`"
        fix = f"${text}"
    elif quotes == 1 and re.match(r'\$[^"]*"', text):
        headline = "this text is not closed: a quote is missing"
        help_ = 'end it with a double quote: `"`'
        fix = text + '"' if not text.endswith('"') else ""
    elif odd is not None:
        headline = f"text stands between double quotes, not between `{odd['quote']}`"
        fix = f'{odd["name"]}"{odd["text"]}"'
        help_ = f"write `{fix}`"
    elif text[:1] == "$" and quotes > 2:
        headline = "there are too many quotes in this line"
        help_ = "write one text between two double quotes; inside it write `'`"
    elif re.match(r"#?[A-Za-z][\w.]*(?:\[[^\]]*\])?[ \t]*=?[ \t]*[-+.\d][-+.\d, \t]*$", text):
        headline = "numbers stand in a section of strings"
        help_ = "write numbers below `.REALS` and locations below `.LOCATIONS`"
    else:
        headline = "a string has a name with `$` and one text"
        help_ = f"write `{FORMS['strings']}`"
    problems.error(
        INVALID_DATA,
        headline,
        line.start,
        line.end,
        help=(help_,),
        fix=problems.replace(line.start, line.end, fix) if fix else None,
    )


# --- how many values ------------------------------------------------------------------------------


def wrong_count(problems: Problems, line: Line, name: str, count: int, kind: str) -> None:
    """Report a location or number with more or fewer values than it takes."""
    right = 1 if kind == "reals" else 6
    commas = len(_DECIMAL_COMMA.findall(line.text))
    if 0 < commas == count - right and ", " not in line.text:
        mended = _DECIMAL_COMMA.sub(".", line.text)
        problems.error(
            VALUE_COUNT,
            f"`{name}` has {count} values: a comma is no decimal sign",
            line.start,
            line.end,
            f"this reads as {count} values",
            help=(f"write a decimal point: `{mended}`",),
            fix=problems.replace(line.start, line.end, mended),
            data={"name": name, "count": count},
        )
        return
    if kind == "reals":
        wanted = "one value"
        help_ = "write one number"
        if count in (3, 6, 12) or name[0] == "#":
            help_ = "a location belongs to a section that begins with `.LOCATIONS`"
    elif name[0] == "#":
        wanted, help_ = "6 joint angles", "write six values: one angle in degrees for each joint"
    else:
        wanted = "6 values: X Y Z in mm, O A T in degrees"
        help_ = "write six values: `X Y Z O A T`"
        if count == 1:
            help_ = "a number belongs to a section that begins with `.REALS`"
    problems.error(
        VALUE_COUNT,
        f"`{name}` has {count} value{'' if count == 1 else 's'}",
        line.start,
        line.end,
        f"it takes {wanted}",
        help=(help_,),
        data={"name": name, "count": count},
    )
