"""For whom a report is: what a student may read, what only those who mark read, and no hints.

A student's version is made of an assessment that has seen public checks only; `for_student` takes
out what is left of the business of marking. Reports never hide what they were given.
"""

from dataclasses import replace
from enum import Enum
from types import MappingProxyType

from vrts.base.diagnostic import Diagnostic
from vrts.check.mark.grade import REVIEW
from vrts.check.rules.hints import Hints, without_remedy
from vrts.check.verdict import Verdict
from vrts.report.assessment import Assessment

BY_A_PERSON = f"{REVIEW} by a person: a check of this run is too close to call"
ENGINE_FACTS = ("disagreements",)  # evidence that is for those who mark


class Audience(Enum):
    """Who reads a report."""

    STUDENT = "student"
    GRADER = "grader"


def for_student(a: Assessment) -> Assessment:
    """Return an assessment without lowest mark and without what two engines say of each other."""
    grade, judgement = a.grade, a.judgement
    if grade is not None:
        obstacles = tuple(BY_A_PERSON if o.startswith(REVIEW) else o for o in grade.obstacles)
        grade = replace(grade, lowest=None, obstacles=tuple(dict.fromkeys(obstacles)))
    if judgement is not None:
        report = judgement.collisions
        if report is not None:
            report = replace(report, disagreements=())
        verdicts = tuple(_without_engines(v) for v in judgement.verdicts)
        judgement = replace(judgement, verdicts=verdicts, collisions=report)
    return replace(a, grade=grade, judgement=judgement)


def as_allowed(a: Assessment, stamps: tuple[Diagnostic, ...] = ()) -> Assessment:
    """Return an assessment without anything that tells a remedy, where the task allows no hints.

    Args:
        a: As found.
        stamps: Of its diagnostics, those about the files of the task: their remedies stay.
    """
    if a.task is None or a.task.hints is not Hints.NOTHING:
        return a
    grade, judgement = a.grade, a.judgement
    if grade is not None:
        grade = replace(grade, losses=tuple(loss._replace(hint="") for loss in grade.losses))
    if judgement is not None:
        verdicts = tuple(
            replace(v, findings=tuple(map(without_remedy, v.findings))) for v in judgement.verdicts
        )
        judgement = replace(judgement, verdicts=verdicts)
    told = tuple(d if d in stamps else without_remedy(d) for d in a.diagnostics)
    return replace(a, diagnostics=told, grade=grade, judgement=judgement)


def hidden_checks(whole: Assessment, public: Assessment) -> frozenset[str]:
    """Return the names of the checks that only one of two assessments of a program has."""
    return _checks(whole) - _checks(public)


def _checks(a: Assessment) -> frozenset[str]:
    return frozenset(v.check for v in a.judgement.verdicts) if a.judgement else frozenset()


def needs_review(a: Assessment) -> bool:
    """Return whether a person has to look at a run before its mark stands."""
    report = a.judgement.collisions if a.judgement else None
    reviewed = a.grade is not None and any(o.startswith(REVIEW) for o in a.grade.obstacles)
    return reviewed or (report is not None and bool(report.disagreements))


def _without_engines(v: Verdict) -> Verdict:
    if not any(key in v.evidence for key in ENGINE_FACTS):
        return v
    evidence = {key: value for key, value in v.evidence.items() if key not in ENGINE_FACTS}
    return replace(v, evidence=MappingProxyType(evidence))
