"""`n + 1`, `n + 1 = n`, `n, m = 5`, `count 0`: a variable where a step begins."""

import re

from vrts.lang.dialect import Dialect
from vrts.lang.spelling import near
from vrts.lang.steps.misread.meant import VARIABLE, Meant
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.steps.repair import Repair
from vrts.lang.vocabulary.foreign import FOREIGN
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.lookup import look_up, spellings

_BEGUN = re.compile(rf"(?P<name>{VARIABLE})[ \t]*(?P<rest>.+)", re.ASCII)
_TURNED = re.compile(
    rf"(?P<value>{VARIABLE}[ \t]*[-+*/][^=]*?)[ \t]*=[ \t]*(?P<name>{VARIABLE})", re.ASCII
)
_BOTH = re.compile(
    rf"(?P<names>{VARIABLE}(?:[ \t]*,[ \t]*{VARIABLE})+)[ \t]*=(?!=)[ \t]*(?P<value>[^=,]+)",
    re.ASCII,
)
_NUMBER = re.compile(r"[-+]?[ \t]*(?:\d+(?:\.\d*)?|\.\d+)", re.ASCII)
_STRING = re.compile(r'"[^"]*"')
_NOTES = ("VAL-II says *Illegal expression syntax*",)


def no_step(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a line that begins with a variable and gives it no value."""
    begun = _BEGUN.fullmatch(text)
    if begun is None or _is_word(begun["name"], dialect):
        return None
    both = _BOTH.fullmatch(text)
    if both is not None:
        names = [name.strip() for name in both["names"].split(",")]
        steps = [f"{name} = {both['value'].strip()}" for name in names]
        if repair.at_once("\n".join(steps)) is None:
            return None
        shown = ", ".join(f"`{step}`" for step in steps)
        return Meant(
            INVALID_EXPRESSION,
            "a step gives a value to one variable",
            0,
            len(text),
            (f"write a step for each: {shown}",),
            "\n".join(steps),
            notes=_NOTES,
        )
    turned = _TURNED.fullmatch(text)
    if turned is not None:
        says = "the variable that gets a value stands left of `=`"
        return _told(text, f"{turned['name']} = {turned['value']}", says, repair, sure=True)
    name, rest = begun["name"], begun["rest"].strip()
    if rest[0] in "+-*/" and "=" not in _STRING.sub("", rest):
        doubled = _told(
            text, f"{name} = {name} {rest}", "a sum alone is no step", repair, sure=True
        )
        by_one = f"{name} = {name}{rest}1" if rest in ("+", "-") else ""
        return doubled or (
            _told(text, by_one, "a sum alone is no step", repair, sure=False) if by_one else None
        )
    if len(name) > 1 and look_up(name, dialect).candidates:
        return None  # `DEP 50`
    number = _NUMBER.fullmatch(rest) is not None and rest[0].isdigit()
    if number or _STRING.fullmatch(rest):
        return _told(text, f"{name} = {rest}", "`=` is missing behind the name", repair, sure=False)
    return None


def _is_word(name: str, dialect: Dialect) -> bool:
    """Whether a name is a word of the language or of another, or looks like one."""
    upper = name.upper()
    word = look_up(name, dialect).word
    if upper in FOREIGN or upper in INSTRUCTIONS or word is not None:
        return True
    return len(upper) > 2 and next(iter(near(upper, spellings(dialect))), None) is not None


def _told(text: str, meant: str, says: str, repair: Repair, *, sure: bool) -> Meant | None:
    if repair.at_once(meant) is None:
        return None
    return Meant(
        INVALID_EXPRESSION,
        says,
        0,
        len(text),
        (f"write `{meant}`",),
        meant,
        sure=sure,
        notes=_NOTES,
    )
