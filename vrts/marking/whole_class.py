"""The marking of a class from the download to the list of marks."""

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import replace
from datetime import datetime, tzinfo
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.check.task.late_rules import Keep, LateRules
from vrts.check.task.task import Task
from vrts.marking.about import NAME as ABOUT
from vrts.marking.about import from_bytes as about_from_bytes
from vrts.marking.by_hand.by_hand import (
    NOBODY,
    all_lapses,
    later_deadlines,
    load_by_hand,
    with_by_hand,
)
from vrts.marking.class_marks import (
    Mark,
    class_row,
    entries,
    nothing_late,
    with_best_attempts,
)
from vrts.marking.intake.clock import settled, zone_of
from vrts.marking.intake.exam import counted
from vrts.marking.intake.given import given_to_all
from vrts.marking.intake.row import Intake, Kind
from vrts.marking.intake.row import Row as Found
from vrts.marking.intake.tables.edited_table import read_rows
from vrts.marking.intake.tables.intake_table import write_rows
from vrts.marking.intake.tables.own_table import OwnTable, own_table, remark_on
from vrts.marking.intake.tables.roster import read_roster
from vrts.marking.intake.take_in import take_in_tree
from vrts.marking.intake.tree.opening import Tree, open_place
from vrts.marking.layout import Layout, write_atomically
from vrts.marking.marking import Done, Entry, mark_class
from vrts.marking.privacy.pseudonyms import (
    NAMES,
    key_for,
    names_table,
    pseudonym,
    pseudonymised,
    write_names,
)
from vrts.marking.remote.backend import Backend
from vrts.marking.remote.mark_on_dask import mark_on_dask
from vrts.marking.result import Damaged
from vrts.marking.row import Class, Row
from vrts.marking.submission.marker import Marker
from vrts.marking.supervise.scratch import scratch_folder
from vrts.marking.variants.doubts import doubts_of, with_doubt
from vrts.marking.variants.of_class import MarkerOfClass
from vrts.pipeline.files import CannotRead, read_bytes
from vrts.pipeline.refused import Refused


class HowTo(NamedTuple):
    """How a class is marked."""

    jobs: int = 1
    again: bool = False  # also what is marked already
    table: Path | None = None  # intake.csv as edited; None: that of the download, if there is one
    backend: Backend | None = None  # a cluster; None: this machine
    roster: Path | None = None  # the class, as Moodle or Canvas export it
    zone: tzinfo | None = None  # of times without one; None: that of the task's deadline
    pseudonyms: bool = False  # ids and files get other names; who is who stands in one table
    variants_key: Path | None = None  # of a task with variants; None: that beside the task
    only: frozenset[str] | None = None  # ids of the intake; None: everybody, and its table too


USUAL = HowTo()


class Marked(NamedTuple):
    """A class that is marked."""

    rows: Class
    done: tuple[Done, ...]  # in the order of the rows
    remarks: tuple[str, ...]  # of the intake
    warnings: tuple[Diagnostic, ...]  # of the edited table, of the cluster, and of overrides
    intake_sha256: str  # of the table as written; "": it was edited, and is to be obeyed again
    groups: dict[str, str]  # by id, the same for those who handed in together; "": alone


