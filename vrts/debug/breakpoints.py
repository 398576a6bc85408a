"""Breakpoints on lines: which instructions a line stands for, and when a run comes there."""

import re
from typing import NamedTuple

import numpy as np

from vrts.debug.passages import Passages
from vrts.engine.history import Code

_HITS = re.compile(r"\s*(==|=|>=|>|<=|<|%)?\s*(\d{1,9})\s*")


class Breakpoint(NamedTuple):
    """A line to stop at.

    Hits are counted from the beginning of the run: they do not depend on the way one came.
    """

    id: int
    source: str  # name of the source
    line: int
    condition: str = ""  # expression of the language that is not zero
    hits: str = ""  # "5", ">= 5", "% 3"
    log: str = ""  # written instead of stopping; {expression} stands for its value


class Watch(NamedTuple):
    """Something to stop at whenever it changes; condition and hits as of a breakpoint."""

    id: int
    name: str  # as `changes` takes it
    condition: str = ""
    hits: str = ""


class Resolved(NamedTuple):
    """What a line stands for."""

    line: int  # at which it stops: that of the next step if the line itself has none
    instructions: frozenset[int]


def resolve(code: Code, source: str, line: int) -> Resolved | None:
    """Return the first step at or after a line, within its program; None when none follows."""
    found: dict[int, set[int]] = {}
    wanted: int | None = None
    for program, base in zip(code.programs, code.bases, strict=True):
        if program.span.source.name != source or program.span.line > line:
            continue
        lines: dict[int, set[int]] = {}
        for number, origin in enumerate(program.origins):
            if number == 0 or origin.step != program.origins[number - 1].step:
                lines.setdefault(origin.span.line, set()).add(base + number)
        later = min((known for known in lines if known >= line), default=None)
        if later is not None and (wanted is None or later < wanted):
            wanted = later
        found = {**found, **lines}
    return None if wanted is None else Resolved(wanted, frozenset(found[wanted]))


def lines_with_steps(code: Code, source: str) -> list[int]:
    """Return the lines at which a breakpoint may stand, in order."""
    return sorted({cause.span.line for cause in code.causes if cause.span.source.name == source})


def passes(passages: Passages, resolved: Resolved) -> list[int]:
    """Return the statements with which a program begins a line, in order."""
    wanted = np.fromiter(resolved.instructions, np.int64)
    return np.flatnonzero(np.isin(passages.instructions, wanted) & passages.begins).tolist()


def is_hit_rule(text: str) -> bool:
    """Return whether a text says which hits count."""
    return not text.strip() or _HITS.fullmatch(text) is not None


def counts(text: str, hit: int) -> bool:
    """Return whether the nth hit is one to stop at."""
    found = _HITS.fullmatch(text)
    if found is None:
        return True
    number = int(found[2])
    match found[1]:
        case ">=":
            return hit >= number
        case ">":
            return hit > number
        case "<=":
            return hit <= number
        case "<":
            return hit < number
        case "%":
            return number > 0 and hit % number == 0
        case _:
            return hit == number
