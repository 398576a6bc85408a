"""The form of a proof over every future as JSON, for its JSON Schema."""

from typing import TypedDict


class Decided(TypedDict):
    """What outside decided, when, and the step that looked at it; of a stop: what followed."""

    time_s: float
    what: str
    number: int
    value: bool | float | str
    words: str
    program: str | None
    step: int | None
    line: int | None


class Wronged(TypedDict):
    """A future that goes wrong, and the scenario file that shows it."""

    wrong: str
    headline: str
    time_s: float
    program: str | None
    step: int | None
    line: int | None
    decisions: list[Decided]
    confirmed: bool
    scenario: str | None


class Unbounded(TypedDict):
    """A variable that grows for ever."""

    name: str
    program: str | None
    step: int | None
    line: int | None


class Dead(TypedDict):
    """A step that no future executes."""

    program: str
    step: int
    reason: str


class Covered(TypedDict):
    """What was gone through, and over what the answer speaks."""

    states: int
    decisions: int
    merged: int
    ends: int
    motion_s: float
    quantified: list[str]
    bounded: list[str]
    sampled: list[str]
    assumed: list[str]
    dead: list[Dead]


class Branch(TypedDict):
    """A node of the tree of decisions; `parent` and `into` are places in the list."""

    parent: int | None
    decided: Decided | None
    ends: str
    ended_s: float | None
    into: int | None
    scenario: str | None  # of one that ends: a file that goes the same way


class Futures(TypedDict):
    """The answer about every future of a program."""

    schema: str
    title: str
    answer: str
    headline: str
    found: list[Wronged]
    open: list[str]
    unbounded: list[Unbounded]
    covered: Covered
    tree: list[Branch]