def mark_whole_class(
    marker: Marker,
    submissions: Path | Sequence[Path],
    layout: Layout | None,
    how: HowTo,
    *,
    begun: Callable[[Sequence[str]], None] = lambda _: None,
    told: Callable[[Done, Row], None] = lambda _, __: None,
) -> Marked:
    """Mark a class, and write for every submission what belongs to it.

    Args:
        marker: Of the task.
        submissions: A folder, a zip, or a list of files.
        layout: Where the results go; None: nowhere.
        how: Processes, what to mark again, the edited table, on which cluster.
        begun: Told the ids of all submissions, in the order of the rows.
        told: Told each submission as it is done, with its row in the list of marks.

    Raises:
        CannotRead: There is nothing of the kind.
        Refused: The edited table or the changes by hand have errors, or there is no such cluster.
    """
    said: list[Diagnostic] = []
    task = marker.whole.task
    assert task is not None
    with open_place(submissions) as tree, scratch_folder() as staging:
        mark = _marking(marker, how, staging, said.append)
        own = of_class(marker)
        variants = staging / "variants" if layout is None else layout.variants
        table, about_table = table_for(submissions, tree, layout, how)
        taken = take_in_class(
            task,
            tree,
            table,
            lambda asked: mark(asked, None, None),
            how,
            known=lambda rows: (
                None if own is None else own.assign(rows, variants, some=how.only is not None)
            ),
            later=_later(layout, how),
            given=given_to_all(Path(marker.place.task)),
        )
        named, found, key = taken.rows, taken.rows, None
        if how.pseudonyms and layout is not None:
            key = key_for(layout)
            tree, found = pseudonymised(tree, named, key)
            if own is not None:
                pairs = zip(named, found, strict=True)
                own.renamed({row.identifier: nameless.identifier for row, nameless in pairs})
        if not found:
            what = f"`{name_of(submissions)}` holds" if name_of(submissions) else "the files hold"
            raise CannotRead(f"nothing was handed in: {what} no program", taken.remarks)
        names = [row.identifier for row in found]
        changes = (
            NOBODY if layout is None else load_by_hand(layout, names, task.mark.total, task.late)
        )
        if how.only is not None:
            changes = changes._replace(diagnostics=())  # the others only seem to be unknown
        begun(names)
        done: dict[str, Done] = {}
        rows: dict[str, Row] = {}
        by_name = {row.identifier: row for row in found}
        asked, doubts = tuple(entries(tree, found)), dict[str, str]()
        if own is not None:
            doubts = doubts_of(own, asked, lambda few: mark(few, None, None), nameless=bool(key))
        for made in mark(asked, layout, how.backend):
            one = made if own is None else with_doubt(made, doubts, layout)
            name = one.entry.identifier
            done[name] = one
            rows[name] = with_by_hand(class_row(by_name[name], one.result, task.late), changes)
            told(one, rows[name])
    if key is None:
        written = write_rows(taken.table, download=name_of(submissions))
    else:
        written = names_table(taken.table, key)
    if layout is not None and how.only is None:  # else the table of the others stays
        _write_table(written, layout, nameless=key is not None, edited=table == layout.intake)
    marked = tuple(rows[row.identifier] for row in found)
    return Marked(
        Class("vrts.class/1", task.title, marked, decisions=changes.ledger.counts),
        tuple(done[row.identifier] for row in found),
        (*about_table, *taken.remarks),
        (
            *(own.findings if own is not None else ()),
            *taken.warnings,
            *nothing_late(task.late, found),
            *said,
            *changes.diagnostics,
            *all_lapses(marked, changes),
        ),
        "" if table is not None else sha256(written).hexdigest(),
        {row.identifier: row.group for row in found},
    )


def _marking(
    marker: Marker, how: HowTo, staging: Path, said: Callable[[Diagnostic], None]
) -> Callable[[Sequence[Entry], Layout | None, Backend | None], Iterable[Done]]:
    """Return what marks some of a class: here, or on a cluster."""

    def mark(
        asked: Sequence[Entry], place: Layout | None, cluster: Backend | None
    ) -> Iterable[Done]:
        jobs, again = how.jobs, how.again
        if cluster is not None:
            return mark_on_dask(marker, asked, place, cluster, jobs=jobs, again=again, said=said)
        return mark_class(marker, asked, place, jobs=jobs, again=again, staging=staging)

    return mark


def _write_table(written: bytes, layout: Layout, *, nameless: bool, edited: bool) -> None:
    """Write who handed in what; a table that somebody has edited stays as it is."""
    if nameless:
        write_names(layout.staff, written)
    elif not edited:
        write_atomically(layout.intake, written)


def of_class(marker: Marker) -> MarkerOfClass | None:
    """Return what marks each student by an own variant; None where all have one task.

    Raises:
        CannotRead: The task has variants, and nobody has said whose is whose.
    """
    assert marker.whole.task is not None
    if isinstance(marker, MarkerOfClass):
        return marker
    if marker.whole.task.variants is None:
        return None
    hint = "`vrts grade TASK SUBMISSIONS --roster LIST -o OUT` does"
    raise CannotRead("each student has a variant of this task: this does not mark by it", (hint,))


class TakenIn(NamedTuple):
    """Who handed in what, as the teacher wants it marked."""

    rows: tuple[Found, ...]
    remarks: tuple[str, ...]  # of the intake
    warnings: tuple[Diagnostic, ...]  # of the edited table
    table: tuple[Found, ...]  # the same rows with all attempts, to choose among them again
    as_found: tuple[Found, ...]  # before attempts were chosen


