"""What the collision report means for the program, in words."""

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from vrts.base.beside import beside
from vrts.base.diagnostic import Datum, Diagnostic, Label, Moment, Rule, Severity
from vrts.base.units import mm
from vrts.check.collision.pairs.arm_state import RunRecord
from vrts.check.collision.pairs.pairs import ROBOT, TOLERANCE
from vrts.check.rounding import exact_mm, exact_s
from vrts.check.verdict import Answer, CollisionReport, ContactEvent, NearMiss, Verdict, sides
from vrts.engine.memory.records import Segment

CONTACT = Rule("V400", "contact")
SELF_CONTACT = Rule("V401", "self-contact")
LOOSE_CONTACT = Rule("V402", "loose-contact")
GRAZE = Rule("V410", "graze")
NEAR = Rule("V411", "near-miss")
UNDETERMINED = Rule("V420", "undetermined-contact")


def verdict(
    report: CollisionReport,
    run: RunRecord | None = None,
    hints: Mapping[int, str] = MappingProxyType({}),
) -> Verdict:
    """Return the answer of the collision check with one diagnostic for every event.

    Args:
        report: What the certified check found.
        run: The run it is about; gives every finding its configuration.
        hints: Better ones than usual, by the place of a contact in the report.
    """
    findings = (
        *(_contact(event, run, hints.get(n)) for n, event in enumerate(report.contacts)),
        *(_graze(event, run) for event in report.grazes),
        *(_undetermined(event, run) for event in report.undetermined),
        *(_near_miss(miss, report, run) for miss in report.near_misses),
    )
    evidence: dict[str, str | int | float] = {
        "method": "certified",
        "tolerance_mm": mm(TOLERANCE),
        "contacts": len(report.contacts),
        "grazes": len(report.grazes),
        "undetermined": len(report.undetermined),
        **report.statistics,
    }
    if report.near_miss_m is not None:
        evidence["near_misses"] = len(report.near_misses)
        evidence["near_miss_mm"] = _mm(report.near_miss_m)
        evidence["near_miss_setting"] = "assumed" if report.near_miss_assumed else "of the task"
    if report.disagreements:
        evidence["disagreements"] = "; ".join(report.disagreements)
    if report.clearance is not None:
        evidence["clearance_mm"] = _mm(report.clearance.distance_m)
        evidence["clearance_at_s"] = _s(report.clearance.time_s)
    return Verdict("collision", _answer(report), _summary(report), findings, _frozen(evidence))


def _mm(length_m: float) -> float:
    return float(exact_mm(length_m))


def _s(time_s: float) -> float:
    return float(exact_s(time_s))


def _frozen(evidence: dict[str, str | int | float]) -> MappingProxyType[str, str | int | float]:
    return MappingProxyType(evidence)


def _answer(report: CollisionReport) -> Answer:
    if report.contacts:
        return Answer.VIOLATED
    return Answer.HOLDS if report.certified else Answer.UNDETERMINED


def _summary(report: CollisionReport) -> str:
    count = len(report.contacts)
    if count:
        return "1 contact" if count == 1 else f"{count} contacts"
    if not report.certified:
        return "whether there is a contact cannot be told at this resolution"
    nearest = report.clearance
    if nearest is None:
        return "no contact at any instant"
    first, second = nearest.bodies
    return (
        f"no contact at any instant; nearest {mm(nearest.distance_m):.1f} mm, "
        f"{first} and {second} at {nearest.time_s:.2f} s"
    )


def subject(event: ContactEvent | NearMiss) -> str:
    """Return what hits, in words: "the held `can1`", "the left finger", "the falling `can1`"."""
    if event.first != ROBOT:
        return f"the falling `{event.first}`"
    part = event.parts[0]
    return f"the held `{part}`" if part == event.held else f"the {part}"


def target(event: ContactEvent | NearMiss) -> str:
    """Return what is hit, in words."""
    return f"the {event.parts[1]}" if event.second == ROBOT else f"`{event.second}`"


def _contact(event: ContactEvent, run: RunRecord | None, better: str | None) -> Diagnostic:
    if event.second == ROBOT:
        rule, hint = SELF_CONTACT, "the arm folds too far here: look at the poses of this motion"
    elif event.first != ROBOT:
        rule, hint = LOOSE_CONTACT, "look at where the object is when the hand lets go of it"
    else:
        rule, hint = CONTACT, _hint(event, run)
    where = f"at {event.start_s:.2f} s, up to {mm(event.depth_m):.1f} mm deep"
    headline = f"{subject(event)} hits {target(event)}"
    return _diagnostic(rule, Severity.ERROR, headline, where, event, (better or hint,), run)


