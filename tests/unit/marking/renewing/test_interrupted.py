"""Whenever writing is interrupted, and whatever is decided meanwhile, files say what is decided."""

from datetime import UTC, datetime
from pathlib import Path

import pytest
from msgspec.structs import replace

from tests.support_desk import write_desk_class
from vrts.marking import class_files
from vrts.marking.appeals.written import read_written
from vrts.marking.by_hand.decisions.files import add_decisions
from vrts.marking.by_hand.decisions.records import Comment, Decision, Undo
from vrts.marking.class_files import begin_class, write_class
from vrts.marking.exports.feedback import NAME as FEEDBACK
from vrts.marking.layout import Layout, write_atomically
from vrts.marking.renewing import renewed as renewing
from vrts.marking.renewing.renewed import brought_up_to_date, pending, renewed, write_marked
from vrts.marking.row import class_from_bytes
from vrts.marking.submission.report_files import REPORT
from vrts.pipeline.refused import Refused

NOW = datetime(2026, 11, 26, 20, tzinfo=UTC)
WORDS = "Look at the grip again."


def add(layout: Layout, *said: Decision) -> str:
    """Decide as R. Huber; return the name of the decision."""
    return add_decisions(layout.decisions, "R. Huber", said, NOW).records[-1].name


def graded(layout: Layout) -> str:
    """Return the id of a row with a page."""
    rows = class_from_bytes(layout.results.read_bytes()).rows
    return next(row.id for row in rows if row.final is not None and row.result.program is not None)


def told(layout: Layout, student: str) -> tuple[bool, bool, bool]:
    """Return whether page, feedback and list have the words."""
    home = layout.student(student)
    rows = class_from_bytes(layout.results.read_bytes()).rows
    decided = next(row.decided for row in rows if row.id == student)
    return (
        WORDS in (home / REPORT).read_text(),
        WORDS in (home / FEEDBACK).read_text(),
        decided is not None and any(one.text == WORDS for one in decided.comments),
    )


def test_what_is_decided_while_a_class_is_marked_is_in_what_the_marking_writes(
    tmp_path: Path,
) -> None:
    layout = write_desk_class(tmp_path, 5, decisions=False)
    written = read_written(layout.root)
    student = graded(layout)
    begin_class(written.about, layout)
    add(layout, Comment(0, "", student, WORDS))  # `written.rows` are without it
    rows = write_marked(written.rows, written.about, layout, ())
    assert told(layout, student) == (True, True, True)
    assert next(row for row in rows.rows if row.id == student).decided is not None


def test_lists_come_last_and_the_end_of_a_marking_after_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    layout = write_desk_class(tmp_path, 2, decisions=False)
    written = read_written(layout.root)
    order: list[str] = []

    def wrote(path: Path, data: bytes) -> None:
        order.append(path.name)
        write_atomically(path, data)

    monkeypatch.setattr(class_files, "write_atomically", wrote)
    write_class(written.rows, written.about, layout)
    assert order == ["index.html", "results.json", "marking.json"]


def test_what_is_undone_after_a_crash_goes_from_the_page(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    layout = write_desk_class(tmp_path, 5, decisions=False)
    student = graded(layout)
    renewed(layout, (student,))
    name = add(layout, Comment(0, "", student, WORDS))

    def dies(*_: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(renewing, "write_class", dies)
        with pytest.raises(KeyboardInterrupt):
            renewed(layout)
    assert told(layout, student) == (True, True, False)
    add(layout, Undo(0, "", (name,)))
    renewed(layout)
    assert told(layout, student) == (False, False, False)
    assert not pending(layout)


def test_pages_that_are_given_away_are_brought_up_to_date_first(tmp_path: Path) -> None:
    layout = write_desk_class(tmp_path, 5, decisions=False)
    student = graded(layout)
    before = layout.results.stat().st_mtime_ns
    brought_up_to_date(read_written(layout.root))
    assert layout.results.stat().st_mtime_ns == before, "nothing was decided"
    add(layout, Comment(0, "", student, WORDS))
    brought_up_to_date(read_written(layout.root))
    assert told(layout, student) == (True, True, True)


def test_lists_are_not_written_while_a_marking_goes_on(tmp_path: Path) -> None:
    layout = write_desk_class(tmp_path, 2, decisions=False)
    about = read_written(layout.root).about
    begin_class(replace(about, finished=None), layout)
    with pytest.raises(Refused):
        renewed(layout)
