"""What graders have granted at the desk: later deadlines and excuses, as the page has to know them.

They stand in the folder of the marking that an assignment names, and are read again after a change.
A file that cannot be read grants nothing: the desk says what is wrong with it.
"""

from collections.abc import Mapping
from datetime import datetime
from pathlib import Path
from typing import Final, NamedTuple

from vrts.course.course import Assignment
from vrts.course.handing.names import folder_in
from vrts.marking.by_hand.decisions.files import read_decisions
from vrts.marking.by_hand.decisions.records import Excuse, Extend
from vrts.marking.by_hand.decisions.state import prepared
from vrts.marking.layout import Layout
from vrts.marking.result import Damaged
from vrts.marking.row import class_from_bytes
from vrts.pipeline.files import CannotRead, read_bytes
from vrts.pipeline.refused import Refused


class Grant(NamedTuple):
    """What was granted to a student."""

    due: datetime | None = None  # a later deadline; None: that of all
    excused: bool = False


NOTHING: Final = Grant()


class Granted:
    """Knows it for every assignment."""

    def __init__(self) -> None:
        """Begin with nothing read."""
        self._known: dict[Path, tuple[object, Mapping[str, Grant]]] = {}

    def to(self, assignment: Assignment, folder: str) -> Grant:
        """Return what was granted to somebody, by the name of the folder of their hand-ins."""
        if assignment.marked is None:
            return NOTHING
        layout = Layout(assignment.marked)
        stamp = _stamp(layout)
        known = self._known.get(layout.root)
        if known is None or known[0] != stamp:
            known = self._known[layout.root] = (stamp, _read(layout))
        return known[1].get(folder, NOTHING)


def _stamp(layout: Layout) -> object:
    paths = [layout.results, *sorted(layout.decisions.glob("*"))]
    return tuple(
        (path.name, path.stat().st_mtime_ns, path.stat().st_size)
        for path in paths
        if path.is_file()
    )


def _read(layout: Layout) -> Mapping[str, Grant]:
    if not layout.results.is_file():
        return {}
    try:
        rows = class_from_bytes(read_bytes(layout.results))
        ledger = read_decisions(layout.decisions)
    except (CannotRead, Damaged, Refused):
        return {}
    if ledger.wrong:
        return {}
    ready = prepared(ledger)
    found: dict[str, Grant] = {}
    for row in rows.rows:
        mine = ready.of(row.id)
        said = [one.said for one in mine.extension]
        dues = [datetime.fromisoformat(one.due) for one in said if isinstance(one, Extend)]
        excused = any(isinstance(one.said, Excuse) for one in mine.mark)
        if dues or excused:
            found[folder_in(row)] = Grant(max(dues, default=None), excused)
    return found
