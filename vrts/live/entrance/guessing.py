"""How long class codes are, so that guessing is in vain however long and fast somebody does it.

A right code is never refused, so wrong ones cannot be limited by refusing. They are counted
instead, all of them together, for good. A code of n characters is one of 31^n. When `budget(n)`
wrong guesses were made, a code of n + 1 characters takes its place, with ten times the budget among
31 times the codes. One code is right at a time, so a guess at n characters is right with at most
1/(31^n - budget(n)), and all guesses ever made together with at most

    budget(9)/(31^9 - budget(9)) + budget(10)/(31^10 - budget(10)) + ... < 5.6e-7

whatever their pace, and however often the code is renewed by hand. Each longer code costs a guesser
ten times as many guesses as the one before: at 1000 a second three hours, a day, 12 days, 116 days.
"""

from fractions import Fraction
from typing import Final

from vrts.live.tokens import LETTERS

SHORTEST: Final = 9  # characters of a code
LONGEST: Final = 24  # no budget of this length is ever used up: 10^22 guesses
BUDGET: Final = 10_000_000  # wrong guesses at codes of the shortest length
GROWTH: Final = 10  # how many times as many at a code that is longer by one


def budget(length: int) -> int:
    """Return how many wrong guesses may be made at codes of a length."""
    return int(BUDGET * GROWTH ** (length - SHORTEST))


def length_after(wrong: int) -> int:
    """Return how long the code is after so many wrong guesses in all."""
    length = SHORTEST
    while length < LONGEST and wrong >= budget(length):
        wrong -= budget(length)
        length += 1
    return length


def left_after(wrong: int) -> int:
    """Return how many more wrong guesses make the code longer."""
    length = length_after(wrong)
    return sum(budget(n) for n in range(SHORTEST, length + 1)) - wrong


def chance() -> Fraction:
    """Return with which probability all guesses that are ever answered find a code, at most."""
    lengths = range(SHORTEST, LONGEST + 1)
    return sum((Fraction(budget(n), codes(n) - budget(n)) for n in lengths), Fraction(0))


def codes(length: int) -> int:
    """Return how many codes there are of a length."""
    return int(len(LETTERS) ** length)
