"""Marking of a class: a row for everything, nothing made twice, nothing lost."""

import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import pytest

from vrts.marking.layout import Layout
from vrts.marking.marking import Done, Entry, mark_class
from vrts.marking.result import Kind, from_bytes
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.marking.supervise.limits import Limits
from vrts.marking.supervise.supervisor import CAN_FORK
from vrts.pipeline.files import CHECKOUT

EXAMPLE = CHECKOUT / "examples" / "01-cans-on-bases"
TASK = str(EXAMPLE / "task.toml")
GOOD = (EXAMPLE / "solution.v2").read_bytes()
BAD = (EXAMPLE / "submissions" / "hits-base.v2").read_bytes()
TYPO = (EXAMPLE / "submissions" / "syntax-error.v2").read_bytes()
ENTRIES = (
    Entry("anna", "pick.v2", GOOD),
    Entry("ben", "ben.v2", TYPO),
    Entry("cara", "", None, Kind.MISSING, "nothing was handed in"),
    Entry("dora", "dora.v2", b"\x00\x01\x02\xff not a program"),
)
PLAIN = Wanted(pages=False)


class Marked(NamedTuple):
    """What came out."""

    by_id: dict[str, Done]
    layout: Layout

    def marks(self) -> dict[str, float | None]:
        """Return the marks by id."""
        return {name: done.result.mark for name, done in self.by_id.items()}


def mark(out: Path, *entries: Entry, wanted: Wanted = PLAIN, **options: object) -> Marked:
    """Mark entries into a folder."""
    layout = Layout(out)
    found = mark_class(Marker(Place(TASK), wanted), entries, layout, jobs=2, **options)  # type: ignore[arg-type]
    return Marked({done.entry.identifier: done for done in found}, layout)


def test_everything_gets_a_row_and_its_files(tmp_path: Path) -> None:
    found = mark(tmp_path, *ENTRIES, wanted=Wanted(recordings=True))
    assert found.marks() == {"anna": 10.0, "ben": 0.0, "cara": None, "dora": 0.0}
    kinds = {name: done.result.kind for name, done in found.by_id.items()}
    assert kinds == {
        "anna": Kind.GRADED,
        "ben": Kind.DOES_NOT_COMPILE,
        "cara": Kind.MISSING,
        "dora": Kind.UNREADABLE,
    }
    for name, done in found.by_id.items():
        sent, kept = found.layout.student(name), found.layout.grader(name)
        assert from_bytes((sent / "result.json").read_bytes()) == done.student
        assert from_bytes((kept / "result.json").read_bytes()) == done.result
        assert (sent / "report.html").exists() == (name != "cara")
        assert (kept / "report.html").exists() == (name != "cara")
        assert (sent / "run.rrd").exists() == (name == "anna")
    assert not found.layout.staging.exists() or not any(found.layout.staging.iterdir())


@pytest.mark.thorough
def test_only_what_changed_is_marked_again(tmp_path: Path) -> None:
    mark(tmp_path, *ENTRIES)
    again = mark(tmp_path, *ENTRIES)
    assert {name for name, done in again.by_id.items() if not done.reused} == {"cara"}
    changed = mark(tmp_path, ENTRIES[0]._replace(data=BAD), *ENTRIES[1:])
    assert {name for name, done in changed.by_id.items() if not done.reused} == {"anna", "cara"}
    assert changed.marks()["anna"] == 7.0
    assert all(not done.reused for done in mark(tmp_path, *ENTRIES, again=True).by_id.values())


@pytest.mark.thorough
def test_files_that_are_wanted_now_are_made_now(tmp_path: Path) -> None:
    mark(tmp_path, ENTRIES[0])
    found = mark(tmp_path, ENTRIES[0], wanted=Wanted(pages=True))
    assert not found.by_id["anna"].reused
    report = found.layout.student("anna") / "report.html"
    assert report.is_file()
    report.unlink()
    assert not mark(tmp_path, ENTRIES[0], wanted=Wanted(pages=True)).by_id["anna"].reused
    assert report.is_file()


@pytest.mark.thorough
def test_a_damaged_result_is_made_again(tmp_path: Path) -> None:
    first = mark(tmp_path, ENTRIES[0])
    place = first.layout.grader("anna") / "result.json"
    place.write_bytes(place.read_bytes()[:100])
    found = mark(tmp_path, ENTRIES[0])
    assert not found.by_id["anna"].reused
    assert found.marks() == {"anna": 10.0}


def test_a_task_that_changed_changes_the_key(tmp_path: Path) -> None:
    folder = tmp_path / "task"
    shutil.copytree(EXAMPLE, folder)
    place = folder / "task.toml"
    before = Marker(Place(str(place)), PLAIN).key(GOOD)
    assert Marker(Place(str(place)), PLAIN).key(GOOD) == before
    assert Marker(Place(str(place)), Wanted(pages=False, collisions=False)).key(GOOD) != before
    place.write_text(place.read_text() + "\n# a remark\n")
    assert Marker(Place(str(place)), PLAIN).key(GOOD) != before


@pytest.mark.thorough
def test_a_lost_process_is_no_zero(tmp_path: Path) -> None:
    limits = Limits(wall_s=0.001)  # nothing is marked so fast
    found = mark(tmp_path, ENTRIES[0], ENTRIES[1], limits=limits)
    done = found.by_id["anna"]
    assert (done.result.kind, done.result.mark) == (Kind.RESOURCE, None)
    assert done.result.review == ("the process that marked it did not end in time",)
    assert "did not end in time" in (found.layout.grader("anna") / "lost.txt").read_text()
    assert mark(tmp_path, ENTRIES[0]).marks() == {"anna": 10.0}, "the next call tries again"


