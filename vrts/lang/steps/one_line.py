"""Several steps on one line: `OPENI : READY`, `FOR i = 1 TO 4 SIGNAL i END`, `IF a THEN b = 1`.

A line is taken apart only where every piece is a step by itself, but for what a structure word
lacks at its end.
"""

import re
from collections.abc import Callable
from typing import NamedTuple

MOST_PIECES = 8
INNER = "    "

_STRING = re.compile(r'"[^"]*"?')
_WORD = re.compile(r"(?<![\w.$#])(?P<word>[A-Za-z]+)(?![\w.])(?![ \t]*(?:=(?!=)|\[))", re.ASCII)
_ASSIGNED = re.compile(r"(?<![\w.$#])[$#]?[A-Za-z][\w.]*(?:\[[^\]]*\])?[ \t]*=(?!=)", re.ASCII)
_BETWEEN = re.compile(  # one way to match: with two, a hundred signs in a row took for ever
    r"(?<![ \t:;,&|])[ \t]*(?:[:;,&|]|\bAND(?:[ \t]+THEN)?\b)"
    r"(?:[ \t:;,&|]|\bAND(?:[ \t]+THEN)?\b)*$",
    re.IGNORECASE,
)
_FOR_TAIL = re.compile(r"[ \t]+(?:DO|THEN|BEGIN|LOOP)$|[ \t]*[:{]$", re.IGNORECASE)
_LACKS = {"IF": " THEN", "WHILE": " DO", "CASE": " OF"}
ONE_LINE = {"IF": "IF THEN", "WHILE": "WHILE DO", "FOR": "FOR TO"}  # with a step behind them
_OPENERS = frozenset({"IF", "WHILE", "FOR", "CASE", "DO"})


_MOTIONS = frozenset({"MOVE", "MOVES", "MOVET", "MOVEST", "APPRO", "APPROS", "DEPART", "DEPARTS"})
_SETTINGS = frozenset(
    [
        "SPEED",
        "FINE",
        "COARSE",
        "NULL",
        "NONULL",
        "LEFTY",
        "RIGHTY",
        "ABOVE",
        "BELOW",
        "FLIP",
        "NOFLIP",
        "SINGLE",
        "MULTIPLE",
    ]
)


class Rows(NamedTuple):
    """The steps of a line."""

    texts: tuple[str, ...]
    second: int  # where the second of them begins in the line
    between: str  # the sign that stood before it, if any

    @property
    def words(self) -> list[str]:
        """The first word of each step, in upper case."""
        return [_first(text) for text in self.texts]

    @property
    def word(self) -> str | None:
        """The structure word that the line stands for, as its program sees it."""
        words = self.words
        if self.open > 0:
            others = _OPENERS | {"END", "UNTIL", "VALUE", "ANY"}
            if words[0] in ONE_LINE and not others.intersection(words[1:]):
                return ONE_LINE[words[0]]
            return next(word for word in reversed(words) if word in _OPENERS)
        if self.open < 0:
            return next(word for word in reversed(words) if word in ("END", "UNTIL"))
        return words[0] if words[0] in ("ELSE", "VALUE", "ANY") else None

    @property
    def open(self) -> int:
        """How many more structures begin than end."""
        opened = 0
        for text, word in zip(self.texts, self.words, strict=True):
            jumps = word == "IF" and re.search(r"\bGOTO\b", text, re.IGNORECASE) is not None
            opened += (word in _OPENERS and not jumps) - (word in ("END", "UNTIL"))
        return opened

    @property
    def settled(self) -> "Rows":
        """The steps, with a setting before the motion that it stood behind."""
        if len(self.texts) != 2 or self.between:
            return self
        motion, setting = self.words
        if motion not in _MOTIONS or setting not in _SETTINGS:
            return self
        return self._replace(texts=self.texts[::-1])

    def indented(self) -> str:
        """The steps as lines, each as deep as its structure."""
        depth = 0
        lines: list[str] = []
        for text, word in zip(self.texts, self.words, strict=True):
            depth -= word in ("END", "UNTIL", "ELSE")
            lines.append(INNER * max(depth, 0) + text)
            depth += word in _OPENERS or word == "ELSE"
        return "\n".join(lines)


def rows_of(text: str, words: frozenset[str], is_step: Callable[[str], bool]) -> Rows | None:
    """Return the steps that stand on one line; None where it is no more than one.

    Args:
        text: The line.
        words: Every instruction of the dialect.
        is_step: Whether a text is a step as it stands.
    """
    plain = _STRING.sub(lambda found: '"' + "s" * (len(found.group()) - 2) + '"', text)
    starts = sorted(
        {m.start() for m in _WORD.finditer(plain) if _begins(m, plain, words)}
        | {m.start() for m in _ASSIGNED.finditer(plain)}
    )
    starts = [at for at in starts if at > 0 and _outside(plain, at)]
    if not 0 < len(starts) < MOST_PIECES:
        return None
    found = _apart(text, 0, starts, is_step, set())
    if found is None or len(found) < 2:
        return None
    between = _BETWEEN.search(text[: found[1][0]])
    sign = between.group().strip() if between is not None else ""
    if not sign.strip(":") and found[0][1].endswith(":"):
        sign = ""
    return Rows(tuple(piece for _, piece in found), found[1][0], sign)


def _apart(
    text: str, begin: int, starts: list[int], is_step: Callable[[str], bool], failed: set[int]
) -> list[tuple[int, str]] | None:
    """Return the pieces from an offset on, each as short as it can be."""
    if begin in failed:
        return None
    ends = [*(at for at in starts if at > begin), len(text)]
    for end in ends:
        piece = _complete(text[begin:end].strip(), is_step, last=end == len(text))
        if piece is None:
            continue
        if end == len(text):
            return [(begin, piece)]
        rest = _apart(text, end, starts, is_step, failed)
        if rest is not None:
            return [(begin, piece), *rest]
    failed.add(begin)
    return None


def _complete(piece: str, is_step: Callable[[str], bool], *, last: bool) -> str | None:
    """Return a piece as a step, with what it lacks at its end and without what is too much."""
    word = _first(piece)
    bare = _BETWEEN.sub("", piece)
    variants = [piece, bare]
    if word == "FOR":
        variants.append(_FOR_TAIL.sub("", bare))
    elif word in _LACKS and not last:
        variants.append(_FOR_TAIL.sub("", bare) + _LACKS[word])
    elif word == "END":
        variants.append("END" if re.fullmatch(r"END[ \t]*\w*", bare, re.IGNORECASE) else bare)
    return next((found for found in variants if found and is_step(found)), None)


def _begins(word: re.Match[str], text: str, words: frozenset[str]) -> bool:
    """Whether a word may begin a step; DO also ends the line of WHILE, or of a FOR by mistake."""
    upper = word["word"].upper()
    return upper in words and (upper != "DO" or _BETWEEN.search(text[: word.start()]) is not None)


def _outside(text: str, at: int) -> bool:
    """Whether an offset is outside of quotes and brackets."""
    before = text[:at]
    depth = sum((sign in "([") - (sign in ")]") for sign in before)
    return depth == 0 and before.count('"') % 2 == 0


def _first(text: str) -> str:
    found = re.match(r"[A-Za-z]+", text)
    return found.group().upper() if found is not None else ""
