"""Marks one program, whatever it contains."""

import traceback
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple, TypeAlias

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.check.mark.grade import Status
from vrts.check.mark.mark import ungraded
from vrts.marking.proposer.by_name import ALONE, By
from vrts.marking.result import Record
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Checks, Request
from vrts.pipeline.setting import Setting
from vrts.report.assessment import Assessment

UNREADABLE = Rule("V191", "unreadable-file")
FAULT = Rule("V192", "fault-in-vrts")


class NotMarkable(Exception):  # noqa: N818 -- names the situation
    """There is nothing that could be marked, by nobody's fault; the text says why."""


class Order(NamedTuple):
    """A program to mark."""

    identifier: str  # unique, safe for file names
    title: str  # as shown
    data: bytes
    whose: str = ""  # of whose attempts it is one; "": the identifier tells


class Wanted(Record, frozen=True):
    """What is to be made of every program."""

    collisions: bool = True
    engine: str | None = None
    pages: bool = True
    recordings: bool = False
    mending: int = 0  # executions of changed programs at most, to find what would mend one


@dataclass(frozen=True, slots=True)
class Marked:
    """What was found out about a program."""

    assessment: Assessment
    fault: str | None  # traceback of a fault in vrts itself


Assessed: TypeAlias = Callable[[Order, Setting, Wanted, By], Assessment]


def assessed(order: Order, setting: Setting, wanted: Wanted, by: By) -> Assessment:
    """Compile, run, check and mark a program."""
    return assess(
        Request(
            ProgramFile(order.data, order.title),
            setting,
            checks=Checks(
                collisions=wanted.collisions,
                proposer=by.proposer,
                second=by.second,
                causes=wanted.pages,
            ),
            identifier=order.identifier,
        )
    )


def mark(
    order: Order,
    setting: Setting,
    wanted: Wanted,
    by: By = ALONE,
    assessed: Assessed = assessed,
) -> Marked:
    """Mark a program, or whatever `assessed` knows; of hidden scenes the lowest mark counts.

    The one place where any exception is caught: a fault of ours must not look like one of the
    student's. The row says so, and the traceback is kept. Memory that is used up is no fault.
    """
    try:
        found = assessed(order, setting, wanted, by)
        for variant in setting.variants:
            other = assessed(order, variant, wanted, by)
            if _mark_of(other) < _mark_of(found):
                found = other
    except (MemoryError, NotMarkable):
        raise
    except Exception:
        why = error(
            FAULT,
            "vrts itself failed on this submission",
            help=("send the file `fault.txt` beside the grader's report to the makers of vrts",),
        )
        return Marked(_nothing(order, setting, why), traceback.format_exc())
    return Marked(found, None)


def refused(identifier: str, title: str, sentence: str, setting: Setting) -> Marked:
    """Return what there is to say of a file that is no program."""
    why = error(UNREADABLE, sentence)
    return Marked(_nothing(Order(identifier, title, b""), setting, why), None)


def _mark_of(a: Assessment) -> Fraction:
    return Fraction(0) if a.grade is None else a.grade.mark


def _nothing(order: Order, setting: Setting, why: Diagnostic) -> Assessment:
    assert setting.task is not None
    return Assessment(
        order.identifier,
        order.title,
        None,
        (why,),
        scene=setting.scene,
        task=setting.task,
        grade=ungraded(setting.task, Status.UNREADABLE, (why,)),
    )
