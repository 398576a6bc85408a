"""From a download to the plan of marking it on other machines, and back to the list of marks."""

from collections.abc import Iterable, Sequence
from datetime import datetime
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

from msgspec import structs

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.check.task.late_rules import Keep
from vrts.check.task.task import Task
from vrts.marking.by_hand.by_hand import (
    all_lapses,
    later_deadlines,
    load_by_hand,
    with_by_hand,
)
from vrts.marking.class_marks import class_row, entries, nothing_late
from vrts.marking.intake.exam import counted
from vrts.marking.intake.given import given_to_all
from vrts.marking.intake.row import Row as Found
from vrts.marking.intake.tables.intake_table import write_rows
from vrts.marking.intake.tree.opening import open_place
from vrts.marking.layout import RESULT, Layout, write_atomically
from vrts.marking.marking import Done, Entry, mark_class
from vrts.marking.remote.at_home import AtHome
from vrts.marking.remote.plan import Key, Plan, make_plan
from vrts.marking.result import from_bytes
from vrts.marking.row import Class
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.setting import Place
from vrts.marking.supervise.scratch import scratch_folder
from vrts.marking.variants.doubts import doubts_of, with_doubt
from vrts.marking.variants.marker import write_variants
from vrts.marking.whole_class import (
    HowTo,
    Marked,
    extended,
    name_of,
    of_class,
    table_for,
    take_in_class,
    was_edited,
)
from vrts.pipeline.refused import Refused

OTHER_TASK = Rule("V732", "task-changed-after-the-plan")
OTHER_TABLE = Rule("V733", "table-edited-after-the-plan")
MORE_TIME = Rule("V829", "more-time-after-the-plan")
NAMED = 10  # students in a note
LISTS_NOT_WRITTEN = "results are merged; lists of marks are not written"


class PlannedClass(NamedTuple):
    """A plan, and what there is to say about it."""

    plan: Plan
    remarks: tuple[str, ...]  # of the intake
    warnings: tuple[Diagnostic, ...]  # of the edited table


def plan_class(
    marker: Marker, submissions: Path | Sequence[Path], shards: int, how: HowTo
) -> PlannedClass:
    """Return the plan of a class.

    Where the best of several attempts counts they are marked here, to choose one of them.

    Args:
        marker: Of the task.
        submissions: A folder, a zip, or a list of files.
        shards: How many there are to be.
        how: Processes here, the edited table, the list of the class, the zone of times.

    Raises:
        CannotRead: There is nothing of the kind, or the task cannot be taken along.
        Refused: The edited table has errors.
    """
    task = marker.whole.task
    assert task is not None
    with open_place(submissions) as tree, scratch_folder() as staging:
        table = table_for(submissions, tree, None, how)
        own, variants = of_class(marker), staging / "variants"

        def mark(asked: Sequence[Entry]) -> Iterable[Done]:
            return mark_class(marker, asked, None, jobs=how.jobs, staging=staging)

        taken = take_in_class(
            task,
            tree,
            table.path,
            mark,
            how,
            known=lambda rows: None if own is None else own.assign(rows, variants),
            given=given_to_all(Path(marker.place.task)),
        )
        found = tuple(entries(tree, taken.rows))
        doubts = {} if own is None else doubts_of(own, found, mark)
        packed = {path.stem: path.read_bytes() for path in sorted(variants.glob("*.zip"))}
        plan = make_plan(marker, found, shards)
    remarks = (*table.remarks, *taken.remarks)
    home = AtHome(
        _absolute(marker.place),
        (str(submissions),) if isinstance(submissions, Path) else tuple(map(str, submissions)),
        marker.wanted,
        taken.rows,
        found,
        remarks,
        write_rows(taken.table, download=name_of(submissions)),
        table.path is not None,
        packed,
        doubts,
        taken.as_found,
    )
    plan = plan._replace(key=structs.replace(plan.key, home=home))
    unknown = () if own is None else own.findings
    late = nothing_late(task.late, taken.rows)
    return PlannedClass(plan, remarks, (*unknown, *taken.warnings, *late))


def planned_marker(key: Key, home: AtHome) -> Marker:
    """Return what marks by the task of a plan, where it is now.

    Raises:
        CannotRead: The task is not there any more.
        Refused: It has errors, or is another than it was.
    """
    marker = Marker(home.place, home.wanted)
    assert marker.whole.task is not None
    now = marker.whole.task.digest, marker.whole.scene.digest
    if now == (key.staff.task.sha256, key.staff.scene.sha256):
        return marker
    headline = f"the task `{home.place.task}` was changed after the plan"
    note = "results are merged; lists of marks are not written, since they would mix two tasks"
    remedies = ("put the task back as it was and merge again, or plan again",)
    raise Refused((error(OTHER_TASK, headline, notes=(note,), help=remedies),))


