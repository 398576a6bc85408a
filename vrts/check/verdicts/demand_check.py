"""Whether a run keeps to the demands of its task: certified on the polynomials."""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from vrts.base.diagnostic import NO_DATA, Datum, Diagnostic, Label, Moment, Rule, Severity
from vrts.check.collision.of_run import motion_of
from vrts.check.curves.certified import Array, Peak, highest, peak
from vrts.check.curves.timeline_arrays import Curves, lasting_of
from vrts.check.rounding import exact_deg, exact_mm, exact_s
from vrts.check.task.demands import DEMAND, Demand, Keeps
from vrts.check.verdict import Answer, Verdict
from vrts.check.verdicts.demand_values import bound_of, close_of, quantity
from vrts.check.verdicts.demand_words import broken, reached, rule_of, wanted
from vrts.check.verdicts.program_rules import check_rule
from vrts.check.verdicts.singularity import on_lines
from vrts.check.verdicts.upright import largest_tilt
from vrts.check.verdicts.zone import robot_in
from vrts.engine.run import Run
from vrts.geometry.proposing.proposer import Proposer

DOUBTFUL = Rule("V437", "undetermined-demand")

METHOD = "certified on the polynomials"


def check_demands(
    run: Run, demands: tuple[Demand, ...], proposer: Proposer | None = None
) -> tuple[Verdict, ...]:
    """Return a verdict for every demand; `proposer` as for collisions."""
    motion = motion_of(run) if lasting_of(run.timeline.segments) else None
    return tuple(_verdict(run, motion, demand, proposer) for demand in demands)


def _verdict(run: Run, motion: Curves | None, demand: Demand, proposer: Proposer | None) -> Verdict:
    match demand.keeps:
        case Keeps.USES | Keeps.AVOIDS | Keeps.STEPS:
            return check_rule(run, demand)
        case _ if motion is None:
            return _kept(demand, "nothing moves")
        case Keeps.ROBOT_OUT:
            found, part = robot_in(run, demand, proposer)
            return _told(run, motion, demand, found, part)
        case Keeps.UPRIGHT:
            tilted = largest_tilt(run, motion, demand)
            if tilted is None:
                return _kept(demand, f"`{demand.body}` is never held")
            return _told(run, motion, demand, tilted)
        case Keeps.TOOL_OUT | Keeps.JOINT_SPEED | Keeps.TOOL_SPEED:
            return _bounded(run, motion, demand, motion.starts, motion.ends)
        case Keeps.WRIST | Keeps.ELBOW | Keeps.SHOULDER | Keeps.SINGULAR:
            start, end = on_lines(run, motion)
            if not len(start):
                return _kept(demand, "there is no straight line")
            return _bounded(run, motion, demand, start, end)


def _kept(demand: Demand, why: str) -> Verdict:
    return Verdict(DEMAND + demand.name, Answer.HOLDS, why)


def _bounded(run: Run, motion: Curves, demand: Demand, start: Array, end: Array) -> Verdict:
    value = quantity(demand, run.scene, motion)
    found = peak(value, start, end, bound_of(demand))
    top = highest(value, start, end, close_of(demand.keeps))
    found = found._replace(largest=top.value, largest_s=top.time_s)
    return _told(run, motion, demand, found, measured=_measured(demand.keeps, found))


def _measured(keeps: Keeps, found: Peak) -> dict[str, Datum]:
    """Return the largest or smallest value as evidence."""
    match keeps:
        case Keeps.TOOL_OUT:
            name, value = "depth_mm", exact_mm(found.largest)  # negative: the distance
        case Keeps.TOOL_SPEED:
            name, value = "largest_mm_s", exact_mm(found.largest)
        case Keeps.JOINT_SPEED:
            name, value = "largest_percent", round(100.0 * found.largest, 2)
        case Keeps.SHOULDER:
            name, value = "smallest_mm", exact_mm(-found.largest)
        case Keeps.SINGULAR:
            name, value = "smallest", round(-found.largest, 3)
        case _:
            name, value = "smallest_deg", exact_deg(-found.largest)
    return {name: float(value), "at_s": float(exact_s(found.largest_s))}


def _told(
    run: Run,
    motion: Curves,
    demand: Demand,
    found: Peak,
    part: str = "",
    measured: Mapping[str, Datum] = NO_DATA,
) -> Verdict:
    """Return the verdict on a quantity; `part` of the robot enters a zone."""
    known = {"method": METHOD, "intervals": found.intervals, "points": float(demand.points)}
    evidence = MappingProxyType({**known, **measured})
    check = DEMAND + demand.name
    if found.above_s is None and found.open_s is None:
        summary = f"{wanted(demand)}: at every instant"
        return Verdict(check, Answer.HOLDS, summary, (), evidence)
    doubtful = found.above_s is None
    time_s = found.open_s if found.above_s is None else found.above_s
    assert time_s is not None
    headline = f"too near to tell: {wanted(demand)}" if doubtful else broken(demand, part)
    when = f"from {float(exact_s(time_s)):.3f} s on"
    if not doubtful:
        when += f"; {reached(demand, found.largest)}"
    at = np.array([time_s])
    piece = int(motion.motions[motion.piece_at(at)[0]])
    label = Label(run.motions[piece].cause.span, when) if piece >= 0 else None
    finding = Diagnostic(
        DOUBTFUL if doubtful else rule_of(demand.keeps),
        Severity.WARNING if doubtful else Severity.ERROR,
        headline,
        label,
        notes=() if label is not None else (when,),
        help=("look at this motion in the replay",),
        moment=Moment(time_s, tuple(motion.values(at)[0].tolist())),
        data=MappingProxyType({"time_s": float(exact_s(time_s)), "demand": demand.name}),
    )
    answer = Answer.UNDETERMINED if doubtful else Answer.VIOLATED
    return Verdict(check, answer, headline, (finding,), evidence)
