"""`vrts purge --student`: a grep over all bytes finds nothing of them, and others stay the same."""

import json
import shutil
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from tests.unit.marking.by_hand.support import AT, written
from tests.unit.marking.personal.support import (
    EXAMPLE,
    MINE,
    WORDS,
    call,
    contents,
    download,
)
from tests.unit.marking.privacy.test_purge import marked as marked_before
from vrts.cli.main import vrts
from vrts.marking.appeals.written import read_written
from vrts.marking.by_hand.decisions.records import (
    Comment,
)
from vrts.marking.layout import Layout
from vrts.marking.personal.forget import planned, steps
from vrts.marking.privacy.pseudonyms import read_names
from vrts.marking.renewing.renewed import renewed
from vrts.marking.result import to_bytes
from vrts.marking.supervise.staging import staging_folder
from vrts.marking.whole_class import was_edited

LISTS = ("index.html", "results.json", "marks.csv", "intake.csv", "marking.json", "names.csv")
SECRETS = ("querulin", "zwackelmann", "4711")
OTHERS = ("Anna-Ady-1", "Ben-Otto-2")


def naming(folder: Path, *words: str) -> list[str]:
    """Return the names of files that have some words in them."""
    wanted = [word.encode() for word in words]
    return [
        name
        for name, data in contents(folder)
        if any(word in data.lower() or word in name.lower().encode() for word in wanted)
    ]


def of_others(folder: Path) -> dict[str, bytes]:
    """Return the files that are about others, and no lists."""
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.parent.name in OTHERS
    }


@pytest.fixture
def home(marked: Path, tmp_path: Path) -> Path:
    """Return a copy to change."""
    shutil.copytree(marked, tmp_path / "years", symlinks=True)
    return tmp_path / "years"


def forget(home: Path) -> Result:
    """Forget the one student in both years."""
    return call("purge", home / "2025", home / "2026", "--student", MINE, "--yes")


@pytest.mark.thorough
def test_no_byte_is_left_of_one_and_every_byte_of_the_others(home: Path) -> None:
    for year in ("2025", "2026"):
        assert naming(home / year, *SECRETS), year
        assert naming(home / year, WORDS), year
    before = {year: of_others(home / year) for year in ("2025", "2026")}
    rows = {row.id: row for row in read_written(home / "2025").rows.rows}
    done = forget(home)
    assert done.exit_code == 0, done.output
    for year in ("2025", "2026"):
        assert naming(home / year, *SECRETS, WORDS) == []
        assert of_others(home / year) == before[year]
        assert len(before[year]) >= 8
    assert "V924" not in done.output
    for name in ("csv", "xml", "zip"):
        assert f".{name}, which named the student" in done.output
    layout = Layout(home / "2025")
    assert [path.name for path in (layout.staff / "exports").glob("*")] == ["folders", "notes.csv"]
    now = read_written(home / "2025")
    assert all(row == rows[row.id] for row in now.rows.rows)
    assert {row.id for row in now.rows.rows} == rows.keys() - {MINE}
    data = json.loads((home / "2025/staff/similarity.json").read_bytes())
    assert data["compared"] == 2
    data = json.loads((home / "2026/staff/similarity.json").read_bytes())
    assert [one["programs"] for one in data["corpus"]] == [2]
    again = call("grade", "decisions", home / "2025")
    assert again.exit_code == 0, again.output
    assert renewed(layout).changed == ()


@pytest.mark.thorough
def test_whatever_interrupts_it_the_same_call_ends_it(marked: Path, tmp_path: Path) -> None:
    place = tmp_path / "years"  # the same each time: pages name where they are
    shutil.copytree(marked, place)
    assert forget(place).exit_code == 0
    whole = dict(contents(place))
    shutil.rmtree(place)
    shutil.copytree(marked, place)
    ended, refused = 0, 0
    while True:  # each time interrupted one step later
        jobs = planned((place / "2025", place / "2026"), MINE)
        folders = [job.layout.root for job in jobs]
        found = list(steps(jobs, {one: [] for one in folders}, {one: [] for one in folders}))
        ended += 1
        for step in found[:ended]:
            step()
        if ended >= len(found) - 3:  # the first of them is whole
            break
        told = call("grade", "export", place / "2025", "--to", "csv")
        refused += "forgetting a student was interrupted" in told.output
    assert refused == ended - 1 > 8
    assert forget(place).exit_code == 0
    assert dict(contents(place)) == whole


@pytest.mark.thorough
def test_a_corpus_is_found_again_or_told_and_a_later_class_is_told(home: Path) -> None:
    def corpus() -> list[str]:
        data = json.loads((home / "2026/staff/similarity.json").read_bytes())
        return [one["name"] for one in data["corpus"]]

    done = call("purge", home / "2026", "--student", OTHERS[0], "--yes")
    assert done.exit_code == 0, done.output
    assert "V925" not in done.output
    assert corpus() == ["2025"]  # it lies beside
    done = CliRunner().invoke(vrts, ["purge", str(home / "2025"), "--student", MINE], input="n\n")
    told = " ".join(done.stderr.split())
    assert "warning[V780 copies-elsewhere]" in told
    assert "in this call, too" in told
    (home / "away").mkdir()
    (home / "2025").rename(home / "away" / "2025")
    done = call("purge", home / "2026", "--student", OTHERS[1], "--yes")
    assert done.exit_code == 0, done.output
    assert "warning[V925 compared-without-a-corpus]" in done.stderr
    assert not (home / "2026/staff/similarity.json").exists()  # nobody is left to compare


