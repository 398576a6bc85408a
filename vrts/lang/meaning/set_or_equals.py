"""A value given in the way of another kind: SET for numbers, `=` behind HERE and TOOL."""

from vrts.ir.values import Type
from vrts.lang.meaning.forms import is_text
from vrts.lang.meaning.type_mistakes import RESERVED_NAME, TYPES_SAY, WRONG_TYPE
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    Expression,
    Infix,
    Name,
    Number,
    Parenthesised,
    Prefix,
    Variable,
)
from vrts.lang.syntax.statements import Assignment, SetLocation
from vrts.lang.vocabulary.functions import CONSTANTS, Signature

_SAYS = "VAL-II says *Illegal assignment*"
_COMPARED = frozenset({"==", "<>", "<", "<=", ">", ">="})
_NUMERIC = frozenset({"*", "/", "MOD", "AND", "OR", "XOR", "BAND", "BOR", "BXOR"}) | _COMPARED


def is_number(node: Expression, functions: dict[str, Signature]) -> bool:
    """Return whether an expression is a number by its form alone."""
    while isinstance(node, Parenthesised):
        node = node.inner
    if isinstance(node, Infix):
        if node.operator in _NUMERIC:
            return True
        sides = (node.left, node.right)
        return node.operator in "+-" and all(is_number(side, functions) for side in sides)
    if isinstance(node, Application):
        signature = functions.get(node.name.text.lower())
        return signature is not None and signature.result is Type.REAL
    if isinstance(node, Name):
        return node.text.lower() in CONSTANTS
    return isinstance(node, Number | Prefix)


def _adds_to_itself(target: Variable, node: Expression, functions: dict[str, Signature]) -> bool:
    """Return whether a sum is of the target and a number: `n + 1` for `n`."""
    if not isinstance(node, Infix) or node.operator not in "+-":
        return False
    name = node.left.name if isinstance(node.left, Element) else node.left
    own = target.name if isinstance(target, Element) else target
    same = isinstance(name, Name) and key(name.text) == key(own.text)
    return same and is_number(node.right, functions)


def set_of_no_location(
    problems: Problems, node: SetLocation, functions: dict[str, Signature]
) -> bool:
    """Report `SET n = 5` and `SET $s = "text"`; return whether it is one."""
    target = node.target.name if isinstance(node.target, Element) else node.target
    if target.text[0] == "#":
        return False
    text = target.text[0] == "$" or is_text(node.value)
    number = is_number(node.value, functions)
    if problems.dialect.is_as:  # where `+` and `-` join locations
        number = isinstance(node.value, Number)
        if not text and not number:
            return False
    if not text and not number and not _adds_to_itself(node.target, node.value, functions):
        return False
    what = "a string" if text else "a number"
    plain = problems.source.text[node.target.start : node.end]
    sign = "$" if text and target.text[0] != "$" else ""
    word = problems.source.text[node.start : node.target.start].strip().upper()
    word = "POINT" if problems.dialect.is_as else "SET" if not word.isalpha() else word
    helps = [f"{what} is given a value by `=`, without {word}", f"write `{sign}{plain}`"]
    if not text and isinstance(node.value, Number):
        helps.append("a location is made of numbers by `TRANS(x, y, z, o, a, t)`")
    problems.error(
        WRONG_TYPE,
        f"{word} gives a value to a location, not {what}",
        node.value.start,
        node.value.end,
        f"this is {what}",
        notes=(TYPES_SAY,),
        help=tuple(helps),
        fix=problems.replace(node.start, node.target.start, sign),
    )
    return True


def equals_behind_word(problems: Problems, node: Assignment) -> bool:
    """Report `HERE = start` and `TOOL = grip`, instructions with `=`; return whether it is one."""
    name = node.target
    if not isinstance(name, Name) or name.text.upper() not in ("HERE", "TOOL"):
        return False
    if name.text.upper() == "HERE" and not isinstance(node.value, Name | Element):
        return False
    word = name.text.upper()
    value = problems.source.text[node.value.start : node.value.end]
    headline = f"{word} takes no `=`"
    if word == "HERE":
        headline = "HERE gives the place of the arm to a location, and takes no `=`"
    problems.error(
        RESERVED_NAME,
        headline,
        node.start,
        node.value.start,
        notes=(_SAYS,),
        help=(f"write `{word} {value}`",),
        fix=problems.replace(node.start, node.value.start, f"{word} "),
    )
    return True
