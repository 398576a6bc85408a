"""From everything that is known about a program to its result."""

import hashlib
from collections.abc import Collection
from fractions import Fraction

from vrts import __version__
from vrts.base.diagnostic import Diagnostic
from vrts.check.mark.earned import not_reached
from vrts.check.mark.grade import REVIEW, Grade
from vrts.controllers.values import digest
from vrts.marking.result import (
    SCORING,
    Check,
    Finding,
    Kind,
    Loss,
    Metrics,
    Named,
    Parts,
    Program,
    Result,
    Versions,
)
from vrts.pipeline.setting import Setting
from vrts.report.assessment import Assessment
from vrts.report.first_screen import first_screen
from vrts.report.quantities import millimetres, seconds

MOST_FINDINGS = 500  # of one submission; a hostile one may have any number


def result_of(
    a: Assessment, setting: Setting, data: bytes | None, key: str, hidden: Collection[str] = ()
) -> Result:
    """Return the result of a program that was marked in a setting.

    Args:
        a: What was found, for whoever the result is for.
        setting: Of the task that it was marked by.
        data: The program; None where it could not be had.
        key: Digest of all that the result depends on.
        hidden: Names of the checks that students do not see.
    """
    screen = first_screen(a)
    grade = a.grade
    return Result(
        schema="vrts.result/1",
        id=a.identifier,
        kind=Kind.UNREADABLE if grade is None else Kind(grade.status.value),
        mark=None if grade is None else float(grade.mark),
        lowest=None if grade is None or grade.lowest is None else float(grade.lowest),
        review=tuple(o for o in screen.obstacles if o.startswith(REVIEW)),
        ready=screen.ready,
        obstacles=screen.obstacles,
        cause=screen.cause,
        hint=screen.hint,
        line=screen.span.line if screen.span else None,
        time_s=seconds(screen.moment.time_s) if screen.moment else None,
        parts=None if grade is None else _parts(grade),
        losses=() if grade is None else _losses(grade),
        checks=_checks(grade, setting, hidden),
        metrics=_metrics(a),
        findings=tuple(_finding(d) for d in a.findings[:MOST_FINDINGS]),
        stamps=tuple(d.headline for d in setting.stamps),
        more=setting.more,
        task=task_named(setting),
        scene=Named(setting.scene.name, setting.scene.name, setting.scene.digest),
        program=program_of(a.title, data),
        versions=versions(a),
        key=key,
        controller=controller_named(setting),
        total=_total(setting),
    )


def unmarked(
    kind: Kind, identifier: str, sentence: str, hint: str | None, setting: Setting, key: str
) -> Result:
    """Return the result of a submission that has no mark, because nobody could make one."""
    return Result(
        schema="vrts.result/1",
        id=identifier,
        kind=kind,
        mark=0.0 if kind is Kind.UNREADABLE else None,
        lowest=None,
        review=() if kind in (Kind.MISSING, Kind.EXCUSED, Kind.UNREADABLE) else (sentence,),
        ready=False,
        obstacles=(sentence,),
        cause=sentence,
        hint=hint,
        line=None,
        time_s=None,
        parts=None,
        losses=(),
        checks=(),
        metrics=Metrics(),
        findings=(),
        stamps=tuple(d.headline for d in setting.stamps),
        more=setting.more,
        task=task_named(setting),
        scene=Named(setting.scene.name, setting.scene.name, setting.scene.digest),
        program=None,
        versions=Versions(__version__, SCORING, None),
        key=key,
        controller=controller_named(setting),
        total=_total(setting),
    )


def controller_named(setting: Setting) -> Named:
    """Return how a result names its controller model."""
    model = setting.scene.controller
    return Named(model.name, model.title, digest(model))


def _total(setting: Setting) -> float:
    assert setting.task is not None
    return float(setting.task.mark.total)


def task_named(setting: Setting) -> Named:
    """Return how a result names its task."""
    assert setting.task is not None
    return Named(setting.task.name, setting.task.title, setting.task.digest)


def program_of(title: str, data: bytes | None) -> Program | None:
    """Return how a result names its program."""
    if data is None:
        return None
    return Program(title, hashlib.sha256(data).hexdigest(), len(data))


def versions(a: Assessment) -> Versions:
    """Return with what an assessment was made."""
    report = a.judgement.collisions if a.judgement else None
    return Versions(__version__, SCORING, None if report is None else report.engine)


def _parts(grade: Grade) -> Parts:
    return Parts(
        _points(grade.targets),
        _points(grade.vias),
        _points(grade.contacts),
        _points(grade.demands),
        _points(grade.time),
        _points(grade.limits),
    )


def _checks(grade: Grade | None, setting: Setting, hidden: Collection[str]) -> tuple[Check, ...]:
    assert setting.task is not None
    entries = (grade.earned if grade else ()) or not_reached(setting.task)
    return tuple(
        Check(
            entry.check,
            entry.title,
            entry.kind,
            "not reached" if entry.answer is None else entry.answer.value,
            _points(entry.points),
            _points(entry.most),
            entry.check in hidden,
            entry.message,
        )
        for entry in entries
    )


def _losses(grade: Grade) -> tuple[Loss, ...]:
    return tuple(
        Loss(
            _points(loss.points),
            str(loss.points),
            loss.kind,
            loss.sentence,
            loss.hint or None,
            loss.span.line if loss.span else None,
            seconds(loss.moment.time_s) if loss.moment else None,
        )
        for loss in grade.losses
    )


def _metrics(a: Assessment) -> Metrics:
    report = a.judgement.collisions if a.judgement else None
    clearance = report.clearance if report else None
    duration = a.grade.duration_s if a.grade else None
    return Metrics(
        None if duration is None else seconds(duration),
        None if a.run is None else seconds(a.run.horizon_s),
        None if a.run is None else len(a.run.motions),
        None if report is None else len(report.contacts),
        None if report is None else len(report.near_misses),
        None if clearance is None else millimetres(clearance.distance_m),
    )


def _finding(d: Diagnostic) -> Finding:
    span = d.primary.span if d.primary else None
    return Finding(
        d.rule.code,
        d.rule.slug,
        d.severity,
        d.headline,
        None if span is None else span.line,
        None if span is None else span.column,
        None if d.moment is None else seconds(d.moment.time_s),
        d.help,
    )


def _points(value: Fraction) -> float:
    return round(float(value), 6)
