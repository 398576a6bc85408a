"""`SIG(1001]`, `hole{i}`, `[a+b]*2`, `SIGNAL[5]`: brackets of another kind than belongs there."""

import re

from vrts.lang.dialect import Dialect
from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.repair import Repair
from vrts.lang.vocabulary.lookup import look_up

_STRING = re.compile(r'"[^"]*"?')
_PIECE = r"[^()\[\]{}]*"
_ROUND_WORD = re.compile(r"(?P<word>[A-Za-z]+)[ \t]*[\[{](?P<inner>.*)[\]}]", re.ASCII)
_WAYS = (  # what is written, what is meant, and what is told
    (re.compile(rf"(?<=[\w.])\[({_PIECE})[)}}]"), r"[\1]", "`[` is closed by `]`"),
    (re.compile(rf"\(({_PIECE})[\]}}]"), r"(\1)", "`(` is closed by `)`"),
    (
        re.compile(rf"(?<=[\w.])\{{({_PIECE})[\])}}]"),
        r"[\1]",
        "subscripts stand in brackets: `[ ]`",
    ),
    (re.compile(rf"(?<=[\w.])\(({_PIECE})\]"), r"[\1]", "`[` is closed by `]`"),
    (re.compile(rf"\{{({_PIECE})\}}"), r"(\1)", "parts of a sum stand in parentheses: `( )`"),
    (
        re.compile(rf"(?<![\w.\])\s])([ \t]*)\[({_PIECE}[A-Za-z+*/-]{_PIECE})\]"),
        r"\1(\2)",
        "parts of a sum stand in parentheses: `( )`",
    ),
)


def odd_brackets(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a step that is right with brackets of the right kind."""
    bare = _STRING.sub(lambda string: '"' * len(string.group()), text)
    if not any(sign in bare for sign in "[]{}"):
        return None
    whole = _ROUND_WORD.fullmatch(bare)
    if whole is not None:
        word = look_up(whole["word"], dialect).word
        meant = f"{whole['word']} {text[slice(*whole.span('inner'))].strip()}"
        if word is not None and word.text == whole["word"].upper() and repair.at_once(meant):
            return _told(text, meant, f"{word.text} takes no brackets")
    for pattern, instead, says in _WAYS:
        found = list(pattern.finditer(bare))
        if not found:
            continue
        meant = text
        for match in reversed(found):
            piece = match.expand(instead)
            if '"' in piece:
                return None
            meant = f"{meant[: match.start()]}{piece}{meant[match.end() :]}"
        if repair.at_once(meant) is not None:
            return _told(text, meant, says)
    for pair in ("[[", "]]"):
        at = bare.find(pair)
        meant = f"{text[:at]}{text[at + 1 :]}"
        if at >= 0 and repair.at_once(meant) is not None:
            return _told(text, meant, f"`{pair[0]}` stands twice: remove one")
    return None


def _told(text: str, meant: str, says: str) -> Meant:
    return Meant(
        UNEXPECTED_TEXT,
        says,
        0,
        len(text),
        (f"write `{meant}`",),
        meant,
        sure=True,
        notes=("VAL-II says *Illegal expression syntax*",),
    )
