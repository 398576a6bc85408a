"""One way to write something in another language, as a pattern with what VAL-II has for it.

In a pattern a blank stands for any blanks or none, `_` for at least one (among words also for
itself), `<a|b>` for one of several words. `{e}` is an expression, `{n}` a name, `{v}` a
variable, `{l}` one that may be local in AS, `{d}` a number, `{q}` that of an input or internal
signal, `{s}` a text in quotes, `{t}` what stands in one, `{r}` anything; digits tell two of a
kind apart. What is written instead names them again; `{e-1}` is one less, `{d+1000}` the signal of
an input that others count from 1, `{!e}` the opposite of a condition.
"""

import re
from functools import cache
from typing import NamedTuple

from vrts.lang.steps.idioms.wording import opposite


class Idiom(NamedTuple):
    """A row of the tables."""

    pattern: str
    instead: str = ""  # steps of VAL-II; empty: see `help`
    of: str = ""  # the languages that write it so
    says: str = ""  # the headline where the languages are not what matters
    help: str = ""  # what to do, where that is more than to write `instead`
    note: str = ""  # why the two are the same
    word: str = ""  # the structure word that the step stands for, where `instead` does not tell
    sure: bool = True  # whether `instead` is surely meant
    drop: bool = False  # whether the step is to be taken out
    habit: str = ""  # what else it is told together with


class Matched(NamedTuple):
    """An idiom and what its pattern stands for in a step."""

    idiom: Idiom
    parts: dict[str, str]

    @property
    def instead(self) -> str:
        """The steps to write instead."""
        return filled(self.idiom.instead, self.parts)


_PLACES = re.compile(r"\{(?P<not>!)?(?P<name>[a-z]\d?)(?P<less>-1)?(?P<input>\+1000)?\}")
_PIECES = re.compile(
    r"\{(?P<place>[a-z]\d?)\}|<(?P<words>[^<>]*\|[^<>]*)>|(?P<blank>[ ])|(?P<blanks>_)|(?P<sign>.)"
)
_INPUTS = 1000  # input 1 is signal 1001
_NUMBER = r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)"
_KINDS = {
    "e": r".+?",
    "n": r"[A-Za-z][\w.]*",
    "v": r"\.?[$#]?[A-Za-z][\w.]*(?:\[[^\]]*\])?",
    "l": r"(?:\.?[$#]?|[$#]\.)[A-Za-z][\w.]*(?:\[[^\]]*\])?",
    "d": _NUMBER,
    "q": r"-?[12]\d{3}",
    "s": r"\"[^\"]*\"|'[^']*'|“[^”]*”",
    "t": r"[^\"'%{}\\]*?",
    "r": r".*?",
}
_STRING = re.compile(r"\"[^\"]*\"")


@cache
def compiled(pattern: str) -> re.Pattern[str]:
    """Return a pattern as a regular expression."""
    return re.compile(_expression(pattern, set()), re.IGNORECASE)


def _expression(pattern: str, seen: set[str]) -> str:
    """Return what stands for a pattern, or a part of one, and add its places to those seen."""
    made: list[str] = []
    for piece in _PIECES.finditer(pattern):
        place = piece["place"]
        if place is not None:
            made.append(f"(?P={place})" if place in seen else f"(?P<{place}>{_KINDS[place[0]]})")
            seen.add(place)
        elif piece["words"] is not None:
            made.append(
                f"(?:{'|'.join(_spaced(word, seen) for word in piece['words'].split('|'))})"
            )
        elif piece["blank"] is not None:
            made.append(r"[ \t]*")
        elif piece["blanks"] is not None:
            made.append(r"[ \t]+")
        else:
            made.append(re.escape(piece["sign"]))
    return "".join(made)


def _spaced(words: str, seen: set[str]) -> str:
    """Return some words of a pattern, with what stands for blanks and places in them."""
    if "{" in words:
        return _expression(words, seen)
    return re.escape(words).replace(r"\ ", r"[ \t]*").replace("_", r"[ \t_]+")


def match(idiom: Idiom, text: str) -> Matched | None:
    """Return what an idiom's places stand for, where a text is that idiom."""
    found = compiled(idiom.pattern).fullmatch(text)
    if found is None:
        return None
    parts = {
        name: part if name[0] == "t" else part.strip()
        for name, part in found.groupdict(default="").items()
    }
    if not all(_balanced(part) for name, part in parts.items() if name[0] == "e"):
        return None
    return Matched(idiom, {name: _quoted(name, part) for name, part in parts.items()})


def filled(template: str, parts: dict[str, str]) -> str:
    """Return a template with its places filled."""

    def fill(place: re.Match[str]) -> str:
        part = parts[place["name"]]
        if place["not"]:
            return opposite(part)
        if place["input"]:
            return str(int(part) + _INPUTS) if part.isdecimal() and int(part) < _INPUTS else part
        if not place["less"]:
            return part
        return str(int(part) - 1) if part.isdecimal() else f"{part}-1"

    return _PLACES.sub(fill, template)


def first_words(idiom: Idiom) -> tuple[str, ...]:
    """Return the words, in upper case, that its steps may begin with; none where it is a sign."""
    head = re.match(r"<([^<>]*)>|([A-Za-z]+)", idiom.pattern)
    if head is None:
        return ("",)
    words = head[1].split("|") if head[1] is not None else [head[2]]
    begun = [re.match(r"[A-Za-z]*", word) for word in words]
    return tuple(found.group().upper() if found else "" for found in begun)


def _quoted(name: str, part: str) -> str:
    return f'"{part[1:-1]}"' if name[0] == "s" else part


def _balanced(part: str) -> bool:
    """Whether all brackets and quotes of an expression are closed."""
    depth = 0
    for sign in _STRING.sub("", part):
        depth += (sign in "([") - (sign in ")]")
        if depth < 0:
            return False
    return depth == 0 and part.count('"') % 2 == 0
