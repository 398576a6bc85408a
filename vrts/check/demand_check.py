"""Whether a run keeps to the demands of its task: certified on the polynomials."""

import math
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from vrts.base.diagnostic import Diagnostic, Label, Moment, Rule, Severity
from vrts.base.pose import translation
from vrts.base.units import deg, mm
from vrts.check.certified import Peak, peak
from vrts.check.collision import check_collisions
from vrts.check.collision_pairs import ROBOT
from vrts.check.curves import Curves, curves, lasting_of
from vrts.check.demand_values import bound_of, quantity, tilt
from vrts.check.demands import Demand, Keeps
from vrts.check.rounding import exact_s
from vrts.check.verdict import Answer, Verdict
from vrts.engine.records import Lie
from vrts.engine.run import Run
from vrts.geometry.shapes import Box, Piece
from vrts.lang.vocabulary.lookup import look_up
from vrts.scene.model import Body, Mobility

ZONE = Rule("V432", "zone-entered")
TILTED = Rule("V433", "not-upright")
SPEED = Rule("V434", "speed-of-task")
SINGULAR = Rule("V435", "near-singular")
PROGRAM = Rule("V436", "program-rule")
DOUBTFUL = Rule("V437", "undetermined-demand")

LENGTH = 5e-6  # [m], [m/s] half of what a measurement is rounded to
ANGLE = math.radians(0.005)
SHARE = 1e-6  # of a joint's speed limit

DEMAND = "demand "  # begins the names of these checks
METHOD = "certified on the polynomials"


def check_demands(
    run: Run, demands: tuple[Demand, ...], engine: str | None = None
) -> tuple[Verdict, ...]:
    """Return a verdict for every demand; `engine` measures distances, as for collisions."""
    lasting = lasting_of(run.timeline.segments)
    motion = curves(lasting) if lasting else None
    return tuple(_verdict(run, motion, demand, engine) for demand in demands)


def _verdict(run: Run, motion: Curves | None, demand: Demand, engine: str | None) -> Verdict:
    match demand.keeps:
        case Keeps.USES | Keeps.AVOIDS | Keeps.STEPS:
            return _program(run, demand)
        case _ if motion is None:
            return Verdict(DEMAND + demand.name, Answer.HOLDS, "nothing moves")
        case Keeps.ROBOT_OUT:
            return _robot_out(run, motion, demand, engine)
        case Keeps.UPRIGHT:
            return _upright(run, motion, demand)
        case _:
            found = peak(
                quantity(demand, run.scene, motion),
                motion.starts,
                motion.ends,
                bound_of(demand) + _tolerance(demand.keeps),
            )
            return _told(run, motion, demand, found)


def _tolerance(keeps: Keeps) -> float:
    match keeps:
        case Keeps.TOOL_OUT | Keeps.TOOL_SPEED:
            return LENGTH
        case Keeps.JOINT_SPEED:
            return SHARE
        case _:
            return ANGLE


def _upright(run: Run, motion: Curves, demand: Demand) -> Verdict:
    found = Peak(None, None, -math.inf, 0.0, 0)
    for placement in run.placements.get(demand.body, ()):
        if placement.lie is not Lie.HELD:
            continue
        start = np.maximum(motion.starts, placement.start_s)
        end = np.minimum(motion.ends, placement.end_s)
        during = start < end
        angle = tilt(run.scene.robot.arm, placement.X, motion)
        one = peak(angle, start[during], end[during], demand.limit + ANGLE)
        best = max(found, one, key=lambda each: each.largest)
        found = Peak(
            found.above_s if found.above_s is not None else one.above_s,
            found.open_s if found.open_s is not None else one.open_s,
            best.largest,
            best.largest_s,
            found.intervals + one.intervals,
        )
    if found.intervals == 0:
        return Verdict(DEMAND + demand.name, Answer.HOLDS, f"`{demand.body}` is never held")
    return _told(run, motion, demand, found)


def _robot_out(run: Run, motion: Curves, demand: Demand, engine: str | None) -> Verdict:
    """Ask the certified collision check, with the zone as one more body."""
    a, b, c = (0.5 * (high - low) for low, high in zip(demand.lower, demand.upper, strict=True))
    x, y, z = (0.5 * (high + low) for low, high in zip(demand.lower, demand.upper, strict=True))
    name = f"zone {demand.name}"
    piece = Piece(Box((a, b, c)), translation(0.0, 0.0, 0.0))
    grey = (0.5, 0.5, 0.5)
    zone = Body(
        name, name, "box", Mobility.FIXED, (piece,), translation(x, y, z), grey, (0.0, 0.0, 0.0)
    )
    scene = replace(run.scene, bodies=(*run.scene.bodies, zone))
    report = check_collisions(scene, run, clearance=False, engine=engine)
    entered = [e for e in report.contacts if e.first == ROBOT and e.second == name]
    doubtful = [e for e in report.undetermined if e.first == ROBOT and e.second == name]
    found = Peak(
        entered[0].start_s if entered else None,
        doubtful[0].start_s if doubtful else None,
        max((e.depth_m for e in entered), default=0.0),
        entered[0].deepest_s if entered else 0.0,
        report.statistics.get("intervals", 0),
    )
    return _told(run, motion, demand, found, entered[0].parts[0] if entered else "")


