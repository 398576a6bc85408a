"""Marks by the public checks of a task alone, exactly as the students' result of a marking."""

from dataclasses import replace
from pathlib import Path

import msgspec

from vrts.check.rules.hints import Hints
from vrts.course.handing.spoken import PublicMark
from vrts.live.store.course.attempts import LONGEST_CAUSE, Loss
from vrts.marking.proposer.by_name import by_name
from vrts.marking.result import Kind, Result
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Marked, Order, Wanted, mark
from vrts.marking.submission.setting import Place
from vrts.marking.supervise.limits import Limits
from vrts.pipeline.curve import with_curve
from vrts.report.assessment import Assessment
from vrts.report.audience import Audience, for_student
from vrts.report.because import because, chain_lines, told_to
from vrts.report.page.page import page_parts, replay_scripts
from vrts.report.page.stills import page_stills
from vrts.report.plain import capital, one_line

PAGE = "page.html"  # in the folder that a process writes to
MOST_LOSSES = 60  # that are kept; the page has all
MOST_LINKS = 8  # of a chain
FAULT = "vrts itself failed on this program: tell your teacher, it is kept and counts"
NO_MARK = "there is no mark yet: a person has to look at it"


class PublicMarker(Marker):
    """Marks programs by the checks that students know; reads of the others how many there are."""

    def __init__(self, task: Path) -> None:
        """Read the task.

        Raises:
            CannotRead: A file is not there.
            Refused: Task, scene or scenario have errors.
        """
        super().__init__(Place(str(task)), Wanted())
        self.whole, self.hidden = self.public, frozenset[str]()
        self._warm = False

    @property
    def limits(self) -> Limits:
        """What a process may use: it stands back behind the rooms."""
        return replace(super().limits, niceness=10)

    def warm_up(self) -> None:
        """Load what all programs share, once."""
        if not self._warm:
            super().warm_up()
        self._warm = True

    def work(self, order: Order, folder: Path) -> bytes:
        """Mark, write the page, and answer with the public mark."""
        with by_name(self.wanted.engine, asked=self.wanted.collisions) as by:
            marked = mark(order, self.public, self.wanted, by)
        if marked.fault is None:
            self._write_page(marked.assessment, folder)
        return msgspec.json.encode(self._told(marked, order))

    def _write_page(self, a: Assessment, folder: Path) -> None:
        curved = with_curve(a)
        scripts = replay_scripts(for_student(curved))
        parts = page_parts(
            curved,
            page_stills(a),
            audience=Audience.STUDENT,
            more=self.public.more,
            scripts=scripts,
        )
        with (folder / PAGE).open("wb") as file:
            file.writelines(part.encode() for part in parts)

    def _told(self, marked: Marked, order: Order) -> PublicMark:
        result = self._result(marked, self.public, order.data, student=True)
        if result.kind is Kind.FAULT:
            return PublicMark("failed", said=FAULT)
        level = told_to(marked.assessment, Audience.STUDENT)
        chains = because(marked.assessment) if level is not Hints.NOTHING else ()
        why = [tuple(chain_lines(chain, level)[:MOST_LINKS]) for chain in chains]
        return public_mark(result, why)


def public_mark(result: Result, why: list[tuple[str, ...]]) -> PublicMark:
    """Return a result of the public checks as an attempt keeps it.

    Args:
        result: As students get it.
        why: What led to each loss, in the same order; may be shorter.
    """
    losses = [
        Loss(
            capital(one_line(loss.sentence))[:LONGEST_CAUSE],
            loss.points_exact,
            loss.line,
            loss.time_s,
            one_line(loss.hint or "")[:LONGEST_CAUSE],
            why[k] if k < len(why) else (),
        )
        for k, loss in enumerate(result.losses[:MOST_LOSSES])
    ]
    said = ""
    if result.kind is not Kind.GRADED:
        hint = f"; {one_line(result.hint)}" if result.hint else ""
        said = f"{capital(one_line(result.cause))}{hint}"
    if result.mark is None:
        return PublicMark("failed", said=said or NO_MARK)
    mark = str(result.exact_mark)
    return PublicMark("marked", mark, str(result.exact_total), said, tuple(losses))
