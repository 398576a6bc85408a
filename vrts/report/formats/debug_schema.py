"""The form of what a command of the debugger did as JSON, for its JSON Schema."""

from typing import Literal, NotRequired, TypedDict


class Stopped(TypedDict):
    """Why it stands where it stands."""

    why: Literal["begin", "step", "breakpoint", "change", "alarm", "jump", "end"]
    text: str


class Valued(TypedDict):
    """A value: a pose in mm and degrees, six joints in degrees."""

    kind: Literal["real", "string", "pose", "joints"]
    value: float | str | list[float]


class Happened(TypedDict):
    """Something that happened, or that a breakpoint wrote."""

    time_s: float
    kind: str
    text: str


class Debugged(TypedDict):
    """What one command did, and where the debugger stands then."""

    schema: Literal["vrts.debug/1"]
    number: int  # of the command in its script, from 1
    command: str
    ok: bool  # false: refused, an `assert` that does not hold, or a limit
    time_s: float
    statements: int  # finished by then
    stopped: Stopped
    file: NotRequired[str]  # without it no step has been executed
    program: NotRequired[str]
    step: NotRequired[int]
    line: NotRequired[int]
    source: NotRequired[str]  # the line
    said: list[str]  # what a person reads
    value: NotRequired[Valued]  # of an expression
    reasons: NotRequired[list[str]]  # the chain that `why` tells
    events: NotRequired[list[Happened]]
    log: NotRequired[list[Happened]]
