"""What no document gives and somebody had to decide, found by the mark that stands beside it.

Every such number carries the word *assumed* in its comment, every such rule `[assumed]` in its
docstring. This page of decisions is made of those marks, so it cannot fall behind them.
"""

import ast
import io
import re
import tokenize
from typing import NamedTuple

MARK = re.compile(r"\bassumed\b")
_BRACKETED = re.compile(r"\s*\[assumed(?:, ([^\]]*))?\]")


class Assumption(NamedTuple):
    """One decision."""

    where: str  # module, without `vrts.`
    what: str  # the line of code, or the name of the function
    why: str  # the words beside it
    about: str  # section of the reference, where one is named


def assumptions_in(module: str, text: str) -> list[Assumption]:
    """Return the decisions marked in the source of a module, in its order."""
    if not MARK.search(text):
        return []
    found = _in_comments(module, text) + _in_docstrings(module, text)
    return [assumption for _, assumption in sorted(found, key=lambda item: item[0])]


def _in_comments(module: str, text: str) -> list[tuple[int, Assumption]]:
    lines = text.splitlines()
    found: list[tuple[int, Assumption]] = []
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT and MARK.search(token.string):
            line, column = token.start
            code = lines[line - 1][:column].strip().rstrip(",")
            if not code:  # a comment line of its own, about the one below
                code = lines[line].strip().rstrip(",") if line < len(lines) else ""
            found.append((line, _assumption(module, code, token.string.lstrip("# "))))
    return found


def _in_docstrings(module: str, text: str) -> list[tuple[int, Assumption]]:
    found: list[tuple[int, Assumption]] = []
    for node in ast.walk(ast.parse(text)):
        if not isinstance(node, ast.FunctionDef | ast.ClassDef):
            continue
        words = " ".join((ast.get_docstring(node) or "").split())
        for match in _BRACKETED.finditer(words):
            sentence = re.split(r"(?<=[.;:]) ", words[: match.start()])[-1]
            entry = Assumption(module, f"{node.name}()", sentence.strip(), match[1] or "")
            found.append((node.lineno, entry))
    return found


def _assumption(module: str, what: str, words: str) -> Assumption:
    marked = _BRACKETED.search(words)
    about = (marked[1] or "") if marked is not None else ""
    return Assumption(module, what, _BRACKETED.sub("", words).strip(), about)


def text_of(found: list[Assumption]) -> str:
    """Return decisions as text, by module."""
    rows: list[str] = []
    module = ""
    for entry in found:
        if entry.where != module:
            module = entry.where
            rows += ["", module] if rows else [module]
        words = "; ".join(part for part in (entry.why, entry.about) if part)
        rows.append(f"  {entry.what}" + (f"  -- {words}" if words else ""))
    return "\n".join(rows)
