"""Lines that are typed at PROMPT: all that an environment names, or some of a range of numbers."""

import math
from collections.abc import Sequence
from itertools import count, pairwise, product
from typing import NamedTuple

from vrts.ir import instructions as ir
from vrts.ir.module import Module
from vrts.ir.values import Type
from vrts.prove.environment.environment import Answers
from vrts.prove.explore.bounded import Usage, usage
from vrts.prove.graph.compared import compared

MOST_WHOLE = 200  # whole numbers that are all tried
MOST_LINES = 400  # of several numbers each
DIGITS = 4  # of numbers between others


class Tried(NamedTuple):
    """What is typed, each time."""

    texts: tuple[str, ...] = ()
    numbers: tuple[float, ...] = ()  # of the range
    sampled: str = ""  # what of the range is tried; empty: all of it
    apart: tuple[float, ...] | None = None  # numbers by which all others are told apart

    def lines(self, places: int) -> tuple[str, ...]:
        """Return the lines for a PROMPT that reads so many values."""
        words = [f"{number:.9g}" for number in self.numbers]
        if len(words) ** places > MOST_LINES:
            several = [(word,) * places for word in words]
        else:
            several = list(product(words, repeat=places))
        return (*self.texts, *(" ".join(line) for line in several if self.numbers))


class Free:
    """What is tried where nobody says what may be typed: whatever a program can tell apart."""

    def __init__(self, module: Module) -> None:
        """Look at nothing yet."""
        self._module = module
        self.asked: dict[tuple[str, int], Tried | None] = {}  # by program and instruction

    def at(self, name: str, index: int) -> Tried | None:
        """Return what is tried at a PROMPT; None: what is typed has no bounds there.

        Args:
            name: The program that asks.
            index: Of the instruction.
        """
        if (name, index) not in self.asked:
            program = self._module.programs[name]
            prompt = program.instructions[index]
            assert isinstance(prompt, ir.Prompt)
            used = [usage(self._module, program, place) for place in prompt.places]
            known = [each for each in used if each is not None]
            self.asked[name, index] = None
            if len(known) == len(used):
                is_text = any(place.variable.type is Type.STRING for place in prompt.places)
                self.asked[name, index] = _texts(known) if is_text else _apart(known, self._module)
        return self.asked[name, index]

    @property
    def is_whole(self) -> bool:
        """Whether all that may be typed is tried at every PROMPT, nothing at some values only."""
        for program in self._module.programs.values():
            for index, each in enumerate(program.instructions):
                if isinstance(each, ir.Prompt):
                    found = self.at(program.name, index)
                    if found is None or found.sampled:
                        return False
        return True


def _texts(used: Sequence[Usage]) -> Tried:
    """Return each text that a program compares with, and one other."""
    texts = {value for each in used for value in each.compared if isinstance(value, str)}
    other = next(word for k in count(1) if (word := "x" * k) not in texts)
    return Tried((*sorted(texts), other))


def _apart(used: Sequence[Usage], module: Module) -> Tried:
    """Return numbers that tell apart all that programs do with them."""
    within = [each.within for each in used if each.within is not None]
    numbers = {value for each in used for value in each.compared if isinstance(value, float)}
    ordered = sorted(numbers) or [0.0]
    between = {0.5 * (a + b) for a, b in pairwise(ordered)}
    tell_apart = {ordered[0] - 1.0, ordered[-1] + 1.0, *ordered, *between}
    if not within:
        return Tried((), tuple(sorted(tell_apart)), apart=tuple(sorted(numbers)))
    for least, most in within:
        tell_apart.update(tried(Answers(least=least, most=most), module).numbers)
    tell_apart = {float(f"{number:.9g}") for number in tell_apart}
    shown = ", ".join(f"{n:g}" for n in sorted(tell_apart))
    return Tried((), tuple(sorted(tell_apart)), f"any number: {shown} only")


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
