"""From a download to the plan of marking it on other machines."""

from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.marking.class_marks import entries
from vrts.marking.intake.tree.opening import open_place
from vrts.marking.marking import mark_class
from vrts.marking.remote.plan import Plan, make_plan
from vrts.marking.submission.marker import Marker
from vrts.marking.whole_class import HowTo, table_for, take_in_class


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
    with open_place(submissions) as tree, TemporaryDirectory(prefix="vrts-") as staging:
        table = table_for(submissions, tree, None, how)
        taken = take_in_class(
            task,
            tree,
            table.path,
            lambda asked: mark_class(marker, asked, None, jobs=how.jobs, staging=Path(staging)),
            how,
        )
        plan = make_plan(marker, tuple(entries(tree, taken.rows)), shards)
    return PlannedClass(plan, (*table.remarks, *taken.remarks), taken.warnings)
