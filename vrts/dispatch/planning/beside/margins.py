"""How far may the world differ from the scene? The program is verified again in worlds beside it.

*Proven*: an object that is moved by d, or carried d beside its place, comes nearer to anything by d
at most, and the same holds for the base. A carried object is as far off as it was when the hand
took it, and what it passes may be off as well; so where everything counted keeps more than twice
the objects' margin, and more than both margins together, nothing is touched, however all of them
are off at once. *Sampled*: what stays near on purpose (taking, lifting, setting down) is tried with
each object moved alone along X and Y, the base, both against each other, and with other speeds.

A hand that closes on an object beside its middle pushes it to the middle, as far as it slides.
Both ends of that are tried: the object stays as it lies; and it is in the middle between the pads,
its place across them as it was. In both the pads give way by as much as it is off.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Literal, NamedTuple

from vrts.base.diagnostic import Diagnostic, error
from vrts.base.units import MM, mm
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.pairs.pairs import PAD_DEPTH
from vrts.check.judge import judge
from vrts.dispatch.manifest import Margin
from vrts.dispatch.planning.beside.worlds import (
    DIRECTIONS,
    World,
    base_moved,
    displaced,
    objects_moved,
    pushed_to_the_middle,
    touched,
    with_speeds,
    with_time,
)
from vrts.dispatch.planning.reasons.proof import Case, obstacles
from vrts.dispatch.planning.reasons.refusals import NO_MARGIN
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.ir.module import Module

OBJECTS = 3.0 * MM  # an object may stand so far from its place
BASE = 2.0 * MM  # the arm's base may
JOINTS = (0.8, 1.25)  # bounds of the assumed joint speeds, as factors [assumed]
LINES = (0.5, 1.0)  # the same of straight lines: 0.5 m/s is what is told of the 560 [assumed]
ACCELERATION = (0.75, 1.25)  # the same of the time of an acceleration [assumed]
FIRST_SPEED = 10.0  # [%] the operator's speed of the first run
FACTORS = (1.5, 2.0, 3.0)  # margins this many times as large are tried, to tell which fails first
SLOWER = 4.0  # a run may take this many times as long when something is slower


class Subject(NamedTuple):
    """A program in the world as the scene has it, and the run there, which is proven."""

    module: Module
    entry: str
    world: World
    run: Run
    clearance_m: float | None  # certified; None: nothing is ever near anything


class Trial(NamedTuple):
    """Another world, and what it is."""

    what: str  # "`can1` 3 mm along +Y"
    world: World


class Failure(NamedTuple):
    """What goes wrong in another world."""

    what: str
    sentence: str


def margins(subject: Subject) -> tuple[tuple[Margin, ...], str]:
    """Return the margins of a program, and which fails first when all grow."""
    families = (
        (f"objects ±{mm(OBJECTS):g} mm", _each_object(subject)),
        (f"base ±{mm(BASE):g} mm", _base(subject, 1.0)),
        ("both against each other", _together(subject, 1.0)),
        ("speeds at their bounds", _speeds(subject, 1.0)),
        (f"at SPEED {FIRST_SPEED:g}", _first_run(subject)),
    )
    found = [_contact_margin(subject)]
    found += [_margin(subject, name, list(trials)) for name, trials in families]
    failed = [margin for margin in found if margin.answer == "violated"]
    if failed:
        return tuple(found), f"{failed[0].name}: {failed[0].sentence}"
    return tuple(found), _first_to_fail(subject)


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


# --- what is proven -------------------------------------------------------------------------------


def _contact_margin(subject: Subject) -> Margin:
    """Return what the certified clearance alone proves."""
    clearance = subject.clearance_m
    needed = max(2.0 * OBJECTS, OBJECTS + BASE)
    enough = clearance is None or clearance > needed
    far = "nothing is ever near" if clearance is None else f"{mm(clearance):.1f} mm certified"
    proven = f"no contact: {far}, {mm(needed):g} mm needed"
    short = f"{far}, {mm(needed):g} mm needed to prove it"
    answer: Literal["holds", "undetermined"] = "holds" if enough else "undetermined"
    return Margin(
        "all off at once",
        answer,
        "proven",
        None if clearance is None else round(mm(clearance), 2),
        proven if enough else short,
    )


# --- what is tried --------------------------------------------------------------------------------


def _margin(subject: Subject, name: str, trials: Sequence[Trial]) -> Margin:
    failure = next(_failures(subject, trials), None)
    if failure is not None:
        return Margin(name, "violated", "sampled", None, f"{failure.what}: {failure.sentence}")
    count = f"{len(trials)} case{'' if len(trials) == 1 else 's'}"
    return Margin(name, "holds", "sampled", None, f"holds in all of {count}")


def _failures(subject: Subject, trials: Sequence[Trial]) -> Iterator[Failure]:
    for trial in trials:
        wrong = tried(subject, trial.world)
        if wrong:
            yield Failure(trial.what, wrong[0])


def tried(subject: Subject, world: World) -> tuple[str, ...]:
    """Return what speaks against the real robot in another world."""
    off = displaced(world.scene, subject.run)
    wrong = _tried(subject, world, PAD_DEPTH + off)
    if wrong or off == 0.0:
        return wrong
    return _tried(subject, pushed_to_the_middle(world, subject.run), PAD_DEPTH + off)


def _tried(subject: Subject, world: World, pads: float) -> tuple[str, ...]:
    run = execute(subject.module, world.scene, world.scenario, subject.entry)
    report = check_collisions(world.scene, run, clearance=False, pads=pads)
    judgement = judge(world.scene, run, world.task, report=report)
    return obstacles(Case("", run, judgement, world.task))


def _each_object(subject: Subject) -> Iterator[Trial]:
    known = touched(subject.run)
    for name in (*known.carried, *known.supports):
        for direction, (x, y) in DIRECTIONS.items():
            moved = objects_moved(subject.world, (name,), (OBJECTS * x, OBJECTS * y, 0.0))
            yield Trial(f"`{name}` {mm(OBJECTS):g} mm along {direction}", moved)


def _all_objects(subject: Subject, factor: float) -> Iterator[Trial]:
    carried, far = touched(subject.run).carried, OBJECTS * factor
    if not carried:
        return
    for direction, (x, y) in DIRECTIONS.items():
        moved = objects_moved(subject.world, carried, (far * x, far * y, 0.0))
        yield Trial(f"all that is carried {mm(far):g} mm along {direction}", moved)


def _base(subject: Subject, factor: float) -> Iterator[Trial]:
    far = BASE * factor
    for direction, (x, y) in DIRECTIONS.items():
        moved = base_moved(subject.world, (far * x, far * y, 0.0))
        yield Trial(f"the base {mm(far):g} mm along {direction}", moved)


def _together(subject: Subject, factor: float) -> Iterator[Trial]:
    """Objects one way and the base the other: what the hand takes is off by both."""
    carried = touched(subject.run).carried
    off, far = OBJECTS * factor, BASE * factor
    if not carried:
        return
    for direction, (x, y) in DIRECTIONS.items():
        away = base_moved(subject.world, (-far * x, -far * y, 0.0))
        moved = objects_moved(away, carried, (off * x, off * y, 0.0))
        what = f"objects {mm(off):g} mm along {direction} and the base {mm(far):g} mm against it"
        yield Trial(what, moved)


def _speeds(subject: Subject, factor: float) -> Iterator[Trial]:
    world = with_time(subject.world, SLOWER * factor)
    for joints in JOINTS:
        share = joints**factor
        yield Trial(f"joints at {share:.0%} of their speed", with_speeds(world, joints=share))
    lines = LINES[0] ** factor
    yield Trial(f"straight lines at {lines:.0%} of their speed", with_speeds(world, lines=lines))
    for acceleration in ACCELERATION:
        share = acceleration**factor
        other = with_speeds(world, acceleration=share)
        yield Trial(f"{share:.0%} of the time of an acceleration", other)


def _first_run(subject: Subject) -> Iterator[Trial]:
    world = with_time(subject.world, 100.0 / FIRST_SPEED)
    speed = FIRST_SPEED * world.scenario.monitor_speed / 100.0
    slow = world._replace(scenario=replace(world.scenario, monitor_speed=speed))
    yield Trial(f"SPEED {FIRST_SPEED:g}", slow)


# --- which fails first ----------------------------------------------------------------------------


def _first_to_fail(subject: Subject) -> str:
    """Return which margin fails first when all grow alike."""
    families = (
        ("objects", _all_objects),
        ("base", _base),
        ("both against each other", _together),
        ("speeds", _speeds),
    )
    for factor in FACTORS:
        for name, trials in families:
            failure = next(_failures(subject, list(trials(subject, factor))), None)
            if failure is not None:
                return f"{name}, at {factor:g} times the margin: {failure.what}: {failure.sentence}"
    return f"none fails at {FACTORS[-1]:g} times the margins"
