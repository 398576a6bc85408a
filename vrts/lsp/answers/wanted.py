"""Which kinds of value the place of a cursor takes, by the tables that the compiler uses."""

import re
from collections.abc import Mapping

from vrts.ir.values import Type
from vrts.lang.vocabulary.functions import FUNCTIONS, Signature
from vrts.lsp.documents.asking import Asked, OpenCall

REALS = frozenset({Type.REAL})
LOCATIONS = frozenset({Type.POSE, Type.JOINTS})
VALUES = frozenset({Type.REAL, Type.STRING})
ANYTHING = frozenset(Type)
_OPERANDS: Mapping[str, frozenset[Type]] = {  # all others are numbers
    "a location": LOCATIONS,
    "the location to set": LOCATIONS,
    "a string": frozenset({Type.STRING}),
    "a text": frozenset({Type.STRING}),
    "a string variable": frozenset({Type.STRING}),
    "a condition": VALUES,  # of strings that are compared, too
    "an expression": VALUES,
    "a value": VALUES,
}
_PARAMETERS: Mapping[str, frozenset[Type]] = {
    "r": REALS,
    "s": frozenset({Type.STRING}),
    "$": frozenset({Type.STRING}),
    "p": frozenset({Type.POSE}),
    "l": LOCATIONS,
}
_VALUES_OF: Mapping[str, frozenset[Type]] = {  # of instructions, after `=`
    "SET": LOCATIONS,
    "DECOMPOSE": LOCATIONS,
    "INVERSE": frozenset({Type.POSE}),
    "FRAME": frozenset({Type.POSE}),
}
_ANY = frozenset({"TYPE", "PROMPT", "WRITE", "READ", "CALL", "AUTO", "LOCAL", "GLOBAL"})
_BY = re.compile(r"\bBY\b", re.IGNORECASE)
_TARGET = re.compile(r"\s*([$#]?)[A-Za-z][\w.]*[^=]*=(?!=)", re.ASCII)


def wanted(asked: Asked) -> frozenset[Type]:
    """Return the types of value that may stand where a cursor is."""
    before = asked.before[: len(asked.before) - len(asked.prefix)]
    if before.rstrip().endswith(":"):
        return frozenset({Type.POSE})
    if _in_index(before):
        return REALS
    call = asked.call
    if call is not None:
        function = FUNCTIONS.get(call.name.lower())
        if function is None or not function.parameters:
            return ANYTHING  # arguments of a program of somebody's
        number = min(argument_of(call, function), len(function.parameters) - 1)
        return _PARAMETERS.get(function.parameters[number][0], ANYTHING)
    word = asked.word
    if word is None:
        target = _TARGET.match(before)
        signs = {"$": frozenset({Type.STRING}), "#": frozenset({Type.JOINTS})}
        return signs.get(target[1], REALS) if target is not None else ANYTHING
    name = word.canonical
    if name in _VALUES_OF and "=" in before:
        return _VALUES_OF[name]
    if "=" in before.replace("==", "") and name not in ("IF", "WHILE", "UNTIL", "WAIT"):
        return REALS
    if _BY.search(before):
        return REALS  # SHIFT location BY dx, dy, dz
    if name in _ANY or not word.operands:
        return VALUES if name in ("TYPE", "PROMPT", "WRITE") else ANYTHING
    if asked.operand >= len(word.operands) and name != "REACT":
        return _OPERANDS.get(word.operands[-1], REALS)
    if name == "TOOL":
        return frozenset({Type.POSE})
    return _OPERANDS.get(word.operands[min(asked.operand, len(word.operands) - 1)], REALS)


def takes_signals(asked: Asked) -> bool:
    """Return whether a signal may stand where a cursor is."""
    if asked.call is not None:
        name = asked.call.name.upper()
        return name == "SIG" or (name == "BITS" and asked.call.argument == 0)
    word = asked.word
    if word is None or not word.operands or "=" in asked.before:
        return False
    told = word.operands[min(asked.operand, len(word.operands) - 1)]
    several = len(word.operands) == 1 and word.terminal == "WORDITEMS"
    return "signal" in told and "number of signals" not in told and (several or not asked.operand)


def argument_of(call: OpenCall, function: Signature) -> int:
    """Return which argument of a function a cursor stands in, from 0; BY parts some."""
    if function.by is None:
        return call.argument
    after = _BY.split(call.inside)
    if len(after) == 1:
        return min(call.argument, function.by - 1)
    return function.by + after[-1].count(",")


def _in_index(before: str) -> bool:
    """Return whether the innermost bracket that is open is one of an index."""
    open_: list[str] = []
    quoted = False
    for sign in before:
        quoted ^= sign == '"'
        if quoted:
            continue
        if sign in "([":
            open_.append(sign)
        elif sign in ")]" and open_:
            open_.pop()
    return bool(open_) and open_[-1] == "["
