"""How far to look, and who is told: what `prove` is asked besides program, scene, environment."""

from collections.abc import Callable, Generator, Sequence
from typing import NamedTuple, Protocol, TypeVar

T = TypeVar("T")
R = TypeVar("R")

USUAL_STATES = 200_000  # a budget that does not depend on how fast a machine is


class Told(NamedTuple):
    """How far a search has come."""

    states: int
    open: int  # futures that wait to be looked at
    found: int  # things that go wrong
    replaying: bool = False  # whether what seems wrong is replayed; then it may be interrupted


def _nobody(_: Told) -> None:
    """Tell nobody."""


class Answers(Protocol):
    """Answers a question about each of some things, in their order: here, or on more cores."""

    def __call__(self, ask: Callable[[T], R], things: Sequence[T], /) -> Generator[R]:
        """Yield an answer for each, as `map` does; what is not taken need not be asked."""
        ...


def one_by_one(ask: Callable[[T], R], things: Sequence[T], /) -> Generator[R]:
    """Answer here, each when it is wanted."""
    yield from map(ask, things)


def first_here(answers: Answers, ask: Callable[[T], R], things: Sequence[T]) -> Generator[R]:
    """Answer the first here and the others as given: what all need is then in memory once."""
    yield from map(ask, things[:1])
    yield from answers(ask, things[1:])


class Asking(NamedTuple):
    """What a search is asked: `prove(module, scene, environment, asking, *, entry, task)`."""

    states: int = USUAL_STATES  # most states; more than these are open
    collisions: bool = True
    told: Callable[[Told], None] = _nobody  # now and then
    enough: Callable[[], bool] = bool  # asked now and then; true: tell what is known so far
    answers: Answers = one_by_one  # pure questions; no answer depends on how many cores there are
