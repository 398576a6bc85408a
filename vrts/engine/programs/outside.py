"""What comes from outside and was not decided yet: whoever looks at it has to be told first."""

from collections.abc import Iterable
from enum import Enum
from functools import cache
from typing import NamedTuple, Self


class Kind(Enum):
    """What may be looked at."""

    INPUT = "input"
    ANSWER = "answer"
    RANDOM = "random"
    GRIP = "grip"
    ANALOG = "analog input"
    TURN = "turn"  # which of two programs goes on first in a tick

    __hash__ = object.__hash__  # a question is asked for at every decision


class Question(NamedTuple):
    """Something outside that a statement looks at."""

    kind: Kind
    number: int = 0  # of the input, or of the analog input


class Undecided(Exception):  # noqa: N818 -- names the situation
    """A statement looks at something that nobody has decided; the statement has not begun."""

    @property
    def question(self) -> Question:
        """What it looks at: the one argument that it was raised with."""
        (question,) = self.args
        assert isinstance(question, Question)
        return question


@cache
def about(number: int) -> Question:
    """Return the question what an input is."""
    return Question(Kind.INPUT, number)


class Outside:
    """What may come from outside besides signals, and what of it was decided."""

    __slots__ = ("answers", "drawn", "draws", "gripped_s", "grips", "place", "random", "turns")

    def __init__(
        self, *, answers: bool, random: bool, grips: bool = False, turns: bool = False
    ) -> None:
        """Say what is free.

        Args:
            answers: What is typed at PROMPT.
            random: What RANDOM draws.
            grips: Whether what is gripped is there: asked before the tick in which the hand would
                grasp it.
            turns: Which of two programs goes on first: asked at the beginning of a tick.
        """
        self.turns = turns
        self.answers = answers
        self.random = random
        self.grips = grips
        self.gripped_s: float | None = None  # when the hand grasps what it was decided about
        self.draws: list[float] = []  # decided for the statement under way
        self.drawn = 0  # of them
        self.place: tuple[int, int] | None = None  # of that statement: see `begin_again`

    def draw(self) -> float:
        """Return the random number that was decided.

        Raises:
            Undecided: None was.
        """
        if self.drawn == len(self.draws):
            raise Undecided(Question(Kind.RANDOM))
        self.drawn += 1
        return self.draws[self.drawn - 1]

    def begin_again(self, place: tuple[int, int] | None) -> None:
        """Let a statement begin again: it draws the same numbers; another one draws its own.

        Args:
            place: Whose turn it is in this tick, and statements finished before; None: a new tick,
                in which one that waited draws anew.
        """
        if self.place != place:
            self.draws, self.place = [], place
        self.drawn = 0

    def copy(self) -> "Outside":
        """Return an independent copy."""
        other = Outside.__new__(Outside)
        other.answers, other.random = self.answers, self.random
        other.grips, other.turns = self.grips, self.turns
        other.gripped_s = self.gripped_s
        other.draws, other.drawn, other.place = self.draws.copy(), self.drawn, self.place
        return other


class FreeSignals(set[int]):
    """The signals that are on. What a free input is, has to be decided in every tick anew.

    Analog inputs stand beside the others as -1 to -8.
    """

    __slots__ = ("decided", "free", "looked")

    def __init__(self, on: Iterable[int], free: frozenset[int]) -> None:
        """Take the signals that are on, and the inputs that are free, analog ones negative."""
        super().__init__(on)
        self.free = free
        self.decided: dict[int, float] = {}  # in the tick under way; on or off, or counts
        self.looked = False  # a free input was looked at in the tick under way

    def __contains__(self, number: object) -> bool:
        """Return whether a signal is on.

        Raises:
            Undecided: It is a free input, and not decided in this tick.
        """
        if number not in self.free:
            return super().__contains__(number)
        assert isinstance(number, int)
        self.looked = True
        known = self.decided.get(number)
        if known is None:
            raise Undecided(about(number))
        return known is True

    def count(self, channel: int) -> float:
        """Return what was decided that a free analog input reads [counts].

        Raises:
            Undecided: Nothing was, in this tick.
        """
        self.looked = True
        known = self.decided.get(-channel)
        if known is None:
            raise Undecided(Question(Kind.ANALOG, channel))
        return known

    def copy(self) -> Self:
        """Return an independent copy."""
        other = type(self)(self, self.free)
        if self.decided:
            other.decided = self.decided.copy()
        other.looked = self.looked
        return other


def as_known(on: set[int], number: int) -> bool | None:
    """Return whether a signal is on; None: it is free, and was not decided in this tick."""
    if isinstance(on, FreeSignals) and number in on.free:
        known = on.decided.get(number)
        return None if known is None else known is True
    return number in on
