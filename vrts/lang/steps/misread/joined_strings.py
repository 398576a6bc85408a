"""`$s = "Hello " & $n`: `&` between strings, which `+` joins."""

import re

from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.repair import Repair

_OPERAND = r'(?:"[^"]*"|[$#]?[A-Za-z][\w.]*(?:\[[^\[\]]*\]|\([^()]*\))?|\d[\d.]*)'
_JOINED = re.compile(rf"{_OPERAND}(?:[ \t]*&[ \t]*{_OPERAND})+", re.ASCII)
_SIGN = re.compile(r'"[^"]*"|[ \t]*&[ \t]*')
_LISTS = re.compile(r"TYPE\b", re.IGNORECASE)  # there a comma does


def joined_strings(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by `&` with a string on one of its sides."""
    if "&" not in text or _LISTS.match(text):
        return None
    for found in _JOINED.finditer(text):
        operands = _operands(found.group())
        strings = [operand[0] in '"$' for operand in operands]
        if not any(strings):
            continue
        instead = "+".join(
            operand if is_string else f"$ENCODE({operand})"
            for operand, is_string in zip(operands, strings, strict=True)
        )
        step = text[: found.start()] + instead + text[found.end() :]
        tried = repair.steps(step)
        if tried is None:
            return None
        help_ = f"write `{tried.text}`"
        if not all(strings):
            help_ += ": $ENCODE turns a number into a string"
        return Meant(
            UNEXPECTED_TEXT,
            "strings are joined by `+`, not by `&`",
            found.start(),
            found.end(),
            (help_,),
            instead,
            sure=all(strings),
            notes=("VAL-II says *Illegal operator*",),
        )
    return None


def _operands(text: str) -> list[str]:
    """Return what stands between the signs, outside of strings."""
    operands: list[str] = []
    begin = 0
    for sign in _SIGN.finditer(text):
        if sign.group()[0] != '"':
            operands.append(text[begin : sign.start()].strip())
            begin = sign.end()
    operands.append(text[begin:].strip())
    return operands
