"""Lines that are typed at PROMPT: all that an environment names, or some of a range of numbers."""

import math
from itertools import pairwise, product
from typing import NamedTuple

from vrts.ir.module import Module
from vrts.prove.environment.environment import Answers
from vrts.prove.graph.compared import compared

MOST_WHOLE = 200  # whole numbers that are all tried
MOST_LINES = 400  # of several numbers each
DIGITS = 4  # of numbers between others


class Tried(NamedTuple):
    """What is typed, each time."""

    texts: tuple[str, ...] = ()
    numbers: tuple[float, ...] = ()  # of the range
    sampled: str = ""  # what of the range is tried; empty: all of it

    def lines(self, places: int) -> tuple[str, ...]:
        """Return the lines for a PROMPT that reads so many values."""
        words = [f"{number:g}" for number in self.numbers]
        if len(words) ** places > MOST_LINES:
            several = [(word,) * places for word in words]
        else:
            several = list(product(words, repeat=places))
        return (*self.texts, *(" ".join(line) for line in several if self.numbers))


def tried(answers: Answers | None, module: Module) -> Tried:
    """Return what of all that an operator may type is tried."""
    if answers is None:
        return Tried()
    least, most = answers.least, answers.most
    if least is None or most is None:
        return Tried(answers.texts)
    if answers.whole:
        first, last = math.ceil(least), math.floor(most)
        if last - first < MOST_WHOLE:
            return Tried(answers.texts, tuple(float(n) for n in range(first, last + 1)))
    known = {least, most, *(n for n in compared(module) if least < n < most)}
    step = 1.0 if answers.whole else max((most - least) * 1e-3, 10.0**-DIGITS)
    edges = {near for n in known for near in (n - step, n, n + step) if least <= near <= most}
    ordered = sorted(edges)
    between = {round(0.5 * (a + b), DIGITS) for a, b in pairwise(ordered)}
    numbers = ordered if answers.whole else sorted(edges | between)
    if answers.whole:
        numbers = sorted({float(round(n)) for n in (*numbers, *between)})
    shown = ", ".join(f"{n:g}" for n in numbers)
    return Tried(answers.texts, tuple(numbers), f"{least:g} to {most:g}: {shown} only")
