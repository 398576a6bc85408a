"""What to write instead of a step, in words, and how little of it changes."""

import re

_SHORT = 20  # characters that a help quotes beside the whole step
_COMPARISON = re.compile(
    r"(?P<left>(?:[^<>=()&|]|\([^<>=()]*\))+?)(?P<before>[ \t]*)(?P<sign>==|<>|<=|>=|<|>)"
    r"(?P<right>(?!.*\b(?:AND|OR|XOR)\b)(?:[^<>=()&|]|\([^<>=()]*\))+)",
    re.IGNORECASE,
)
_OPPOSITES = {"==": "<>", "<>": "==", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
_PIECES = re.compile(r'"[^"]*"|[\w.]+|[-+*/<>=!&|]+|\S')


def what_to_write(text: str, before: str) -> str:
    """Return what to write instead of a step, and what that changes."""
    rows = [row.strip() for row in text.split("\n")]
    if len(rows) > 1:
        return "give each a line of its own: " + ", ".join(f"`{row}`" for row in rows)
    old, new = differing(before, rows[0])
    if old and not new:
        return f"take `{old}` out: write `{rows[0]}`"
    single = len(_PIECES.findall(old)) == len(_PIECES.findall(new)) == 1
    if single and old != before and len(old) <= _SHORT:
        return f"write `{new}` instead of `{old}`: `{rows[0]}`"
    return f"write `{rows[0]}`"


def differing(before: str, after: str) -> tuple[str, str]:
    """Return the words and signs of two steps between those that both begin and end with."""
    one, other = list(_PIECES.finditer(before)), list(_PIECES.finditer(after))
    most = min(len(one), len(other))
    start = 0
    while start < most and one[start].group().upper() == other[start].group().upper():
        start += 1
    end = 0
    while end < most - start and one[-1 - end].group().upper() == other[-1 - end].group().upper():
        end += 1
    old, new = one[start : len(one) - end], other[start : len(other) - end]
    return (
        before[old[0].start() : old[-1].end()] if old else "",
        after[new[0].start() : new[-1].end()] if new else "",
    )


def smallest_change(before: str, after: str) -> tuple[int, int, str]:
    """Return the smallest range of words that differs, and what stands there after."""
    start = 0
    while start < min(len(before), len(after)) and before[start] == after[start]:
        start += 1
    while start and before[start - 1].isalnum():
        start -= 1
    end = 0
    most = min(len(before), len(after)) - start
    while end < most and before[-1 - end] == after[-1 - end]:
        end += 1
    while end and before[len(before) - end].isalnum():
        end -= 1
    return start, len(before) - end, after[start : len(after) - end]


def else_word(text: str) -> str:
    """Return how a line begins that means ELSE IF."""
    first = first_word(text.lstrip("} \t")).upper()
    return "ELSE IF" if first == "ELSE" else first


def opposite(condition: str) -> str:
    """Return the condition that holds where another does not."""
    found = _COMPARISON.fullmatch(condition)
    if found is not None:
        return f"{found['left']}{found['before']}{_OPPOSITES[found['sign']]}{found['right']}"
    bare = re.fullmatch(r"NOT[ \t]+(\w+(?:\([^()]*\))?)", condition, re.IGNORECASE)
    return bare[1] if bare is not None else f"NOT ({condition})"


def first_word(text: str) -> str:
    """Return the word that a step begins with; empty where it begins with a sign."""
    end = 0
    while end < len(text) and (text[end].isalnum() or text[end] in "._") and text[end].isascii():
        end += 1
    return text[:end] if text[:1].isalpha() else ""


def with_article(title: str) -> str:
    """Return a language with its article."""
    return f"an {title}" if title == "AS" else f"a {title}"


def same_steps(one: str, other: str) -> bool:
    """Whether two texts are the same step but for blanks and case."""
    return "".join(one.upper().split()) == "".join(other.upper().split())


def indented(steps: str, indent: str) -> str:
    """Return steps of which all but the first are indented."""
    return steps.replace("\n", f"\n{indent}")
