"""Which structure a line stands in, by the words that its structures begin and end with."""

import re

_BLOCK_WORD = re.compile(
    r"^[ \t]*(?:\d+[ \t]+)?(IF|FOR|WHILE|CASE|DO|END|UNTIL)\b(.*)$", re.I | re.M
)


def in_case(above: str) -> bool:
    """Whether the innermost structure that lines leave open is a CASE, by their first words."""
    return next(iter(open_words(above)), "") == "CASE"


def open_words(above: str) -> list[str]:
    """Return the words that begin the structures which lines leave open, the innermost first."""
    begin = above.upper().rfind(".PROGRAM")
    found: list[str] = []
    depth = 0
    for word, rest in reversed(_BLOCK_WORD.findall(above[max(begin, 0) :])):
        upper = word.upper()
        if upper in ("END", "UNTIL"):
            depth += 1
        elif upper != "IF" or "GOTO" not in rest.upper():
            if not depth:
                found.append(upper)
            depth = max(depth - 1, 0)
    return found
