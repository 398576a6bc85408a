"""How somebody writes: comments, texts, names, layout, spelling."""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import pairwise

from vrts.lang.reading.sections.lines import comment_start
from vrts.marking.similarity.features.feature import Channel, Feature
from vrts.marking.similarity.symbols import Readable

MOST_LINES = 4_000  # of a program
MOST_WORDS = 3_000  # of a program
LONGEST = 60  # characters of a word or a comment that are compared

_WORD = re.compile(r"[^\W\d_]{3,}")
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_.]*")
_STRING = re.compile(r'"([^"]*)"')
_STEP = re.compile(r"[A-Za-z]+")


def habit_features(file: Readable) -> Iterator[Feature]:
    """Yield what tells of a writer rather than of a program."""
    found: dict[tuple[str, tuple[object, ...]], int] = {}
    lines = list(file.source.lines())[:MOST_LINES]
    codes: list[str] = []
    for number, line in enumerate(lines, start=1):
        cut = comment_start(line)
        code, comment = (line, "") if cut < 0 else (line[:cut], line[cut + 1 :])
        codes.append(code)
        _texts(found, "comment", comment, number)
        for text in _STRING.findall(code):
            _texts(found, "text", text, number)
        for name in _NAME.findall(_STRING.sub("", code)):
            if len(name) > 2:
                found.setdefault(("name", (name.lower()[:LONGEST],)), number)
        if len(found) > MOST_WORDS:
            break
    for (kind, key), line in found.items():
        yield Feature(Channel.WORDS, kind, key, line)
    yield from _layout(lines, codes)


def _texts(
    found: dict[tuple[str, tuple[object, ...]], int], kind: str, text: str, line: int
) -> None:
    words = [word.lower()[:LONGEST] for word in _WORD.findall(text)]
    if not words:
        return
    found.setdefault((f"{kind} whole", (" ".join(words)[: 4 * LONGEST],)), line)
    for word in words:
        found.setdefault((f"{kind} word", (word,)), line)
    for pair in pairwise(words):
        found.setdefault((f"{kind} words", pair), line)


def _layout(lines: Sequence[str], codes: Sequence[str]) -> Iterator[Feature]:
    full = [code for code in codes if code.strip() and not code.lstrip().startswith(".")]
    indents = Counter(len(code) - len(code.lstrip()) for code in full)
    words = [match.group() for code in full if (match := _STEP.search(code))]
    upper = sum(word.isupper() for word in words)
    case = "upper" if upper * 10 > len(words) * 9 else "lower" if upper * 10 < len(words) else "mix"
    columns = Counter(cut for line in lines if (cut := comment_start(line)) > 0)
    commas = sum(", " in code for code in full), sum(bool(re.search(r",\S", code)) for code in full)
    traits: dict[str, object] = {
        "indents": tuple(sorted(n for n, _ in indents.most_common(3))),
        "tabs": any("\t" in line for line in lines),
        "case": case,
        "blank lines": min(9, sum(not line.strip() for line in lines)),
        "blanks at ends": min(9, sum(line != line.rstrip() for line in lines)),
        "comment column": columns.most_common(1)[0][0] if columns else 0,
        "commas": commas[0] > commas[1],
        "ends with a line end": bool(lines) and not lines[-1],
    }
    for name, trait in traits.items():
        yield Feature(Channel.WORDS, "layout", (name, trait), 0)
    for (one, first), (two, second) in pairwise(traits.items()):
        yield Feature(Channel.WORDS, "layouts", (one, first, two, second), 0)
    yield Feature(Channel.WORDS, "all layout", tuple(traits.items()), 0)
