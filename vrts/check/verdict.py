"""Answers of checks, and the evidence behind them."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from types import MappingProxyType
from typing import NamedTuple

from vrts.base.diagnostic import Datum, Diagnostic
from vrts.base.pose import Vector
from vrts.engine.memory.events import Cause


class Answer(Enum):
    """Three-valued: a check that cannot tell says so."""

    HOLDS = "holds"
    VIOLATED = "violated"
    UNDETERMINED = "undetermined"


@dataclass(frozen=True, slots=True)
class Verdict:
    """The answer of one check."""

    check: str  # "collision", "limits", "target can1", "via 2", "duration"
    answer: Answer
    summary: str  # one sentence, lower case
    findings: tuple[Diagnostic, ...] = ()
    evidence: Mapping[str, Datum] = field(default_factory=lambda: MappingProxyType({}))


class ContactEvent(NamedTuple):
    """A pair deeper than the tolerance; intervals less than 0.5 s apart are one event."""

    first: str  # "robot", or the name of a free object
    second: str  # name of a body ("robot" again for the arm against itself)
    parts: tuple[str, str]  # which parts touch at the deepest moment: "left finger", "can1"
    start_s: float
    end_s: float
    deepest_s: float
    depth_m: float
    point: Vector  # at the deepest moment, in W [m]
    held: str | None  # what the hand held
    cause: Cause | None  # instruction under way at the first moment


class NearMiss(NamedTuple):
    """A pair that comes nearer than a threshold and does not touch; joined like contacts."""

    first: str  # as of a contact
    second: str
    parts: tuple[str, str]  # which parts are nearest at the nearest moment
    start_s: float
    end_s: float
    nearest_s: float
    distance_m: float  # then
    witnesses: tuple[Vector, Vector]  # nearest points then, in W [m]
    held: str | None  # what the hand held
    cause: Cause | None  # instruction under way at the first moment


def sides(event: ContactEvent | NearMiss) -> tuple[str, str]:
    """Return the names of the two bodies: of what the hand holds where that touches, not robot."""
    holds = event.held is not None and event.parts[0] == event.held
    return (event.parts[0] if holds else event.first, event.second)


class Clearance(NamedTuple):
    """The smallest distance over all time and tested pairs."""

    distance_m: float  # certified to `tolerance_m`
    tolerance_m: float
    time_s: float
    bodies: tuple[str, str]
    witnesses: tuple[Vector, Vector]  # nearest points, in W [m]


@dataclass(frozen=True, slots=True)
class CollisionReport:
    """What the certified check found."""

    contacts: tuple[ContactEvent, ...]
    grazes: tuple[ContactEvent, ...]  # touches no deeper than the tolerance
    undetermined: tuple[ContactEvent, ...]  # still open at the finest interval
    clearance: Clearance | None  # None when there is contact
    certified: bool  # every instant is covered: nothing undetermined
    statistics: Mapping[str, int]  # nodes, narrow-phase calls, ...: the method as evidence
    engine: str = "coal"  # what measured distances
    disagreements: tuple[str, ...] = ()  # with the second engine, about any of these
    near_misses: tuple[NearMiss, ...] = ()  # of pairs that do not touch at that time
    near_miss_m: float | None = None  # nearer than this is one; None: they were not looked for
    near_miss_assumed: bool = True  # no task says how near a near miss is
