"""Functions that one language of the family has and another has not, and what to write there.

In a template `{a}` is all arguments, `{0}` the first. What takes another number of arguments
than the template names is left to words.
"""

import re
from collections.abc import Sequence

from vrts.lang.dialect import Dialect

_SIMPLE = re.compile(r"[\w.$]+(?:\[[^\[\]]*\]|\([^()]*\))?")
_PLACE = re.compile(r"\{(\d)\}")

_OF_VAL2_AND_VPLUS = {
    "maxval": ("MAX({a})",),
    "minval": ("MIN({a})",),
    "maximum": ("MAX({a})",),
    "minimum": ("MIN({a})",),
    "left": ("$MID({0}, 1, {1})",),
    "$left": ("$MID({0}, 1, {1})",),
    "leftstr": ("$MID({0}, 1, {1})",),
    "right": ("$MID({0}, LEN({0})-{1}+1, {1})",),
    "$right": ("$MID({0}, LEN({0})-{1}+1, {1})",),
    "instr": ("POS({0}, {1})", "POS({1}, {2}, {0})"),
    "offs": ("SHIFT({0} BY {1}, {2}, {3})",),
}
_OF_AS = {
    "max": ("MAXVAL({a})",),
    "min": ("MINVAL({a})",),
    "maximum": ("MAXVAL({a})",),
    "minimum": ("MINVAL({a})",),
    "pos": ("INSTR({0}, {1})", "INSTR({2}, {0}, {1})"),
    "inverse": ("-{0}",),
    "sqr": ("{0}^2",),
    "pow": ("{0}^{1}",),
    "tan": ("SIN({0})/COS({0})",),
    "fract": ("{0}-INT({0})",),
    "left": ("$LEFT({a})",),
    "right": ("$RIGHT({a})",),
    "substr": ("$MID({a})",),
    "substring": ("$MID({a})",),
    "str": ("$ENCODE({a})",),
    "tostring": ("$ENCODE({a})",),
    "num2str": ("$ENCODE({a})",),
    "strlen": ("LEN({a})",),
    "length": ("LEN({a})",),
    "offs": ("SHIFT({0} BY {1}, {2}, {3})",),
    "reltool": ("{0}+TRANS({1}, {2}, {3}, 0, 0, 0)",),
    "identical": ("DISTANCE({0}, {1}) == 0",),
}
_HELP_OF_AS = {  # instead of what VAL-II has
    "sign": "AS has no such function: ask `IF x < 0 THEN`",
    "sgn": "AS has no such function: ask `IF x < 0 THEN`",
    "hypot": "use SQRT(x^2+y^2)",
    "asin": "use ATAN2(x, SQRT(1-x^2))",
    "arcsin": "use ATAN2(x, SQRT(1-x^2))",
    "acos": "use ATAN2(SQRT(1-x^2), x)",
    "arccos": "use ATAN2(SQRT(1-x^2), x)",
    "defined": 'AS asks by the name: `EXISTREAL("n")`, `EXISTTRANS("p")`, `EXISTCHAR("$s")`',
    "outside": "AS has no such function: compare, as in `(x < low) OR (x > high)`",
}


def rewritten(name: str, arguments: Sequence[str], dialect: Dialect) -> str:
    """Return what a dialect has for a call of a function that it lacks; empty where unknown."""
    table = _OF_AS if dialect.is_as else _OF_VAL2_AND_VPLUS
    for template in table.get(name, ()):
        wanted = {int(place) for place in _PLACE.findall(template)}
        if "{a}" not in template and len(arguments) != max(wanted) + 1:
            continue
        if not arguments or not all(arguments):
            continue
        bare = template.startswith(("SIN", "-{", "{")) or "-{1}" in template
        parts = [a if not bare or _SIMPLE.fullmatch(a) else f"({a})" for a in arguments]
        return template.replace("{a}", ", ".join(arguments)).format(*parts)
    return ""


def help_with(name: str, dialect: Dialect) -> str:
    """Return words for a function that a dialect lacks, where VAL-II's would mislead."""
    return _HELP_OF_AS.get(name, "") if dialect.is_as else ""
