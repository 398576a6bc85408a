"""What a bundle says about itself: what was verified, in what, how, and who waived what.

Lengths are in mm, angles in degrees and times in s, rounded by the shared rule.
"""

from typing import Annotated, Literal

from msgspec import Meta

from vrts.marking.result import Digest, Record

SCHEMA = "vrts.bundle/4"
WITHOUT_WISH = "vrts.bundle/3"  # the format before bundles held what was asked for
WITHOUT_FUTURES = "vrts.bundle/2"  # the format before bundles held a proof over every future
WITHOUT_PROOFS = "vrts.bundle/1"  # the format before bundles held certificates

Words = Annotated[str, Meta(max_length=2_000)]


class Member(Record, frozen=True):
    """A file of the bundle."""

    name: Annotated[str, Meta(max_length=100)]
    sha256: Digest
    bytes: Annotated[int, Meta(ge=0)]


class Thing(Record, frozen=True):
    """Something that the program was verified with."""

    title: Words
    sha256: Digest


class Answered(Record, frozen=True):
    """The answer of one check."""

    check: Words
    answer: Literal["holds", "violated", "undetermined"]
    summary: Words


class Shown(Record, frozen=True):
    """What shows that the contacts of a run are those that were found."""

    file: Annotated[str, Meta(max_length=100)] | None  # its certificate; None: there is none
    scenario_sha256: Digest  # of everything that happens to the run from outside
    summary: Words  # "holds, 480 intervals", or why there is none


class Verified(Record, frozen=True):
    """One scenario, and what came of it."""

    scenario: Words
    sha256: Digest | None  # of the scenario file; None: a run as it is without one
    ending: Words
    duration_s: float | None
    statements: int
    motions: int
    mark: float | None
    clearance_mm: float | None  # None: something touches, or nothing could
    verdicts: tuple[Answered, ...]
    proof: Shown | None = None  # None: only in the first format


class Executed(Record, frozen=True):
    """The steps of one program that some scenario executed, of those that do something."""

    program: Words
    steps: Annotated[int, Meta(description="instructions that the controller carries out")]
    executed: int
    motions: int
    motions_executed: int
    not_executed: tuple[int, ...]  # numbers of steps


class Reads(Record, frozen=True):
    """What the path of a program may depend on beside its own text and data."""

    inputs: tuple[Words, ...]
    timers: tuple[Words, ...]
    unset: tuple[Words, ...]  # variables that were read before the program gave them a value


class Futures(Record, frozen=True):
    """The proof over every future of the program, and what it speaks about."""

    environment: Words  # its title
    sha256: Digest | None  # of its file; None: the usual one
    answer: Literal["holds", "violated", "undetermined"]
    summary: Words  # how much was looked at
    quantified: tuple[Words, ...]  # tried in every way
    bounded: tuple[Words, ...]
    sampled: tuple[Words, ...]  # tried at some values only
    assumed: tuple[Words, ...]  # taken for granted


class Margin(Record, frozen=True):
    """How far the world may differ from the scene before something goes wrong."""

    name: Words  # "objects +-3 mm"
    answer: Literal["holds", "violated", "undetermined"]
    method: Literal["proven", "sampled"]
    clearance_mm: float | None  # that is left, at least, in what was looked at
    sentence: Words


class Waiver(Record, frozen=True):
    """A refusal that somebody has answered for."""

    code: Annotated[str, Meta(pattern=r"^V\d{3}$")]
    who: Annotated[str, Meta(min_length=1, max_length=200)]
    reason: Annotated[str, Meta(min_length=1, max_length=1_000)]
    refused: tuple[Words, ...]  # headline of what would have been refused; once all of a code
    finding: Annotated[str, Meta(pattern=r"^[0-9a-f]{0,6}$")] = ""  # which; "": all of the code


class Asked(Record, frozen=True):
    """What the plan was asked for: with the files in `given/`, enough to plan it again."""

    program: Words  # name of its file
    others: tuple[Words, ...]  # names of the files that were compiled with it
    dialect: Words | None
    precedence: Literal["A", "B"] | None
    replace: bool
    entry: Words | None  # program to execute, where somebody named it
    scene: Words  # its name; of a robot alone: the robot
    alone: bool  # whether there is no file of the scene
    shapes: tuple[Annotated[str, Meta(max_length=200)], ...]  # files that the scene names
    controller: Words  # name of the model that the runs go by
    task: Words | None  # its name
    proof: bool  # whether the task asks for a proof that is not hidden
    task_environment: Words | None  # name of the file that the task names for it
    environment: Words | None  # name of the file that was given
    scenarios: tuple[Words | None, ...]  # names of their files; None: a run as it is
    fails_first: bool  # whether it was asked which margin fails first


class Manifest(Record, frozen=True):
    """The whole."""

    schema: Literal["vrts.bundle/1", "vrts.bundle/2", "vrts.bundle/3", "vrts.bundle/4"]
    vrts: Words  # version that verified
    title: Words  # name of the program's file
    entry: Words  # the program to execute
    program: Thing  # the file as it was given
    scene: Thing
    robot: Thing
    task: Thing | None
    profile: Words  # name of the profile
    profile_sha256: Digest
    dialect: Words
    scenarios: tuple[Verified, ...]
    executed: tuple[Executed, ...]
    reads: Reads
    clearance_asked_mm: float
    margins: tuple[Margin, ...]
    first_to_fail: Words
    waivers: tuple[Waiver, ...]
    files: tuple[Member, ...]  # every other file of the bundle, by name
    controller: Thing | None = None  # model that the runs went by; None: `vrts-1`, the first
    futures: tuple[Futures, ...] = ()  # one for each scenario; of the first formats none
    asked: Asked | None = None  # None: only in the first formats
