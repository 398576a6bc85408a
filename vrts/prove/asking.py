"""How far to look, and who is told: what `prove` is asked besides program, scene, environment."""

from collections.abc import Callable, Generator, Sequence
from typing import Generic, NamedTuple, Protocol, TypeVar

T = TypeVar("T")
R = TypeVar("R")
R_co = TypeVar("R_co", covariant=True)

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


class Later(Protocol[R_co]):
    """A pure question that somebody else may answer meanwhile. Whoever begins it ends it, too."""

    def begin(self) -> bool:
        """Let somebody else answer; return whether there is anybody."""
        ...

    def answer(self) -> R_co:
        """Return the answer, waiting for it, or giving it here where nobody else has done so."""
        ...

    def end(self) -> None:
        """Leave nobody behind who would answer."""
        ...


class Beside(Protocol):
    """Makes a question about a thing that stays as it is."""

    def __call__(self, ask: Callable[[T], R], thing: T, /) -> Later[R]:
        """Return the question, not begun."""
        ...


class Here(Generic[T, R]):
    """A question that nobody else answers."""

    def __init__(self, ask: Callable[[T], R], thing: T, /) -> None:
        """Do nothing yet."""
        self._ask, self._thing = ask, thing

    def begin(self) -> bool:
        """Return that nobody else answers."""
        return False

    def answer(self) -> R:
        """Answer."""
        return self._ask(self._thing)

    def end(self) -> None:
        """Do nothing: nobody else answers."""


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
    beside: Beside = Here  # the same, of one question while the search goes on
