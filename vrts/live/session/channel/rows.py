"""Rows in messages of a session: bodies, programs, contacts of a way, lost points, places.

Lengths are in m, angles in rad, times in s since the session began, in the world frame.
"""

import msgspec


class WayTouch(msgspec.Struct, frozen=True):
    """What would touch on the way, and where."""

    text: str  # "left finger touches base1, 3.1 mm deep"
    parts: tuple[str, str]
    start: float  # share of the time that the way takes
    end: float
    point: tuple[float, float, float]  # where it is deepest [m]
    at_goal: bool  # it touches where the way ends, too


class Placed(msgspec.Struct, frozen=True):
    """How a movable body lies from a time on, as the viewer's player takes it."""

    body: str
    start: float
    lie: str  # value of Lie: "resting", "held", "falling", "toppled"
    X: tuple[float, ...]  # in the world; of a held body in the flange frame
    support: str | None


class ProgramEntry(msgspec.Struct, frozen=True):
    """A program in memory."""

    name: str
    lines: tuple[str, ...]
    fault: str = ""  # why it cannot be executed
    main: bool = False  # the one to execute where nobody names one


class Lost(msgspec.Struct, frozen=True):
    """Points lost to one cause, as a report's table shows them."""

    points: str  # "−1.5"
    kind: str  # of `check.mark.grade.Loss`
    text: str
    at_s: float | None = None  # when it happened; None: it is about the whole


class Part(msgspec.Struct, frozen=True):
    """What one thing that the task asks for has earned so far."""

    check: str  # name of the verdict
    title: str
    kind: str  # of `check.mark.grade.Earned`
    answer: str  # "holds", "violated", "undetermined"; empty: not looked at
    points: str
    most: str
    text: str  # what is wrong; empty: nothing


class HandPlace(msgspec.Struct, frozen=True):
    """Where the hand grips an object, or sets one down."""

    name: str  # "can1_grip"
    body: str  # in whose frame it is; empty: in the world
    X: tuple[float, ...]  # of the tool, twelve numbers