def _hint(event: ContactEvent, run: RunRecord | None) -> str:
    """Return what to look at; never the solution."""
    if run is not None and event.held is None and event.second in run.placements:
        return "look at how wide the hand is open when it gets there"
    if event.parts[0] == event.held:
        return "what the hand holds reaches below the fingers: look at the heights on the way"
    if event.held == event.second:
        return "only the pads may touch what is held: look at how deep the hand reaches over it"
    return "look at where this motion starts and ends, and at what stands between"


def _graze(event: ContactEvent, run: RunRecord | None) -> Diagnostic:
    headline = f"{subject(event)} grazes {target(event)}"
    where = f"at {event.start_s:.2f} s; a touch of at most {mm(TOLERANCE):g} mm costs nothing"
    return _diagnostic(GRAZE, Severity.WARNING, headline, where, event, (), run)


def _near_miss(miss: NearMiss, report: CollisionReport, run: RunRecord | None) -> Diagnostic:
    assert report.near_miss_m is not None
    near, most = beside(exact_mm(miss.distance_m), exact_mm(report.near_miss_m), plain=True)
    limit = f"{most} mm{' (assumed)' if report.near_miss_assumed else ''}"
    headline = f"{subject(miss)} comes within {near} mm of {target(miss)}"
    where = f"at {miss.nearest_s:.2f} s; nearer than {limit} is a near miss and costs nothing"
    data = {
        **_who_and_when(miss),
        "nearest_s": _s(miss.nearest_s),
        "distance_mm": _mm(miss.distance_m),
        "witness_mm": tuple(_mm(value) for value in miss.witnesses[0]),
        "other_witness_mm": tuple(_mm(value) for value in miss.witnesses[1]),
    }
    return _told(NEAR, Severity.WARNING, headline, where, miss, miss.nearest_s, data, (), run)


def _undetermined(event: ContactEvent, run: RunRecord | None) -> Diagnostic:
    headline = f"{subject(event)} may hit {target(event)}: too near to {mm(TOLERANCE):g} mm to tell"
    where = f"at {event.deepest_s:.2f} s"
    return _diagnostic(UNDETERMINED, Severity.WARNING, headline, where, event, (), run)


def _diagnostic(
    rule: Rule,
    severity: Severity,
    headline: str,
    where: str,
    event: ContactEvent,
    hints: tuple[str, ...],
    run: RunRecord | None,
) -> Diagnostic:
    data = {
        **_who_and_when(event),
        "deepest_s": _s(event.deepest_s),
        "depth_mm": _mm(event.depth_m),
        "point_mm": tuple(_mm(value) for value in event.point),
    }
    found = _told(rule, severity, headline, where, event, event.deepest_s, data, hints, run)
    assert found.moment is not None
    return replace(found, moment=found.moment._replace(deepest=True))


def _who_and_when(event: ContactEvent | NearMiss) -> dict[str, Datum]:
    return {
        "first": event.first,
        "second": event.second,
        "part": event.parts[0],
        "other_part": event.parts[1],
        "start_s": _s(event.start_s),
        "end_s": _s(event.end_s),
        "held": event.held,
    }


def _told(
    rule: Rule,
    severity: Severity,
    headline: str,
    where: str,
    event: ContactEvent | NearMiss,
    time_s: float,
    data: Mapping[str, Datum],
    hints: tuple[str, ...],
    run: RunRecord | None,
) -> Diagnostic:
    cause = event.cause
    configuration = () if run is None else _configuration(run.timeline.segments, time_s)
    return Diagnostic(
        rule,
        severity,
        headline,
        None if cause is None else Label(cause.span, where),
        notes=(where,) if cause is None else (),
        help=hints,
        moment=Moment(time_s, configuration, sides(event)),
        data=MappingProxyType(data),
    )


def _configuration(segments: Sequence[Segment], time_s: float) -> tuple[float, ...]:
    """Return joint positions [rad] and hand opening [m] at a time."""
    at = max(bisect_right(segments, time_s, key=lambda segment: segment.start_s) - 1, 0)
    segment = segments[at]
    u = min(max(time_s, segment.start_s), segment.end_s) - segment.start_s
    return tuple(sum(c * u**power for power, c in enumerate(row)) for row in segment.coefficients)
