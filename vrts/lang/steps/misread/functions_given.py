"""`DX(p) = 100`: a value given to what a function yields."""

import re

from vrts.lang.dialect import Dialect
from vrts.lang.steps.misread.meant import VARIABLE, Meant
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.vocabulary.functions import FUNCTIONS

_GIVEN = re.compile(
    r"(?P<name>[$#]?[A-Za-z][\w.]*)[ \t]*\((?P<inner>.*?)\)[ \t]*:?=(?!=)[ \t]*(?P<value>.+)",
    re.ASCII,
)
_INSTRUCTIONS = frozenset({"SIG", "BITS"})  # have words of their own: SIGNAL and BITS
_AXES = ("DX", "DY", "DZ")


def given_function(text: str, dialect: Dialect) -> Meant | None:
    """Return what is meant by a function on the left of `=`."""
    found = _GIVEN.fullmatch(text)
    if found is None:
        return None
    name, inner = found["name"].upper(), found["inner"].strip()
    signature = FUNCTIONS.get(name.lower())
    if signature is None or not dialect.has(signature.dialects) or name in _INSTRUCTIONS:
        return None
    if inner.count("(") != inner.count(")"):
        return None
    return Meant(
        INVALID_EXPRESSION,
        f"{name} is a function: it tells a value, and takes none",
        found.start("name"),
        found.start("value"),
        (_help(name, inner, found["value"].strip()),),
        notes=("VAL-II says *Illegal assignment*",),
    )


def _help(name: str, inner: str, value: str) -> str:
    """Return what to write instead."""
    if name in _AXES and re.fullmatch(VARIABLE, inner, re.ASCII):
        own = re.compile(rf"{name}[ \t]*\([ \t]*{re.escape(inner)}[ \t]*\)[ \t]*", re.IGNORECASE)
        change, changed = own.subn("", value, 1) if own.match(value) else (value, 0)
        if not changed or change[:1] not in ("+", "-"):
            change = f"{value}-{name}({inner})"
        parts = ["0", "0", "0"]
        parts[_AXES.index(name)] = change.lstrip("+ ").replace(" ", "")
        shifted = f"SHIFT({inner} BY {', '.join(parts)})"
        return f"to move a location write `SET {inner} = {shifted}`"
    if name == "TRANS":
        return f"to take a location apart write `DECOMPOSE x[0] = {value}`"
    if name[0] == "$":
        return "give the whole string a value: `$s = ...`"
    return f"an array has a name of its own, and brackets: `a[{inner}] = {value}`"
