"""Assessments as JSON, for programs. Every document names its schema.

Times in s, lengths in mm, angles in degrees, rounded by the shared rule; marks and points as
numbers and, exactly, as fractions.
"""

from fractions import Fraction

from vrts.base.units import mm
from vrts.check.mark.grade import Grade
from vrts.check.verdict import Clearance, CollisionReport, ContactEvent, NearMiss, Verdict, sides
from vrts.controllers.model import ControllerModel
from vrts.controllers.values import digest
from vrts.engine.memory.events import Cause
from vrts.report.assessment import Assessment
from vrts.report.audience import Audience
from vrts.report.because import because, told_to
from vrts.report.first_screen import first_screen, status
from vrts.report.formats.diagnostic_json import Json, diagnostic_json
from vrts.report.formats.why_json import links_json
from vrts.report.quantities import millimetres, rounded_data, seconds
from vrts.report.review import review_of

ASSESSMENT_SCHEMA = "vrts.assessment/1"


def result_json(a: Assessment) -> Json:
    """Return the row of an assessment: what a list of marks needs."""
    screen = first_screen(a)
    grade = a.grade
    return {
        "id": a.identifier,
        "title": a.title,
        "status": status(a),
        "mark": float(grade.mark) if grade else None,
        "ready": screen.ready,
        "cause": screen.cause,
        "hint": screen.hint,
        "line": screen.span.line if screen.span else None,
        "time_s": seconds(screen.moment.time_s) if screen.moment else None,
        "duration_s": _time(grade.duration_s if grade else None),
        "losses": _losses(grade) if grade else [],
        "review": _review(a),
    }


def assessment_json(a: Assessment) -> Json:
    """Return all that is known about one program, but for the motion itself."""
    screen = first_screen(a)
    return {
        "schema": ASSESSMENT_SCHEMA,
        **result_json(a),
        **_because(a),
        "ready_in": screen.ready_in or None,
        "obstacles": list(screen.obstacles),
        "task": a.task and {"name": a.task.name, "title": a.task.title, "sha256": a.task.digest},
        "scene": a.scene and {"name": a.scene.name, "sha256": a.scene.digest},
        "controller": a.scene and _controller(a.scene.controller),
        "parts": _parts(a.grade) if a.grade else None,
        "run": _run(a),
        "verdicts": [_verdict(v) for v in a.judgement.verdicts] if a.judgement else [],
        "collisions": _collisions(a),
        "findings": [diagnostic_json(d) for d in a.findings],
    }


def _because(a: Assessment) -> Json:
    """Return the losses with what led to each, as far as the task lets students read it."""
    if a.grade is None or not a.chains:
        return {}
    level = told_to(a, Audience.STUDENT)
    losses = zip(_losses(a.grade), because(a), strict=True)
    return {"losses": [{**loss, "because": links_json(chain, level)} for loss, chain in losses]}


def _review(a: Assessment) -> Json | None:
    """Return between which marks the mark lies, and why somebody has to look."""
    review = review_of(a)
    if review is None:
        return None
    lowest, highest = review.lowest, review.highest
    return {
        "lowest": None if lowest is None else float(lowest),
        "highest": None if highest is None else float(highest),
        "reasons": list(review.reasons),
    }


def _losses(grade: Grade) -> list[Json]:
    return [
        {
            **_exact("points", loss.points),
            "kind": loss.kind,
            "sentence": loss.sentence,
            "hint": loss.hint or None,
            "line": loss.span.line if loss.span else None,
            "time_s": seconds(loss.moment.time_s) if loss.moment else None,
        }
        for loss in grade.losses
    ]


def _parts(grade: Grade) -> Json:
    return {
        **_exact("targets", grade.targets),
        **_exact("vias", grade.vias),
        **_exact("contacts", grade.contacts),
        **_exact("demands", grade.demands),
        **_exact("time", grade.time),
    }


def _exact(name: str, value: Fraction) -> Json:
    return {name: round(float(value), 6), f"{name}_exact": str(value)}


def _run(a: Assessment) -> Json | None:
    run = a.run
    if run is None:
        return None
    return {
        "ending": run.ending.value,
        "ended_s": _time(run.ended_s),
        "horizon_s": _time(run.horizon_s),
        "motions": len(run.motions),
        "segments": len(run.timeline.segments),
    }


def _verdict(v: Verdict) -> Json:
    return {
        "check": v.check,
        "answer": v.answer.value,
        "summary": v.summary,
        "findings": [d.rule.code for d in v.findings],
        "evidence": rounded_data(v.evidence),
    }


def _collisions(a: Assessment) -> Json | None:
    report: CollisionReport | None = a.judgement.collisions if a.judgement else None
    if report is None:
        return None
    return {
        "certified": report.certified,
        "contacts": [_contact(c) for c in report.contacts],
        "grazes": [_contact(c) for c in report.grazes],
        "undetermined": [_contact(c) for c in report.undetermined],
        "near_misses": [_near_miss(m) for m in report.near_misses],
        "near_miss_mm": None if report.near_miss_m is None else millimetres(report.near_miss_m),
        "near_miss_assumed": report.near_miss_assumed,
        "clearance": _clearance(report.clearance) if report.clearance else None,
        "engine": report.engine,
        "disagreements": list(report.disagreements),
        "statistics": dict(report.statistics),
    }


def _contact(c: ContactEvent) -> Json:
    return {
        "bodies": list(sides(c)),
        "parts": list(c.parts),
        "start_s": seconds(c.start_s),
        "end_s": seconds(c.end_s),
        "deepest_s": seconds(c.deepest_s),
        "depth_mm": millimetres(c.depth_m),
        "point_mm": [millimetres(x) for x in c.point],
        "held": c.held,
        "line": _line(c.cause),
    }


def _near_miss(m: NearMiss) -> Json:
    return {
        "bodies": list(sides(m)),
        "parts": list(m.parts),
        "start_s": seconds(m.start_s),
        "end_s": seconds(m.end_s),
        "nearest_s": seconds(m.nearest_s),
        "distance_mm": millimetres(m.distance_m),
        "witnesses_mm": [[millimetres(x) for x in point] for point in m.witnesses],
        "held": m.held,
        "line": _line(m.cause),
    }


def _clearance(c: Clearance) -> Json:
    return {
        "distance_mm": millimetres(c.distance_m),
        "tolerance_mm": round(mm(c.tolerance_m), 4),
        "time_s": seconds(c.time_s),
        "bodies": list(c.bodies),
        "witnesses_mm": [[millimetres(x) for x in point] for point in c.witnesses],
    }


def _controller(model: ControllerModel) -> Json:
    return {"name": model.name, "sha256": digest(model)}


def _line(cause: Cause | None) -> int | None:
    return cause.span.line if cause else None


def _time(time_s: float | None) -> float | None:
    return None if time_s is None or time_s == float("inf") else seconds(time_s)
