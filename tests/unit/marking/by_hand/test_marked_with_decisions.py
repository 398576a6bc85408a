"""A class marked for real, with graders' files beside it: again and again the same marks."""

import shutil
from datetime import UTC, datetime
from pathlib import Path

import pytest

from tests.unit.marking.appeals.support import BAD, EXAMPLE, GOOD
from tests.unit.marking.by_hand.support import change
from tests.unit.marking.intake.support import put
from vrts.marking.by_hand.decisions.files import add_decisions
from vrts.marking.by_hand.decisions.records import Extend, Give, Item
from vrts.marking.layout import Layout
from vrts.marking.row import Row
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.marking.whole_class import HowTo, mark_whole_class

LATE = "[late]\ndue = 2026-12-01T12:00:00+01:00\nper_day = 5\n[submissions]\nkeep = 'best'\n\n"
NOW = datetime(2026, 12, 3, tzinfo=UTC)
FIRST, SECOND = "2026-12-01-10-00-00", "2026-12-02-10-00-00"


def marked(folder: Path, how: HowTo) -> dict[str, Row]:
    """Mark the class; return the rows by id."""
    marker = Marker(Place(str(folder / "lab" / "task.toml")), Wanted(collisions=False, pages=False))
    found = mark_whole_class(marker, folder / "in", Layout(folder / "out"), how)
    assert not found.warnings
    return {row.id: row for row in found.rows.rows}


@pytest.mark.thorough
def test_a_later_deadline_tells_which_attempt_is_the_best(tmp_path: Path) -> None:
    shutil.copytree(EXAMPLE, tmp_path / "lab", ignore=shutil.ignore_patterns("submissions"))
    task = tmp_path / "lab" / "task.toml"
    text = task.read_text("utf-8")
    place = text.index("[[goal]]")
    task.write_text(f"{text[:place]}{LATE}{text[place:]}", "utf-8")
    put(tmp_path / "in", {f"ann/{FIRST}/p.v2": BAD, f"ann/{SECOND}/p.v2": GOOD})
    how = HowTo(pseudonyms=True)
    ((name, before),) = marked(tmp_path, how).items()
    assert before.handed_in.file != ""
    assert before.final == before.result.mark  # the first: the second costs 5 points
    decisions = Layout(tmp_path / "out").decisions
    until = Extend(0, "", (name,), "2026-12-05T12:00:00+01:00", "ill")
    item = Item(0, "", "style", "no comments", "-1/2")
    said = (until, item, Give(0, "", "style", (name,)), change(name, delta="-1"))
    add_decisions(decisions, "R. Huber", said, NOW)
    after = marked(tmp_path, how)[name]
    assert (after.result.mark, after.final) == (10.0, 8.5)
    assert after.late is None
    assert marked(tmp_path, how)[name] == after
    task.write_text(task.read_text("utf-8").replace("per_day = 5", "per_day = 4"), "utf-8")
    assert marked(tmp_path, how)[name].final == 8.5  # another task, the same program
