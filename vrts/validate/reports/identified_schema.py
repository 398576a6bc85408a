"""The form of what is wrong with a robot as JSON, for its JSON Schema."""

from typing import Any, TypedDict


class Off(TypedDict):
    """A number that is off, in its unit, with an interval of 95 %; what explains it as well."""

    kind: str
    name: str
    unit: str
    value: float
    low_95: float
    high_95: float
    as_well: list[list[str]]


class Clock(TypedDict):
    """What is added to times of the log at its start."""

    add_s: float
    half_95_s: float
    own_rests: bool


class Left(TypedDict):
    """What is left of a channel, with the clock alone and with all causes."""

    channel: str
    unit: str
    clock_alone_rms: float
    rms: float
    pattern_rms: float


class Log(TypedDict):
    """The log that was read."""

    name: str
    sha256: str
    synthetic: bool
    rows: int


class IdentifiedForm(TypedDict):
    """What `vrts validate --identify --json` prints of one log."""

    format: int
    sentence: str
    fits: bool
    causes: list[Off]
    clock: Clock
    cannot_be_told_apart: list[list[str]]
    not_seen: list[str]
    left_over: list[Left]
    log: Log
    diagnostics: list[dict[str, Any]]
