"""Marks submissions one after another: a row for each, whatever it contains."""

import traceback
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.check.grade import Status
from vrts.check.mark import ungraded
from vrts.marking.submissions import Submission
from vrts.pipeline.assess import assess
from vrts.pipeline.files import CannotRead
from vrts.pipeline.settings import Setting
from vrts.report.assessment import Assessment

UNREADABLE = Rule("V191", "unreadable-file")
FAULT = Rule("V192", "fault-in-vrts")


@dataclass(frozen=True, slots=True)
class Marked:
    """One row of results."""

    submission: Submission
    assessment: Assessment
    fault: str | None  # traceback of a fault in vrts itself


def mark_all(
    submissions: Sequence[Submission],
    setting: Setting,
    *,
    collisions: bool = True,
    done: Callable[[Marked], None] = lambda _: None,
) -> list[Marked]:
    """Mark every submission; `done` is told each row as it comes."""
    rows: list[Marked] = []
    for submission in submissions:
        row = mark(submission, setting, collisions=collisions)
        rows.append(row)
        done(row)
    return rows


def mark(submission: Submission, setting: Setting, *, collisions: bool = True) -> Marked:
    """Mark one submission; where there are hidden scenes, the lowest mark counts.

    The one place where any exception is caught: a fault of ours in one submission must not cost the
    others their marks. The row says so, and the traceback is kept.
    """
    try:
        found = _assessed(submission, setting, collisions=collisions)
        for variant in setting.variants:
            other = _assessed(submission, variant, collisions=collisions)
            if _mark_of(other) < _mark_of(found):
                found = other
    except CannotRead as problem:
        said = problem.message.replace(str(submission.path), submission.title)
        why = error(UNREADABLE, said, help=problem.hints)  # names no folder of this machine
        return Marked(submission, _nothing(submission, setting, why), None)
    except Exception:
        why = error(
            FAULT,
            "vrts itself failed on this submission",
            help=("send the file `fault.txt` beside this report to the makers of vrts",),
        )
        return Marked(submission, _nothing(submission, setting, why), traceback.format_exc())
    return Marked(submission, found, None)


def _assessed(submission: Submission, setting: Setting, *, collisions: bool) -> Assessment:
    return assess(
        submission.path,
        setting=setting,
        identifier=submission.identifier,
        title=submission.title,
        collisions=collisions,
    )


def _mark_of(a: Assessment) -> Fraction:
    return Fraction(0) if a.grade is None else a.grade.mark


def _nothing(submission: Submission, setting: Setting, why: Diagnostic) -> Assessment:
    return Assessment(
        submission.identifier,
        submission.title,
        None,
        (why,),
        scene=setting.scene,
        task=setting.task,
        grade=ungraded(Status.UNREADABLE, (why,)),
    )


def write_atomically(path: Path, data: bytes) -> None:
    """Write a file so that it is there whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    draft = path.with_name(path.name + ".part")
    draft.write_bytes(data)
    draft.replace(path)