def take_in_class(
    task: Task,
    tree: Tree,
    table: Path | None,
    mark: Mark,
    how: HowTo = USUAL,
    known: Callable[[Sequence[Found]], None] = lambda _: None,
    later: Callable[[str], datetime | None] = lambda _: None,
    given: Collection[str] = (),
) -> TakenIn:
    """Return the rows of a class: those of the edited table, with the attempts that count.

    Args:
        task: What it is marked by.
        tree: The download.
        table: As edited; None: there is none.
        mark: Marks attempts without writing anything.
        how: The class's list, and the zone of times.
        known: Told the rows before anything is marked.
        later: Returns the later deadline that graders gave to an id, by which attempts count.
        given: Programs that students were given: no hand-in where there is another one.

    Raises:
        CannotRead: The table or the list is not there.
        Refused: The table has errors.
    """
    zone = how.zone or zone_of(task.late)
    roster = how.roster and read_roster(read_bytes(how.roster), how.roster.name, zone)
    intake = take_in_tree(tree, program=task.program, zone=zone, roster=roster, given=given)
    intake = settled(intake, task.late, zone)
    found, warnings = _as_edited(tree, intake, table)
    if how.only is not None:
        found = tuple(row for row in found if row.identifier in how.only)
    as_found = found
    rows = [extended(row, later(row.identifier), task.late) for row in found]
    found, about_exam = counted(rows, task.late)
    known(found)
    if task.keep is Keep.BEST:
        found = with_best_attempts(tree, found, task.late, mark)
    pairs = tuple(zip(as_found, found, strict=True))
    found = tuple(replace(now, due=was.due, chosen_by=now.due) for was, now in pairs)
    for_table = tuple(_for_table(was, now) for was, now in pairs)
    return TakenIn(found, intake.remarks, (*warnings, *about_exam), for_table, as_found)


def _for_table(was: Found, now: Found) -> Found:
    """Return a row that tells what counts, and keeps all that may count by another deadline."""
    if was.problem is not None and was.problem.kind is Kind.AMBIGUOUS:
        return replace(was, why=now.why)
    attempts = was.attempts
    if attempts and was.problem is None and was.received is not None:
        attempts = (*attempts[:-1], attempts[-1]._replace(received=was.received))
    return replace(
        was,
        file=now.file,
        received=now.received,
        why=now.why,
        problem=now.problem,
        attempts=attempts,
    )


def extended(row: Found, later: datetime | None, rules: LateRules | None) -> Found:
    """Return a row with a later deadline; one that is earlier than what it has changes nothing."""
    if later is None or rules is None:
        return row
    return replace(row, due=max(row.due or rules.due, later))


def _later(layout: Layout | None, how: HowTo) -> Callable[[str], datetime | None]:
    """Return what tells the later deadline of an id, which may stand under its pseudonym."""
    given = {} if layout is None else later_deadlines(layout)
    if not given or layout is None or not how.pseudonyms:
        return given.get
    key = key_for(layout)
    return lambda identifier: given.get(pseudonym(identifier, key))


def table_for(
    submissions: Path | Sequence[Path], tree: Tree, layout: Layout | None, how: HowTo
) -> OwnTable:
    """Return the edited table: the one given, that of the download, or of an earlier marking.

    Raises:
        CannotRead: It cannot be read.
    """
    if not isinstance(submissions, Path):
        return OwnTable(how.table)
    if how.table is not None:
        return OwnTable(how.table, remark_on(how.table, submissions))
    found = own_table(submissions, tree)
    if found.path is None and layout is not None:
        own = layout.staff / NAMES if how.pseudonyms else layout.intake
        if own.is_file() and was_edited(layout, own):
            return found._replace(path=own)
    return found


def name_of(submissions: Path | Sequence[Path]) -> str:
    """Return the name of a download; files named one by one have none."""
    return submissions.absolute().name if isinstance(submissions, Path) else ""


def was_edited(layout: Layout, table: Path) -> bool:
    """Return whether somebody changed the table that an earlier marking wrote."""
    try:
        before = about_from_bytes((layout.staff / ABOUT).read_bytes()).intake_sha256
        return sha256(table.read_bytes()).hexdigest() != before
    except (OSError, Damaged):
        return False


def _as_edited(
    tree: Tree, intake: Intake, table: Path | None
) -> tuple[tuple[Found, ...], tuple[Diagnostic, ...]]:
    if table is None:
        return intake.rows, ()
    edited = read_rows(read_bytes(table), table.name, tree, intake)
    if edited.rows is None:
        raise Refused(edited.diagnostics)
    return edited.rows, edited.diagnostics