def _told(run: Run, motion: Curves, demand: Demand, found: Peak, part: str = "") -> Verdict:
    evidence = MappingProxyType(
        {"method": METHOD, "intervals": found.intervals, "points": float(demand.points)}
    )
    if found.above_s is None and found.open_s is None:
        return Verdict(
            DEMAND + demand.name, Answer.HOLDS, f"{_wanted(demand)}: at every instant", (), evidence
        )
    doubtful = found.above_s is None
    time_s = found.open_s if found.above_s is None else found.above_s
    assert time_s is not None
    headline = _broken(demand, part)
    if doubtful:
        headline = f"too near to tell: {_wanted(demand)}"
    piece = int(motion.motions[motion.piece_at(np.array([time_s]))[0]])
    label = None
    when = f"from {float(exact_s(time_s)):.3f} s on"
    if not doubtful:
        when += f"; {_extreme(demand, found)}"
    if piece >= 0:
        label = Label(run.motions[piece].cause.span, when)
    finding = Diagnostic(
        DOUBTFUL if doubtful else _rule(demand.keeps),
        Severity.WARNING if doubtful else Severity.ERROR,
        headline,
        label,
        notes=() if label is not None else (when,),
        help=("look at this motion in the replay",),
        moment=Moment(time_s, tuple(motion.values(np.array([time_s]))[0].tolist())),
        data=MappingProxyType({"time_s": float(exact_s(time_s)), "demand": demand.name}),
    )
    answer = Answer.UNDETERMINED if doubtful else Answer.VIOLATED
    return Verdict(DEMAND + demand.name, answer, headline, (finding,), evidence)


def _rule(keeps: Keeps) -> Rule:
    match keeps:
        case Keeps.TOOL_OUT | Keeps.ROBOT_OUT:
            return ZONE
        case Keeps.UPRIGHT:
            return TILTED
        case Keeps.JOINT_SPEED | Keeps.TOOL_SPEED:
            return SPEED
        case Keeps.WRIST | Keeps.ELBOW:
            return SINGULAR
        case _:
            return PROGRAM


def _wanted(demand: Demand) -> str:
    match demand.keeps:
        case Keeps.TOOL_OUT:
            return f"the tool stays out of `{demand.name}`"
        case Keeps.ROBOT_OUT:
            return f"the robot stays out of `{demand.name}`"
        case Keeps.UPRIGHT:
            return f"`{demand.body}` stays within {deg(demand.limit):g} degrees of upright"
        case Keeps.JOINT_SPEED:
            return f"no joint turns faster than {100 * demand.limit:g} % of its limit"
        case Keeps.TOOL_SPEED:
            return f"the tool is no faster than {mm(demand.limit):g} mm/s"
        case _:
            return f"the arm stays {deg(demand.limit):g} degrees from the {demand.name}"


def _broken(demand: Demand, part: str) -> str:
    match demand.keeps:
        case Keeps.TOOL_OUT:
            return f"the tool enters the zone `{demand.name}`"
        case Keeps.ROBOT_OUT:
            return f"`{part}` enters the zone `{demand.name}`"
        case Keeps.UPRIGHT:
            return f"`{demand.body}` is tilted by more than {deg(demand.limit):g} degrees"
        case Keeps.JOINT_SPEED:
            return f"a joint turns faster than {100 * demand.limit:g} % of its limit"
        case Keeps.TOOL_SPEED:
            return f"the tool is faster than {mm(demand.limit):g} mm/s"
        case _:
            return f"the arm comes nearer than {deg(demand.limit):g} degrees to the {demand.name}"


def _extreme(demand: Demand, found: Peak) -> str:
    match demand.keeps:
        case Keeps.TOOL_OUT | Keeps.ROBOT_OUT:
            return f"at least {mm(found.largest):.1f} mm deep"
        case Keeps.UPRIGHT:
            return f"{deg(found.largest):.1f} degrees are reached"
        case Keeps.JOINT_SPEED:
            return f"{100 * found.largest:.0f} % are reached"
        case Keeps.TOOL_SPEED:
            return f"{mm(found.largest):.0f} mm/s are reached"
        case _:
            return f"{deg(-found.largest):.1f} degrees are reached"


def _program(run: Run, demand: Demand) -> Verdict:
    """Read the steps of every program of the file; comments and blank lines are none."""
    steps = {
        (program.name, origin.step): origin.span
        for program in run.module.programs.values()
        for origin in program.origins
        if origin.span.text and not origin.span.text.startswith(".")
    }
    evidence = MappingProxyType({"method": "every step read", "steps": len(steps)})
    where = [span for span in steps.values() if _word(span.text) == demand.word]
    label, remedy = None, ""
    match demand.keeps:
        case Keeps.USES if not where:
            headline = f"the program does not use {demand.word}"
            remedy = f"the task wants {demand.word} to be used"
        case Keeps.AVOIDS if where:
            headline = f"the program uses {demand.word}"
            label = Label(where[0], "used here")
            remedy = f"the task wants another way than {demand.word}"
        case Keeps.STEPS if len(steps) > demand.limit:
            headline = f"the program has {len(steps)} steps; {demand.limit:g} are allowed"
            remedy = "look for steps that repeat each other"
        case _:
            return Verdict(DEMAND + demand.name, Answer.HOLDS, f"{demand.name}: kept", (), evidence)
    finding = Diagnostic(PROGRAM, Severity.ERROR, headline, label, help=(remedy,))
    return Verdict(DEMAND + demand.name, Answer.VIOLATED, headline, (finding,), evidence)


def _word(text: str) -> str:
    word = look_up(text.split(maxsplit=1)[0]).word
    return "" if word is None else word.text
