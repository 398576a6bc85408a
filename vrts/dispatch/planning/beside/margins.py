"""How far may the world differ from the scene? The program is verified again in worlds beside it.

*Proven*: an object that stands d beside its place comes nearer to anything by d at most, and the
same holds for the base. What the hand carries is beside its place by what the object was off,
turned with the hand since it was taken, and by what the base is off, now and when it was taken: by
half a turn all of that adds up. So where everything counted keeps more than twice both margins
together (both once where nothing is carried), nothing is touched, however all of them are off at
once. *Sampled*: what stays near on purpose (taking, lifting, setting down) is tried with each
object moved alone along X and Y, the base, both against each other, with other speeds, and with
corners that are rounded more, less, or not at all.

A lab may say how a robot was found to stand, and within which intervals. Any point of such a robot
is off by no more than a bound that holds wherever all of its numbers are in their intervals: it is
*proven*, on top of the other margins. *Sampled*: each number alone at both ends of its interval.

A hand that closes on an object beside its middle pushes it to the middle, as far as it slides.
Both ends of that are tried: the object stays as it lies; and it is in the middle between the pads,
its place across them as it was. In both the pads give way by as much as it is off.
"""

from collections.abc import Iterator, Sequence
from typing import Literal

from vrts.base.diagnostic import Diagnostic, error
from vrts.base.units import mm
from vrts.base.workers import Workers
from vrts.dispatch.manifest import Margin
from vrts.dispatch.planning.beside import trials
from vrts.dispatch.planning.beside.trials import BASE, FIRST_SPEED, OBJECTS, Subject, Trial
from vrts.dispatch.planning.beside.trying import Failure, failures
from vrts.dispatch.planning.reasons.refusals import NO_MARGIN
from vrts.engine.memory.records import Lie
from vrts.robots.built import doubt_m, reach_of

FACTORS = (1.5, 2.0, 3.0)  # margins this many times as large are tried, to tell which fails first
FOUND = "the robot as found, within its intervals"
NOT_ASKED = "not looked at: `--fails-first` was not asked for"
NOTHING = "there is nothing to try"
NOT_PROVEN = "not looked at: the program itself is not proven"


def margins(subject: Subject, workers: Workers) -> tuple[Margin, ...]:
    """Return the margins of a program.

    Args:
        subject: The program.
        workers: Who looks at worlds.
    """
    families = (
        (f"objects ±{mm(OBJECTS):g} mm", trials.each_object(subject)),
        (f"base ±{mm(BASE):g} mm", trials.base(subject, 1.0)),
        ("both against each other", trials.together(subject, 1.0)),
        ("speeds at their bounds", trials.speeds(subject, 1.0)),
        ("other corners", trials.corners(subject)),
        (f"at SPEED {FIRST_SPEED:g}", trials.first_run(subject)),
        (FOUND, trials.found_robot(subject)),
    )
    named = [(name, list(worlds)) for name, worlds in families]
    named = [(name, worlds) for name, worlds in named if worlds or name != FOUND]
    every = [trial for _, worlds in named for trial in worlds]
    failed = {failure.what: failure for failure in failures(subject, every, workers)}
    found = [_contact_margin(subject)]
    found += [_margin(name, worlds, failed) for name, worlds in named]
    return tuple(found)


def refused(found: Sequence[Margin]) -> Iterator[Diagnostic]:
    """Yield a refusal for every margin that does not hold, other than the clearance itself."""
    for margin in found[1:]:
        if margin.answer != "holds":
            yield error(
                NO_MARGIN,
                f"with {margin.sentence}",
                notes=(f"margin: {margin.name}",),
                help=("keep farther away there, or grasp nearer to the middle of the pads",),
            )


def first_to_fail(subject: Subject, workers: Workers) -> str:
    """Return which margin fails first when all grow alike: takes longer than all else.

    Args:
        subject: A program whose margins hold.
        workers: Who looks at worlds.
    """
    families = (
        ("objects", trials.all_objects),
        ("base", trials.base),
        ("both against each other", trials.together),
        ("speeds", trials.speeds),
    )
    for factor in FACTORS:
        named = [(name, list(worlds(subject, factor))) for name, worlds in families]
        every = [trial for _, worlds in named for trial in worlds]
        name_of = {trial.what: name for name, worlds in named for trial in worlds}
        failure = next(failures(subject, every, workers), None)
        if failure is not None:
            name = name_of[failure.what]
            return f"{name}, at {factor:g} times the margin: {failure.what}: {failure.sentence}"
    return f"none fails at {FACTORS[-1]:g} times the margins"


# --- what is proven -------------------------------------------------------------------------------


def _contact_margin(subject: Subject) -> Margin:
    """Return what the certified clearance alone proves."""
    clearance = subject.clearance_m
    robot = robot_doubt(subject)
    needed = world_doubt(carried=any(carries(subject))) + robot
    enough = clearance is None or clearance > needed
    far = "nothing is ever near" if clearance is None else f"{mm(clearance):.1f} mm certified"
    proven = f"no contact: {far}, {round(mm(needed), 1):g} mm needed"
    short = f"{far}, {round(mm(needed), 1):g} mm needed to prove it"
    if robot:
        proven += f", {mm(robot):.1f} of them for the robot as found"
        short += f", {mm(robot):.1f} of them for the robot as found"
    answer: Literal["holds", "undetermined"] = "holds" if enough else "undetermined"
    return Margin(
        "all off at once",
        answer,
        "proven",
        None if clearance is None else round(mm(clearance), 2),
        proven if enough else short,
    )


def world_doubt(*, carried: bool) -> float:
    """Return by how much objects and base that are off may bring things nearer, all at once [m]."""
    return (OBJECTS + BASE) * (2.0 if carried else 1.0)


def robot_doubt(subject: Subject) -> float:
    """Return by how much a robot that was found may bring things nearer than it is found to [m].

    Any point of it is off by a bound that holds for all of its numbers at once, but otherwise in
    each configuration. What it carries was taken in one and is let go in another, so it is off by
    twice the bound more, each time that it is carried; and what it meets may have been carried too.
    """
    scene, run = subject.world.scene, subject.run
    held = [
        reach_of(scene.body(name).pieces, placement.X.translation)
        for name, track in run.placements.items()
        for placement in track
        if placement.lie is Lie.HELD
    ]
    most, second, *_ = (*sorted(carries(subject), reverse=True), 0, 0)
    return doubt_m(scene.robot, held) * max(2 * (most + second), 1 + 2 * most)


def carries(subject: Subject) -> list[int]:
    """Return how often each object is carried."""
    tracks = subject.run.placements.values()
    return [sum(placement.lie is Lie.HELD for placement in track) for track in tracks]


# --- what is tried --------------------------------------------------------------------------------


def _margin(name: str, worlds: Sequence[Trial], failed: dict[str, Failure]) -> Margin:
    failure = next((failed[trial.what] for trial in worlds if trial.what in failed), None)
    if failure is not None:
        return Margin(name, "violated", "sampled", None, f"{failure.what}: {failure.sentence}")
    if not worlds:
        return Margin(name, "holds", "sampled", None, NOTHING)
    count = f"{len(worlds)} case{'' if len(worlds) == 1 else 's'}"
    return Margin(name, "holds", "sampled", None, f"holds in all of {count}")