@pytest.mark.thorough
def test_a_pseudonym_or_the_id_says_who_is_forgotten(tmp_path: Path) -> None:
    words = ("grade", EXAMPLE, download(tmp_path / "in"), "-o", tmp_path / "out")
    assert call(*words, "--pseudonyms", "--no-pages").exit_code == 0
    layout = Layout(tmp_path / "out")
    names = read_names(layout)
    (mine,) = [name for name, line in names.items() if line["id"] == MINE]
    shutil.copytree(tmp_path / "out", tmp_path / "again")
    for folder, wanted in (("out", MINE), ("again", mine)):
        here = tmp_path / folder
        table = (here / "staff/names.csv").read_bytes()
        done = call("purge", here, "--student", wanted, "--yes")
        assert done.exit_code == 0, done.output
        assert naming(here, *SECRETS, mine, WORDS) == []
        left = [line for line in table.splitlines(keepends=True) if mine.encode() not in line]
        assert (here / "staff/names.csv").read_bytes() == b"".join(left)
        assert len(left) == 3
        assert not was_edited(Layout(here), here / "staff/names.csv")


def test_who_cannot_be_forgotten_is_told_and_nothing_changes(tmp_path: Path) -> None:
    out = synthetic(tmp_path / "out", 3)
    before = dict(contents(out))
    for words, told in (
        (("--student", "anna-bergr"), "did you mean `anna-berger`?"),
        (("--student", "anna-berger", "--older-than", "1d"), "either `--older-than AGE`, or"),
        ((), "either `--older-than AGE`, or"),
        (("--student", "anna-berger", "--keep-statistics"), "belongs to `--older-than`"),
    ):
        done = call("purge", out, *words, "--yes")
        assert done.exit_code != 0
        assert told in done.stderr
    (tmp_path / "plan").mkdir()
    (tmp_path / "plan" / "key.json").write_text('{"schema": "vrts.plan/2"}')
    done = call("purge", out, tmp_path / "plan", "--student", "anna-berger", "--yes")
    assert "is a plan" in done.stderr
    done = CliRunner().invoke(vrts, ["purge", str(out), "--student", "anna-berger"], input="n\n")
    assert done.exit_code == 1
    assert dict(contents(out)) == before
    with staging_folder(Layout(out).staging):
        done = call("purge", out, "--student", "anna-berger", "--yes")
        assert "error[V923 marking-goes-on]" in done.stderr
    assert (out / "students/anna-berger/result.json").exists()
    away = tmp_path / "away"
    (out / "students/anna-berger").rename(away)
    (out / "students/anna-berger").symlink_to(away)
    assert "V769" in call("purge", out, "--student", "anna-berger", "--yes").stderr
    assert any(away.iterdir())


def test_who_has_no_row_any_more_is_forgotten_too(tmp_path: Path) -> None:
    out = synthetic(tmp_path / "out", 3)
    (out / "students/zoe").mkdir()
    (out / "students/zoe/report.html").write_text("zoe")
    late = written("rh", Comment(1, AT, "zoe", "see me"), Comment(2, AT, "yann", "see me"))
    (out / "staff/decisions/rh.jsonl").write_bytes(late)
    before = read_written(out).rows.rows
    for name in ("zoe", "yann"):  # of an earlier marking; decided by a desk that did not know
        assert naming(out, name)
        assert call("purge", out, "--student", name, "--yes").exit_code == 0
        assert naming(out, name) == []
    assert read_written(out).rows.rows == before
    assert "V761" in call("purge", out, "--student", "../anna-berger", "--yes").stderr


def test_what_others_wrote_stays_and_is_told(tmp_path: Path) -> None:
    out = synthetic(tmp_path / "out", 3)
    (out / "staff/decisions/rh.jsonl").write_bytes(
        written("rh", Comment(1, AT, "ben-otto", "as Anna-Berger has it"))
    )
    (out / "staff/notes.txt").write_text("anna-berger: nice")
    ben = {path: path.read_bytes() for path in out.rglob("ben-otto/*")}
    done = call("purge", out, "--student", "anna-berger", "--yes")
    assert done.exit_code == 0, done.output
    assert "warning[V924 still-named]" in done.stderr
    for name in ("staff/decisions/rh.jsonl", "staff/notes.txt", "staff/results.json"):
        assert name in done.stderr
    assert not list(out.rglob("anna-berger"))
    assert "anna-berger" not in (out / "staff/intake.csv").read_text()
    after = {path: path.read_bytes() for path in out.rglob("ben-otto/*")}
    assert {path for path in after if path.name != "feedback.txt"} >= ben.keys()


def synthetic(folder: Path, days: float) -> Path:
    """Write the output of a marking without marking, and results that can be read."""
    marked_before(folder, days)
    layout = Layout(folder)
    (layout.decisions / "rh.jsonl").unlink()
    for row in read_written(folder).rows.rows:
        layout.student(row.id).mkdir(parents=True, exist_ok=True)
        (layout.student(row.id) / "result.json").write_bytes(to_bytes(row.result))
    (layout.staff / "names.csv").unlink()
    layout.intake.write_text("id,name\nanna-berger,Anna\nben-otto,Ben\ncara,Cara\n")
    return folder
