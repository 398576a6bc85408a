"""The rows of a class of which every room has had a session."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from vrts.live.logs.class_sessions import NOTHING, RoomSession
from vrts.live.logs.session_marker import SessionMarker, session_to_bytes
from vrts.marking.by_hand.by_hand import NOBODY, load_by_hand, with_by_hand
from vrts.marking.layout import Layout
from vrts.marking.marking import Entry, mark_class
from vrts.marking.result import Kind
from vrts.marking.row import OF_SESSION, HandedIn, Lateness, Row, Student, row_of

UNJUDGED = Lateness(
    0,
    "0",
    "lateness of sessions is not judged, and being late costs points",
    review=True,
    untimed=True,
)


def mark_sessions(
    marker: SessionMarker,
    rooms: Sequence[RoomSession],
    layout: Layout | None,
    *,
    jobs: int,
    again: bool,
) -> Iterator[tuple[Row, bool]]:
    """Yield the row of every room once it is marked, and whether it was marked before.

    Args:
        marker: Of the task.
        rooms: What to mark.
        layout: Where results go; None: nowhere.
        jobs: Processes at a time.
        again: Whether to mark also what is there already.

    Raises:
        Refused: The changes by hand have errors.
    """
    names = [room.identifier for room in rooms]
    changes = NOBODY if layout is None else load_by_hand(layout, names)
    task = marker.whole.task
    assert task is not None
    by_name = {room.identifier: room for room in rooms}
    with TemporaryDirectory(prefix="vrts-") as staging:
        asked = tuple(map(_entry, rooms))
        for done in mark_class(
            marker, asked, layout, jobs=jobs, again=again, staging=Path(staging)
        ):
            room = by_name[done.entry.identifier]
            late = None if task.late is None or not done.result.mark else UNJUDGED
            handed_in = HandedIn(room.origin, OF_SESSION)
            row = row_of(done.result, Student(name=room.name), handed_in, late)
            yield with_by_hand(row, changes), done.reused


def _entry(room: RoomSession) -> Entry:
    """Return what is marked of a room."""
    if room.session is not None:
        return Entry(room.identifier, room.name, session_to_bytes(room.session))
    kind = Kind.MISSING if room.problem == NOTHING else Kind.AMBIGUOUS
    return Entry(room.identifier, room.name, None, kind, room.problem)
