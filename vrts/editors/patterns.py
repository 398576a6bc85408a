"""The shapes of VAL-II that a highlighter tells apart, as regular expressions in order.

Both the Pygments lexer and the TextMate grammar are made of this list; the first that matches
wins. Case does not count, and `^` and `$` are the ends of a line. Only constructs are used that
Python's `re` and Oniguruma read alike.
"""

from collections.abc import Iterable
from typing import NamedTuple

from vrts.lang.vocabulary.functions import CONSTANTS, FUNCTIONS
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.lookup import look_up
from vrts.lang.vocabulary.word import Word
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS


class Pattern(NamedTuple):
    """One shape; `parts` names the groups of the expression, or the whole when there are none."""

    expression: str
    parts: tuple[str, ...]


_BEFORE = r"(?<![\w.$#])"
_AFTER = r"(?![\w.])"
_INDEX = r"\[(?:[^\[\]\n]|\[[^\[\]\n]*\])*\]"  # may hold an element of another array
_NOT_ASSIGNED = rf"(?![\w.]|[ \t]*=(?!=)|[ \t]*{_INDEX}[ \t]*=(?!=))"
_NAME = r"[A-Za-z][\w.]*"
LABEL = r"^([ \t]*\d+)?([ \t]*)"  # before the first word of a line


def _any(words: Iterable[str]) -> str:
    """Return words as alternatives, longest first."""
    ordered = sorted({word.upper() for word in words}, key=lambda word: (-len(word), word))
    escaped = (word.replace(".", r"\.").replace("$", r"\$") for word in ordered)
    return f"(?:{'|'.join(escaped)})"


def _spellings(words: Iterable[Word]) -> list[str]:
    """Return words and what VAL-II takes for them."""
    return [
        word.text[:length]
        for word in words
        for length in range(1, len(word.text) + 1)
        if length == len(word.text) or (word.in_val2 and look_up(word.text[:length]).word is word)
    ]


def patterns() -> tuple[Pattern, ...]:
    """Return all shapes in order."""
    flow = [w for w in INSTRUCTIONS.values() if w.terminal in _STRUCTURE or w.text in _FLOW]
    structure = _spellings(flow)
    others = _spellings(w for w in INSTRUCTIONS.values() if w not in flow)
    called = [name for name, signature in FUNCTIONS.items() if signature.parameters]
    bare = [name for name, signature in FUNCTIONS.items() if signature.bare]
    inner = ["THEN", "DO", "OF", "TO", "STEP", "GOTO"]
    qualifiers = QUALIFIERS.keys() - set(inner)
    return (
        Pattern(r";[^\n]*", ("comment",)),
        Pattern(
            r"^[ \t]*\.(?:PROGRAM|END|LOCATIONS|REALS|STRINGS|DOUBLES|TRANS|JOINTS)\b", ("section",)
        ),
        Pattern(r'"[^"\n]*"?', ("string",)),
        Pattern(rf"{LABEL}({_any(structure)}){_NOT_ASSIGNED}", ("label", "blank", "structure")),
        Pattern(rf"{LABEL}({_any(others)}){_NOT_ASSIGNED}", ("label", "blank", "instruction")),
        Pattern(r"^[ \t]*\d+(?=[ \t;]|$)", ("label",)),
        Pattern(r"'[^\n]", ("character",)),
        Pattern(r"\^(?:H[0-9A-F]+|B[01]+|[0-7]+)\b", ("number",)),
        Pattern(r"(?<=[,( \t])/[A-Z]\d*(?:\.\d+)?(?=[ \t]*(?:[,);]|$))", ("format",)),
        Pattern(r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:E[-+]?\d+)?", ("number",)),
        Pattern(rf"(?<![\w.]){_any(called)}(?=[ \t]*\()", ("function",)),
        Pattern(rf"(?<![\w.]){_any(bare)}{_NOT_ASSIGNED}", ("function",)),
        Pattern(rf"{_BEFORE}{_any(CONSTANTS)}{_AFTER}", ("constant",)),
        Pattern(rf"{_BEFORE}{_any(OPERATORS)}{_AFTER}", ("word operator",)),
        Pattern(rf"{_BEFORE}{_any(inner)}{_NOT_ASSIGNED}", ("structure",)),
        Pattern(rf"{_BEFORE}{_any(qualifiers)}{_NOT_ASSIGNED}", ("qualifier",)),
        Pattern(rf"\${_NAME}", ("string variable",)),
        Pattern(rf"#{_NAME}", ("precision point",)),
        Pattern(rf"%?{_NAME}", ("name",)),
        Pattern(r"\*\*|<=|>=|<>|==|=<|=>|[-+*/=<>:^]", ("operator",)),
        Pattern(r"[()\[\],]", ("punctuation",)),
        Pattern(r"[ \t]+", ("blank",)),
    )


_STRUCTURE = frozenset({"STRUCTURE", "IF", "WHILE", "UNTIL", "FOR", "CASE", "VALUE", "ANY", "GOTO"})
_FLOW = frozenset({"CALL", "CALLS", "RETURN", "RETURNE", "STOP", "HALT", "PAUSE", "EXIT", "NEXT"})
