"""What was found of all futures of a program, as data."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from types import MappingProxyType
from typing import NamedTuple

from vrts.check.verdict import Answer
from vrts.engine.memory.events import Cause
from vrts.scene.model import Scenario


class Wrong(Enum):
    """What may go wrong in a future."""

    CONTACT = "contact"
    LIMIT = "limit"
    ERROR = "run-time error"
    ENDLESS = "endless loop"
    DEADLOCK = "wait that nothing may end"
    UNBOUNDED = "unbounded variable"
    GOAL = "goal missed"
    DEMAND = "demand not met"
    PROPERTY = "property broken"


class What(Enum):
    """What was decided."""

    INPUT = "input"
    ANALOG = "analog input"
    ANSWER = "answer"
    RANDOM = "random number"
    GRIP = "grip"
    STOP = "stop"
    SPEED = "monitor speed"
    AGAIN = "EXECUTE again"
    TURN = "turn of a program"


class Decided(NamedTuple):
    """A decision that outside took."""

    time_s: float
    what: What
    number: int  # of the input or the analog input; 0 for others
    value: bool | float | str  # of a stop: what followed
    cause: Cause | None  # the step that looked


class Wronged(NamedTuple):
    """A future that goes wrong: the shortest of those with the same cause."""

    wrong: Wrong
    headline: str  # one sentence without a stop, lower case: "can1 touches base2, 2.1 mm deep"
    time_s: float
    cause: Cause | None
    decisions: tuple[Decided, ...]  # those that matter, in time order
    scenario: Scenario  # replays it
    confirmed: bool  # a full replay shows the same; what is not confirmed is never told as wrong


class Variable(NamedTuple):
    """A variable that grows round a cycle."""

    name: str
    program: str
    cause: Cause | None


class Step(NamedTuple):
    """A step of a program, as people count them."""

    program: str
    step: int
    reason: str  # why no future executes it


class Branch(NamedTuple):
    """A node of the tree of decisions, in the order in which it was explored."""

    parent: int | None
    decided: Decided | None
    ends: str  # "completed", "merged", "error", "open", "" for one that goes on
    ended_s: float | None = None  # when it ends
    into: int | None = None  # of one that merged: the branch on which that state was met first


@dataclass(frozen=True, slots=True)
class Covered:
    """What a search went through, and over what it speaks."""

    states: int
    decisions: int
    merged: int
    ends: int
    motion_s: float  # of motion that was certified
    quantified: tuple[str, ...]  # "input 1001: on or off in every tick in which it is read"
    bounded: tuple[str, ...] = ()
    sampled: tuple[str, ...] = ()
    assumed: tuple[str, ...] = ()
    dead: tuple[Step, ...] = ()  # steps that no future executes
    statistics: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True, slots=True)
class Proof:
    """The answer about every future."""

    answer: Answer
    found: tuple[Wronged, ...]  # of different causes, the shortest first
    covered: Covered
    open: tuple[str, ...] = ()  # why it is undetermined: what was not looked at
    unbounded: tuple[Variable, ...] = ()
    tree: tuple[Branch, ...] = ()