@pytest.mark.thorough
def test_the_same_without_forking(tmp_path: Path) -> None:
    forked = mark(tmp_path / "forked", ENTRIES[0], ENTRIES[1])
    spawned = mark(tmp_path / "spawned", ENTRIES[0], ENTRIES[1], fork=False)
    for name, done in forked.by_id.items():
        assert spawned.by_id[name].result == done.result


SLOW = """
import sys, time
from pathlib import Path
from tests.unit.marking.test_marking import ENTRIES, GOOD, PLAIN, TASK
from vrts.marking.layout import Layout
from vrts.marking.submission.marker import Marker
from vrts.marking.marking import Entry, mark_class
from vrts.marking.submission.setting import Place
entries = [Entry(f"s{n}", "pick.v2", GOOD) for n in range(40)]
for done in mark_class(Marker(Place(TASK), PLAIN), entries, Layout(Path(sys.argv[1]))):
    print(done.entry.identifier, flush=True)
"""


@pytest.mark.thorough
@pytest.mark.skipif(not CAN_FORK, reason="nothing is forked here")
def test_a_marking_that_is_killed_goes_on_where_it_was(tmp_path: Path) -> None:
    command = [sys.executable, "-c", SLOW, str(tmp_path)]
    process = subprocess.Popen(command, cwd=CHECKOUT, stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    seen = [process.stdout.readline().strip() for _ in range(3)]
    process.send_signal(signal.SIGKILL)
    process.wait()
    process.stdout.close()
    assert seen == ["s0", "s1", "s2"]
    assert list(Layout(tmp_path).staging.iterdir()), "it had no time to tidy up"
    entries = [Entry(f"s{n}", "pick.v2", GOOD) for n in range(6)]
    found = mark(tmp_path, *entries)
    assert {name for name in seen if found.by_id[name].reused} == set(seen)
    assert set(found.marks().values()) == {10.0}
    assert list(found.layout.staging.iterdir()) == []


@pytest.mark.thorough
def test_students_get_nothing_of_hidden_checks(tmp_path: Path) -> None:
    folder = tmp_path / "task"
    shutil.copytree(EXAMPLE, folder)
    (folder / "staff").mkdir()
    hidden = '[[via]]\nname = "secretgate"\nat_mm = [612.34, 345.67, 123.45]\nradius_mm = 12\n'
    (folder / "staff" / "task.toml").write_text(hidden)
    layout = Layout(tmp_path / "out")
    marker = Marker(Place(str(folder / "task.toml")), Wanted())
    (done,) = mark_class(marker, [ENTRIES[0]], layout)
    assert done.student.mark == 10.0
    assert (done.student.more, done.result.more) == (1, 0)
    assert done.result.mark is not None
    assert done.result.mark < 10.0
    assert "secretgate" in (layout.grader("anna") / "result.json").read_text()
    for path in layout.student("anna").rglob("*"):
        for secret in (b"secretgate", b"612.34", b"345.67", b"staff", str(tmp_path).encode()):
            assert secret not in path.read_bytes(), path
    assert json.loads((layout.student("anna") / "result.json").read_text())["mark"] == 10.0


@pytest.mark.thorough
def test_what_would_mend_a_program_is_for_those_who_mark(tmp_path: Path) -> None:
    """And only where they ask: marks, and what students get, are the same without it."""
    wrong = GOOD.replace(b"OPENI                           ; let go", b"CLOSEI ; let go")
    assert wrong != GOOD
    entry = Entry("ben", "ben.v2", wrong)
    plain = mark(tmp_path / "plain", entry).by_id["ben"]
    asked = mark(tmp_path / "asked", entry, wanted=Wanted(pages=False, mending=60)).by_id["ben"]
    assert plain.result.mending is None
    assert asked.result.mending is not None
    assert asked.result.mending.cause == "`OPENI` for `CLOSEI`"
    assert asked.result.mending.lines == (21,)
    assert asked.student == plain.student
    assert asked.result.mark == plain.result.mark
    assert asked.result.key != plain.result.key


@pytest.mark.thorough
@pytest.mark.skipif(not CAN_FORK, reason="what starts anew knows nothing of the search here")
def test_a_mark_stands_when_the_search_for_what_would_mend_is_ended(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its pages, too; and the next marking looks again."""

    def ended(*_: object) -> None:
        os.kill(os.getpid(), signal.SIGKILL)

    def nothing(*_: object) -> None:
        return None

    entry = Entry("ben", "ben.v2", BAD)
    wanted = Wanted(mending=60)
    monkeypatch.setattr("vrts.marking.submission.marker.would_do", ended)
    found = mark(tmp_path, entry, wanted=wanted)
    first = found.by_id["ben"].result
    lost = found.layout.grader("ben") / "lost.txt"
    assert first.kind is Kind.GRADED
    assert (found.layout.student("ben") / "report.html").is_file()
    assert lost.read_text().startswith("the search for what would mend it crashed\n")
    monkeypatch.setattr("vrts.marking.submission.marker.would_do", nothing)
    again = mark(tmp_path, entry, wanted=wanted).by_id["ben"]
    assert not again.reused
    assert again.result == first
    assert not lost.exists()
    assert mark(tmp_path, entry, wanted=wanted).by_id["ben"].reused
