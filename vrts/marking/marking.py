"""Marks a class: a row for every submission, written as it comes.

A result that is there already and depends on nothing that has changed since is not made again, so
an interrupted marking goes on where it was, and a second one marks only what is new.
"""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from vrts.marking.layout import LOST, RESULT, Layout, write_atomically
from vrts.marking.result import Damaged, Kind, Result, from_bytes, to_bytes
from vrts.marking.submission.marker import (
    STAFF,
    STUDENT,
    WRITTEN,
    Marker,
    Marks,
    made_before,
    read_marks,
)
from vrts.marking.submission.one import Order
from vrts.marking.submission.report_files import RECORDING, REPORT
from vrts.marking.supervise.limits import Limits
from vrts.marking.supervise.outcome import Answer, Loss, Lost
from vrts.marking.supervise.staging import remove_unused, staging_folder
from vrts.marking.supervise.supervisor import CAN_FORK, Finished, Supervisor

SEARCH = "the search for what would mend it "  # before why it was ended: the mark stands


class Entry(NamedTuple):
    """A submission as the intake has it: a program, or why there is none."""

    identifier: str  # unique, safe for file names
    title: str  # of the program, as shown
    data: bytes | None
    kind: Kind | None = None  # why there is no program
    sentence: str = ""  # the same in words
    hint: str | None = None
    whose: str = ""  # of whose attempts it is one; "": the identifier tells

    @property
    def student(self) -> str:
        """The identifier of the student whose program it is."""
        return self.whose or self.identifier


class Done(NamedTuple):
    """A submission that has its result."""

    entry: Entry
    result: Result  # for those who mark
    student: Result  # for the student
    reused: bool  # it was there already
    seconds: float  # that it took
    peak: int  # bytes of memory in use


def mark_class(
    marker: Marker,
    entries: Sequence[Entry],
    layout: Layout | None,
    *,
    jobs: int = 1,
    limits: Limits | None = None,
    again: bool = False,
    fork: bool = CAN_FORK,
    staging: Path | None = None,
) -> Iterator[Done]:
    """Yield every submission once, as soon as its files are written.

    Args:
        marker: Of the task.
        entries: What to mark.
        layout: Where the results go; None: nowhere.
        jobs: Processes at a time.
        limits: Of each process.
        again: Whether to mark also what is there already.
        fork: Whether processes are forked, where the system can.
        staging: Folder for what processes write, on the same disk; None: that of the layout.
    """
    if layout is not None:
        remove_unused(layout.staging)
    orders: list[Order] = []
    known: dict[str, Entry] = {}
    for entry in entries:
        if entry.data is None:
            yield without_program(marker, entry, layout)
            continue
        found = None if again or layout is None else reusable(marker, entry, layout)
        if found is not None:
            yield found
            continue
        known[entry.identifier] = entry
        orders.append(Order(entry.identifier, entry.title, entry.data, entry.whose))
    if not orders:
        return
    place = staging if layout is None else layout.staging
    assert place is not None
    with staging_folder(place) as own:
        supervisor = Supervisor(marker, own, jobs=jobs, limits=limits or marker.limits, fork=fork)
        for finished in supervisor.run(orders):
            yield _done(marker, known[finished.order.identifier], finished, layout)
    remove_unused(place)  # again: what a killed marking had started may have ended meanwhile


def _done(marker: Marker, entry: Entry, finished: Finished[Order], layout: Layout | None) -> Done:
    lost = finished.outcome if isinstance(finished.outcome, Lost) else None
    made = None if lost is None else made_before(finished.folder)
    marks = made or _marks(marker, finished)
    if layout is not None:
        place = layout.grader(entry.identifier) / LOST
        if lost is None or made is not None:
            take_files(finished.folder, layout, entry.identifier)
        if lost is None:
            place.unlink(missing_ok=True)
        else:
            what = "" if made is None else SEARCH
            write_atomically(place, f"{what}{lost.loss.value}\n{lost.detail}".encode())
        write_marks(marks, layout)
    return Done(entry, marks.staff, marks.student, False, finished.seconds, finished.peak)


def _marks(marker: Marker, finished: Finished[Order]) -> Marks:
    outcome = finished.outcome
    if isinstance(outcome, Answer):
        try:
            return read_marks(outcome.data)
        except Damaged:
            outcome = Lost(Loss.ANSWER, "")
    return marker.lost(finished.order, f"the process that marked it {outcome.loss.value}")


def take_files(folder: Path, layout: Layout, identifier: str) -> None:
    """Move what a process may have written, and nothing else, to where it belongs."""
    homes = {STUDENT: layout.student(identifier), STAFF: layout.grader(identifier)}
    for name in WRITTEN:
        whose, file = name.split("/")
        draft, place = folder / name, homes[whose] / file
        if draft.is_file() and not draft.is_symlink():
            place.parent.mkdir(parents=True, exist_ok=True)
            draft.replace(place)
        else:
            place.unlink(missing_ok=True)  # of an earlier marking


def write_marks(marks: Marks, layout: Layout) -> None:
    """Write the results, the grader's last: where it is, everything is."""
    name = marks.staff.id
    write_atomically(layout.student(name) / RESULT, to_bytes(marks.student))
    write_atomically(layout.grader(name) / RESULT, to_bytes(marks.staff))


def without_program(marker: Marker, entry: Entry, layout: Layout | None) -> Done:
    """Return the row of a submission in which there is nothing to mark, and write it."""
    assert entry.kind is not None
    if entry.kind is Kind.UNREADABLE and layout is not None:  # it has pages, which say why
        with staging_folder(layout.staging) as folder:
            marks = marker.refused(entry.identifier, entry.title, entry.sentence, folder)
            take_files(folder, layout, entry.identifier)
    else:
        marks = marker.unmarked(entry.kind, entry.identifier, entry.sentence, entry.hint)
    if layout is not None:
        write_marks(marks, layout)
    return Done(entry, marks.staff, marks.student, False, 0.0, 0)


def reusable(marker: Marker, entry: Entry, layout: Layout) -> Done | None:
    """Return what an earlier marking wrote, if it is complete and would be the same now."""
    assert entry.data is not None
    homes = (layout.grader(entry.identifier), layout.student(entry.identifier))
    found: list[Result] = []
    for home in homes:
        try:
            found.append(from_bytes((home / RESULT).read_bytes()))
        except (OSError, Damaged):
            return None
    if (homes[0] / LOST).is_file():  # a mark may stand there, but something was not finished
        return None
    staff, student = found
    data = entry.data
    own = marker.of(entry.student)
    same = (staff.key, student.key) == (own.key(data), own.public_key(data))
    kept = staff.kind not in (Kind.RESOURCE, Kind.FAULT)
    named = staff.program is not None and staff.program.name == entry.title
    if not (same and kept and named) or not _files_there(marker, staff, homes):
        return None
    return Done(entry, staff, student, True, 0.0, 0)


def _files_there(marker: Marker, staff: Result, homes: tuple[Path, Path]) -> bool:
    grader, student = homes
    wanted: list[Path] = []
    if marker.wanted.pages:
        wanted += [grader / REPORT, student / REPORT]
    if marker.wanted.recordings and staff.metrics.horizon_s is not None:
        wanted.append(student / RECORDING)
    return all(place.is_file() for place in wanted)
