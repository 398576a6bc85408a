"""A program that was executed, checked and marked."""

from pathlib import Path
from typing import NamedTuple

from vrts.api.errors import public, text_of, wrong_call
from vrts.api.given import File, path_of
from vrts.api.notebook import framed, top_and_replay
from vrts.api.runs import Run, written
from vrts.check.verdict import Answer
from vrts.pipeline.request import Request
from vrts.report.assessment import Assessment as Inner
from vrts.report.audience import Audience
from vrts.report.first_screen import first_screen, status
from vrts.report.formats.json_form import assessment_json
from vrts.report.page.page import page
from vrts.report.page.stills import page_stills
from vrts.report.quantities import millimetres
from vrts.report.screen.assessment_text import assessment_text
from vrts.run_files.simulated import Simulated

ITS_OWN = "an assessment has its own scene, task and scenario"
STUDENT, GRADER = Audience.STUDENT.value, Audience.GRADER.value


class Loss(NamedTuple):
    """Points that were lost, and by what."""

    points: float
    words: str  # one sentence
    line: int | None  # of the program; None: no line is to blame
    time_s: float | None  # when it happened


class Check(NamedTuple):
    """What one check says."""

    name: str  # "collision", "limits", "target can1"
    answer: str  # "holds", "violated" or "undetermined"
    words: str  # one sentence


class Contact(NamedTuple):
    """Two things that touch."""

    first: str
    second: str
    start_s: float
    end_s: float
    depth_mm: float
    line: int | None  # of the program


class Assessment:
    """A program that was executed and checked, and marked where there is a task.

    Made by `vrts.verify` and `vrts.mark`. In a notebook it shows the top of its page, and a replay.
    """

    def __init__(self, found: Inner, request: Request, simulated: Simulated) -> None:
        """Take what was found, what was asked for, and what a file of the run has to tell."""
        self.inner = found
        self._request = request
        self.simulated = simulated

    @property
    def mark(self) -> float | None:
        """The mark; None without a task."""
        grade = self.inner.grade
        return None if grade is None else float(grade.mark)

    @property
    def total(self) -> float | None:
        """All points that there are; None without a task."""
        grade = self.inner.grade
        return None if grade is None else float(grade.total)

    @property
    def status(self) -> str:
        """What became of it, such as "graded", "holds", "violated", "does not compile"."""
        return status(self.inner)

    @property
    def ok(self) -> bool:
        """Whether every check holds and nothing was found to be wrong."""
        judgement = self.inner.judgement
        wrong = any(one.is_error for one in self.inner.findings)
        return judgement is not None and judgement.answer is Answer.HOLDS and not wrong

    @property
    def ready(self) -> bool:
        """Whether nothing speaks against sending it to the real robot."""
        return first_screen(self.inner).ready

    @property
    def cause(self) -> str:
        """What cost most, in a sentence."""
        return first_screen(self.inner).cause

    @property
    def losses(self) -> tuple[Loss, ...]:
        """Where points were lost, most first; they add up to what the mark lacks."""
        return tuple(
            Loss(
                float(one.points),
                one.sentence,
                None if one.span is None else one.span.line,
                None if one.moment is None else one.moment.time_s,
            )
            for one in first_screen(self.inner).losses
        )

    @property
    def checks(self) -> tuple[Check, ...]:
        """What every check says; none where the program does not run."""
        judgement = self.inner.judgement
        verdicts = () if judgement is None else judgement.verdicts
        return tuple(Check(one.check, one.answer.value, one.summary) for one in verdicts)

    @property
    def contacts(self) -> tuple[Contact, ...]:
        """What touches what, by time: no contact is missed, at no instant."""
        report = None if self.inner.judgement is None else self.inner.judgement.collisions
        return tuple(
            Contact(
                one.held or one.first,
                one.second,
                one.start_s,
                one.end_s,
                millimetres(one.depth_m),
                None if one.cause is None else one.cause.span.line,
            )
            for one in (() if report is None else report.contacts)
        )

    @property
    def clearance_mm(self) -> float | None:
        """The smallest distance of what must not touch, in mm; None where it is not known."""
        report = None if self.inner.judgement is None else self.inner.judgement.collisions
        if report is None or report.clearance is None:
            return None
        return millimetres(report.clearance.distance_m)

    @property
    def run(self) -> Run:
        """The run.

        Raises:
            VrtsError: The program does not compile, so nothing ran.
        """
        return Run(self.simulated)

    @property
    def problems(self) -> tuple[str, ...]:
        """Everything that was found, each as the commands show it."""
        return tuple(text_of(one) for one in self.inner.findings)

    @property
    def codes(self) -> tuple[str, ...]:
        """The codes of the problems: `vrts explain CODE` tells more."""
        return tuple(one.rule.code for one in self.inner.findings)

    def to_dict(self) -> dict[str, object]:
        """Return what `vrts verify --json` prints, as values."""
        return assessment_json(self.inner)

    @public
    def save_html(self, path: File, *, reader: str = STUDENT) -> Path:
        """Write the page about the program, with its replay; return its path.

        Args:
            path: The file; one that is there is replaced.
            reader: "student", or "grader": then it has what is to be reviewed.

        Raises:
            VrtsError: The file cannot be written.
        """
        if reader not in (STUDENT, GRADER):
            raise wrong_call(f"`reader` is {STUDENT} or {GRADER}")
        audience = Audience(reader)
        found = self.inner
        place, more = path_of(path), self._request.setting.more
        written(place, page(found, page_stills(found), audience=audience, more=more).encode())
        return place

    def __repr__(self) -> str:
        """Return the answer in a line."""
        said = self.status if self.mark is None else f"{self.mark:g} of {self.total:g}"
        return f"<vrts.Assessment {self.inner.title}: {said}>"

    def __str__(self) -> str:
        """Return what `vrts verify` prints."""
        return assessment_text(self.inner, color=False)

    def _repr_html_(self) -> str:
        """Return the top of the page with the replay, for a notebook."""
        return framed(top_and_replay(self.inner))
