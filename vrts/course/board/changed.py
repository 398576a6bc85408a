"""What has changed between two boards, so that a page that follows is told that alone."""

import msgspec

from vrts.course.board.told import BoardTold, CauseTold, ColumnTold, StudentTold, WaitTold


class Changed(msgspec.Struct, frozen=True, omit_defaults=True):
    """An event `changed`; what is null stays as it was."""

    now: float
    students: tuple[StudentTold, ...] = ()  # rows that are new or others
    gone: tuple[int, ...] = ()  # accounts whose rows are no more
    columns: tuple[ColumnTold, ...] | None = None
    causes: tuple[CauseTold, ...] | None = None
    waits: tuple[WaitTold, ...] | None = None


def changed(before: BoardTold, after: BoardTold) -> Changed | None:
    """Return what is another; None: nothing."""
    if before is after:
        return None
    old = {row.id: row for row in before.students}
    new = {row.id for row in after.students}
    found = Changed(
        after.now,
        tuple(row for row in after.students if old.get(row.id) != row),
        tuple(id_ for id_ in old if id_ not in new),
        None if before.columns == after.columns else after.columns,
        None if before.causes == after.causes else after.causes,
        None if before.waits == after.waits else after.waits,
    )
    return None if found == Changed(after.now) else found