def merged_class(marker: Marker, home: AtHome, layout: Layout) -> Marked:
    """Return a class whose results were all merged, as marking it here would; write its intake.

    Args:
        marker: Of the task.
        home: What stayed at home.
        layout: Where the results are.

    Raises:
        Refused: The changes by hand have errors; or since the plan the table of the intake was
            edited, or graders gave more time by which another attempt may count.
    """
    task = marker.whole.task
    assert task is not None
    other = layout.intake.is_file() and layout.intake.read_bytes() != home.intake
    if other and was_edited(layout, layout.intake):
        raise _edited_since(layout, home)
    names = [row.identifier for row in home.found]
    changes = load_by_hand(layout, names, task.mark.total, task.late)
    given = later_deadlines(layout)
    moved = [r.identifier for r in home.attempts if _moves(r, given.get(r.identifier), task)]
    if moved:
        raise _more_time(moved, layout, home)
    write_variants(home.variants, layout)
    read = (
        Done(
            entry,
            from_bytes((layout.grader(entry.identifier) / RESULT).read_bytes()),
            from_bytes((layout.student(entry.identifier) / RESULT).read_bytes()),
            True,
            0.0,
            0,
        )
        for entry in home.entries
    )
    done = tuple(with_doubt(one, home.doubts, layout) for one in read)
    rows = tuple(
        with_by_hand(class_row(found, one.result, task.late), changes)
        for found, one in zip(home.found, done, strict=True)
    )
    write_atomically(layout.intake, home.intake)
    return Marked(
        Class("vrts.class/1", task.title, rows, decisions=changes.ledger.counts),
        done,
        home.remarks,
        (
            *nothing_late(task.late, home.found),
            *changes.diagnostics,
            *all_lapses(rows, changes),
        ),
        "" if home.edited else sha256(home.intake).hexdigest(),
        {row.identifier: row.group for row in home.found},
    )


def _absolute(place: Place) -> Place:
    """Return where a task is, from wherever it is asked for; a scene may be a mere name."""
    return structs.replace(
        place,
        task=str(Path(place.task).absolute()),
        scenario=None if place.scenario is None else str(Path(place.scenario).absolute()),
        lab=None if place.lab is None else str(Path(place.lab).absolute()),
    )


def _moves(row: Found, later: datetime | None, task: Task) -> bool:
    """Return whether a later deadline may make another attempt count than the plan chose."""
    more = extended(row, later, task.late)
    if more.due == row.due or task.late is None:
        return False
    if task.late.is_exam:
        now, then = (counted([one], task.late).rows[0] for one in (row, more))
        return (now.file, now.problem, now.attempts) != (then.file, then.problem, then.attempts)
    due = row.due or task.late.due
    late = any(one.received is None or one.received > due for one in row.attempts)
    return task.keep is Keep.BEST and len(row.attempts) > 1 and late


def _more_time(moved: Sequence[str], layout: Layout, home: AtHome) -> Refused:
    whose = "a student" if len(moved) == 1 else f"{len(moved)} students"
    headline = f"graders gave {whose} more time, and the plan chose attempts without it"
    names = ", ".join(f"`{name}`" for name in moved[:NAMED])
    rest = f" and {len(moved) - NAMED} more" if len(moved) > NAMED else ""
    notes = (f"{names}{rest}: another attempt may count", LISTS_NOT_WRITTEN)
    what = " ".join(home.submissions)
    remedies = (
        f"mark them here with `vrts grade {home.place.task} {what} -o {layout.root}`",
        "or write the time into the column `due` of the intake's table, and plan again",
    )
    return Refused((error(MORE_TIME, headline, notes=notes, help=remedies),))


def _edited_since(layout: Layout, home: AtHome) -> Refused:
    headline = f"`{layout.intake}` was edited after the plan"
    note = "results are merged; lists of marks are not written, since the plan does not know it"
    what = " ".join(home.submissions)
    remedy = f"obey it with `vrts grade {home.place.task} {what} -o {layout.root}`"
    return Refused((error(OTHER_TABLE, headline, notes=(note,), help=(remedy,)),))
