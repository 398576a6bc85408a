"""What may come from outside, as data."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from types import MappingProxyType
from typing import NamedTuple, TypeAlias

from vrts.scene.model import Parts, Region, Scenario


class Span(NamedTuple):
    """How long something lasts [s]; `most` may be inf."""

    least: float
    most: float


class Held(NamedTuple):
    """An input that never changes."""

    on: bool | None  # None: nobody says which, but it stays as it is


class Pulsed(NamedTuple):
    """An input that is off at first, and goes on and off; each stay lasts so long [s]."""

    on_s: Span
    off_s: Span


class Answering(NamedTuple):
    """An input that follows an output of the controller, so much later [s]."""

    output: int
    on_s: Span  # after the output goes on
    off_s: Span  # after it goes off


Behaviour: TypeAlias = Held | Pulsed | Answering  # an input of which nothing is said is free


class Answers(NamedTuple):
    """What an operator may type at PROMPT: any of them, each time."""

    texts: tuple[str, ...] = ()
    least: float | None = None  # or any number of a range
    most: float | None = None
    whole: bool = False  # whole numbers only: then all of them are tried, else some (sampled)


class Counts(NamedTuple):
    """What an analog input may read [counts], in every tick in which it is read anew."""

    least: int
    most: int
    values: tuple[int, ...] = ()  # these only, in ascending order; empty: all in between


class Afterwards(Enum):
    """What an operator may do after a stop."""

    PROCEED = "proceed"
    RETRY = "retry"
    NOTHING = "nothing"


class Again(NamedTuple):
    """EXECUTE again, with the memory that the last execution left."""

    most: int | None = 0  # times more; None: until the state repeats
    parts: Parts = Parts.PUT_BACK


class Quantifier(Enum):
    """How a property speaks of moments."""

    NEVER = "never"
    ALWAYS = "always"


class Property(NamedTuple):
    """A property of one's own: at no moment, or at every moment, all conditions are met."""

    quantifier: Quantifier
    title: str
    signals: tuple[int, ...] = ()  # SIG numbers; a negative one has to be off
    hand: str | None = None  # "open", "closed", "holding", "empty"
    region: Region | None = None  # that the middle between the pads is in, at a tick
    step: tuple[str, int] | None = None  # program and step under way
    still: bool | None = None  # whether the arm stands still
    after: int | None = None  # counted from when this signal went on (negative: off)
    within_s: float | None = None  # then the conditions are met at some moment within so long


@dataclass(frozen=True, slots=True)
class Environment:
    """What may happen, and what is the same in every future."""

    title: str = "everything that is read is free"
    scenario: Scenario = field(default_factory=Scenario)  # start, sensors, parameters, limits
    inputs: Mapping[int, Behaviour] = field(default_factory=lambda: MappingProxyType({}))
    # of an analog input of which nothing is said: all that the controller can read
    analog: Mapping[int, Counts] = field(default_factory=lambda: MappingProxyType({}))
    answers: Answers | None = None  # None: nobody says what is typed at PROMPT
    random: tuple[float, ...] = (0.0, 0.5, 0.9999)  # what RANDOM may draw: sampled
    speeds: tuple[float, ...] = (100.0,)  # monitor speeds [%], one for a whole future
    stops: frozenset[Afterwards] = frozenset()  # what may follow a stop in any tick; empty: none
    stop_every: int = 1  # only each so many-th tick is tried: above 1 stops are sampled
    again: Again = field(default_factory=Again)
    misses: bool = False  # whether each closing of the hand may grip or miss
    turns: bool = True  # whether either of two programs may go on first in a tick
    properties: tuple[Property, ...] = ()
    digest: str = ""  # sha256 of the file; empty without one
