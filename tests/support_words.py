"""Published lists of words (`tests/data/words`), and how far vrts goes with each word."""

import tomllib
from collections import Counter
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

from tests.places import TESTS
from vrts.lang.dialect import DIALECTS
from vrts.report.support import KNOWN, entries

FOLDER = TESTS / "data" / "words"
UNKNOWN = "unknown"
OF_PROGRAMS = ("instruction", "function", "switch", "parameter", "operator", "keyword")
KINDS = (*OF_PROGRAMS, "command", "editor")
READ = ("whole", "part", "remembered")

# what a list calls keyword, vrts knows by these kinds
_ALSO = {"keyword": ("qualifier", "operator", "constant"), "function": ("constant",)}
_OWN_SIGNS = frozenset({"+", "-", "*", "/", "^", "<", "<=", "=<", "==", "<>", ">=", "=>", ">"})


class Listed(NamedTuple):
    """One word of one list."""

    title: str
    read: str
    kind: str
    word: str


def dialects() -> list[str]:
    """Return the names of the dialects that have lists."""
    return sorted(path.stem for path in FOLDER.glob("*.toml"))


def listed(dialect: str) -> Iterator[Listed]:
    """Yield the words of every list of a dialect."""
    for part in tomllib.loads((FOLDER / f"{dialect}.toml").read_text("utf-8"))["list"]:
        for kind in KINDS:
            for word in part.get(kind, ()):
                if not word.startswith("."):  # .PROGRAM and .END begin and end sections
                    yield Listed(part["title"], part["read"], kind, word)


@cache
def _states(dialect: str) -> dict[tuple[str, str], str]:
    return {(entry.kind, entry.word): entry.state for entry in entries(DIALECTS[dialect])}


def state(dialect: str, word: Listed) -> str:
    """Return how far vrts goes with a listed word, or UNKNOWN."""
    if word.kind == "operator" and word.word in _OWN_SIGNS:
        return "runs"
    for kind in (word.kind, *_ALSO.get(word.kind, ())):
        found = _states(dialect).get((kind, word.word), KNOWN)
        if found != KNOWN:
            return found
    return UNKNOWN


def table(dialect: str) -> dict[str, Counter[str]]:
    """Return how many words of each kind are in which state."""
    kinds: dict[str, Counter[str]] = {}
    for kind, word in dict.fromkeys((word.kind, word.word) for word in listed(dialect)):
        found = state(dialect, Listed("", "", kind, word))
        kinds.setdefault(kind, Counter())[found] += 1
    return kinds
