"""Lines of URScript, nested by `:` and `end`."""

import re
from typing import NamedTuple

from tests.oracle.urscript.values import NotTaken


class Line(NamedTuple):
    """A line of a block."""

    number: int
    text: str
    inner: "list[Line]"  # of what begins a block


def blocks(text: str) -> list[Line]:
    """Return lines nested by `:` and `end`."""
    top: list[Line] = []
    stack = [top]
    for number, raw in enumerate(text.split("\n"), 1):
        row = re.match(r"(?:[^\"#]|\"[^\"]*\")*", raw)
        words = "" if row is None else row.group().strip()
        if not words:
            continue
        first = re.split(r"[\s(:]", words)[0]
        if first in ("end", "elif", "else"):
            if len(stack) < 2:
                raise NotTaken(f"line {number}: `{first}` without a beginning")
            stack.pop()
            if first == "end":
                if words != "end":
                    raise NotTaken(f"line {number}: `end` stands alone")
                continue
        line = Line(number, words, [])
        stack[-1].append(line)
        if first in ("def", "thread", "if", "elif", "else", "while"):
            if not words.endswith(":"):
                raise NotTaken(f"line {number}: `:` is missing")
            stack.append(line.inner)
    if len(stack) != 1:
        raise NotTaken("`end` is missing")
    return top
