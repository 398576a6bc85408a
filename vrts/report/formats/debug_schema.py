"""The form of what a command of the debugger did as JSON, for its JSON Schema."""

from typing import Literal, NotRequired, TypedDict


class Stopped(TypedDict):
    """Why it stands where it stands."""

    why: Literal["begin", "step", "breakpoint", "change", "alarm", "jump", "go", "end"]
    text: str


class Valued(TypedDict):
    """A value: a pose in mm and degrees, six joints in degrees."""

    kind: Literal["real", "string", "pose", "joints"]
    value: float | str | list[float]


class Logged(TypedDict):
    """What a breakpoint wrote."""

    time_s: float
    kind: str
    text: str


class Instant(TypedDict):
    """Where a row leads: `at 6.2 step 17` goes there."""

    time_s: float
    statements: int  # finished by then


class Happened(TypedDict):
    """A row of `events`; what does not belong to an event is left out."""

    number: int  # `go` leads there
    text: str  # the row in words
    time_s: float
    kind: str  # program, motion, hand, grasp, signal, output, fault, note, contact, near-miss
    what: str  # more exactly
    body: NotRequired[list[str]]
    signal: NotRequired[int]
    value: NotRequired[float]
    motion: NotRequired[int]
    depth_mm: NotRequired[float]  # of a contact
    distance_mm: NotRequired[float]  # of a near miss
    height_mm: NotRequired[float]  # that a thing let go falls
    program: NotRequired[str]  # whose step did it
    step: NotRequired[int]
    line: NotRequired[int]
    go: Instant


class Called(TypedDict):
    """A row of `calls`."""

    number: int
    text: str
    program: str
    from_s: float
    to_s: float
    took_s: float
    depth: int  # programs that call each other then; 1: the first
    caller: NotRequired[str]
    line: NotRequired[int]  # of the call
    arguments: str
    thread: Literal["robot", "process"]
    go: Instant


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
    calls: NotRequired[list[Called]]
    total: NotRequired[int]  # rows that fit; some may be left out
    log: NotRequired[list[Logged]]
