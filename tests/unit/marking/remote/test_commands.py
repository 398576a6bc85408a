"""From a download by way of shards to the list of marks, from the command line."""

import json
import re
import shutil
import stat
import zipfile
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from tests.unit.marking.remote.support import BAD, GOOD, TYPO, files, task
from vrts.cli.grade.grade_command import command
from vrts.marking.remote import dask_cluster, run_shard
from vrts.marking.remote.shard import Shard

INDEX = "staff/index.html"
TIME = re.compile(rb"marked \d{4}-\d\d-\d\d \d\d:\d\d")


@pytest.fixture
def lab(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the folder with a task and hand-ins, which is the working folder."""
    task(tmp_path / "lab")
    for name, data in (("anna_b", GOOD), ("ben_c", BAD), ("cy_d", TYPO), ("photo", b"\x89PNG")):
        (tmp_path / "hand-ins" / name).mkdir(parents=True)
        (tmp_path / "hand-ins" / name / f"{name}.v2").write_bytes(data)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def vrts(*arguments: str) -> Result:
    return CliRunner().invoke(command, list(arguments), catch_exceptions=False)


def good(*arguments: str) -> str:
    found = vrts(*arguments)
    assert found.exit_code == 0, found.output
    return found.output


def same_class(here: Path, there: Path) -> dict[str, bytes]:
    """Check that two folders of a marking differ in when it was, and return the second's files."""
    found = files(there)
    one, other = (
        {name: TIME.sub(b"", data) for name, data in every.items() if name != "staff/marking.json"}
        for every in (files(here), found)
    )
    assert other.keys() == one.keys()
    assert [name for name in one if one[name] != other[name]] == []
    assert {INDEX, "staff/marks.csv", "staff/similarity.html"} <= one.keys()
    return found


@pytest.mark.thorough
def test_plan_run_merge_and_lists(lab: Path) -> None:
    planned = good("plan", "lab", "hand-ins", "--shards", "2", "--no-pages")
    assert "plan/shards: 2 shards of 3 programs" in planned
    assert "1 more have nothing to mark" in planned
    shards = sorted(str(path) for path in Path("plan/shards").iterdir())
    assert good("run", shards[0], "-o", "results").endswith("results/shard-01.zip: 1 marked\n")
    partly = vrts("merge", "plan", "results", "-o", "out")
    assert partly.exit_code == 1
    assert "warning[V726 results-missing]: 2 of 3 submissions have no result yet" in partly.output
    good("run", shards[1], "-o", "results/other.zip", "--jobs", "2")
    assert "there already" in good("run", shards[1], "-o", "results/other.zip")
    assert not (lab / "out" / "staff" / "results.json").exists()
    assert "lists of marks are written when every submission has a result" in partly.output
    merged = good("merge", "plan", "results", "-o", "out")
    assert "4 of 4 submissions have results\nwrote out/staff/index.html\n" in merged
    assert sorted(path.name for path in (lab / "results").iterdir()) == [
        "other.zip",
        "shard-01.zip",
    ]

    made = {path: path.stat().st_mtime_ns for path in (lab / "out").rglob("result.json")}
    assert len(made) == 8
    good("lab", "hand-ins", "-o", "here", "--no-pages")
    there = same_class(lab / "here", lab / "out")
    here = files(lab / "here")
    abouts = [json.loads(files_["staff/marking.json"]) for files_ in (here, there)]
    for about in abouts:
        del about["begun"], about["finished"], about["command"], about["place"]
    assert abouts[0] == abouts[1]

    good("lab", "hand-ins", "-o", "out", "--no-pages")
    again = [path for path, when in made.items() if path.stat().st_mtime_ns != when]
    assert {path.parent.name for path in again} <= {"photo"}
    rows = json.loads((lab / "out" / "staff" / "results.json").read_text())["rows"]
    marks = {row["student"]["name"] or row["id"]: row["result"]["mark"] for row in rows}
    assert sorted(marks.values()) == [0.0, 0.0, 4.5, 6.0]


@pytest.mark.thorough
def test_a_merged_class_has_its_lateness_its_changes_by_hand_and_its_corpus(lab: Path) -> None:
    """They come from what stayed at home: the download may be gone by then."""
    with (lab / "lab" / "task.toml").open("a") as file:
        file.write("\n[late]\ndue = 2026-03-01T12:00:00+01:00\nper_day = 1\n")
    for name, day, data in (("anna", "01", GOOD), ("ben", "02", BAD)):
        place = lab / "late" / name / f"2026-03-{day}-10-00-00"
        place.mkdir(parents=True)
        (place / "pick.v2").write_bytes(data)
    good("lab", "late", "-o", "here", "--no-pages")
    good(
        "change", "ben", "--from", "here", "--delta", "0.3", "--reason", "he was ill", "--who", "me"
    )
    (lab / "old").mkdir()
    (lab / "old" / "max.v2").write_bytes(GOOD)
    good("lab", "late", "-o", "here", "--no-pages", "--corpus", "old")
    good("plan", "lab", "late", "--shards", "1", "--no-pages")
    good("run", "plan/shards/shard-01.json", "-o", "results")
    shutil.rmtree("late")
    (lab / "out" / "staff").mkdir(parents=True)
    shutil.copy("here/staff/overrides.toml", "out/staff/overrides.toml")
    good("merge", "plan", "results", "-o", "out", "--corpus", "old")
    there = same_class(lab / "here", lab / "out")
    assert b"old/max" in there["staff/similarity.json"]
    rows = json.loads(there["staff/results.json"])["rows"]
    assert [bool(row["late"]) for row in rows] == [False, True]

    table = Path("out/staff/intake.csv")
    table.write_bytes(table.read_bytes().replace(b"anna,", b"anna-b,", 1))
    edited = vrts("merge", "plan", "results", "-o", "out")
    assert (edited.exit_code, "V733" in edited.output) == (1, True), edited.output
    assert b"anna-b" in table.read_bytes()
    task_file = lab / "lab" / "task.toml"
    task_file.write_text(task_file.read_text().replace("per_day = 1", "per_day = 2"))
    other = vrts("merge", "plan", "results", "-o", "new")
    assert (other.exit_code, "V732" in other.output) == (1, True), other.output
    assert (lab / "new" / "staff" / "students" / "anna" / "result.json").is_file()
    assert not (lab / "new" / "staff" / "results.json").exists()


@pytest.mark.thorough
def test_results_are_for_their_owner_and_the_remedy_helps(
    lab: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What was changed is not there already: the shard is marked again."""
    modes: list[int] = []
    plain = run_shard.run_shard

    def looked_at(shard: Shard, data: bytes, work: Path, **options: Any) -> bytes:
        modes.append(stat.S_IMODE(work.stat().st_mode))
        return plain(shard, data, work, **options)

    monkeypatch.setattr(run_shard, "run_shard", looked_at)
    good("plan", "lab", "hand-ins/anna_b", "--shards", "1", "--no-pages")
    call = ("run", "plan/shards/shard-01.json", "-o", "results")
    good(*call)
    place = lab / "results" / "shard-01.zip"
    assert (modes, stat.S_IMODE(place.stat().st_mode)) == ([0o700], 0o600)
    with zipfile.ZipFile(place) as archive:
        members = {name: archive.read(name) for name in archive.namelist()}
    with zipfile.ZipFile(place, "w") as archive:
        for name, data in (members | {"signature.txt": b"0" * 64}).items():
            archive.writestr(name, data)
    place.chmod(0o644)
    refused = vrts("merge", "plan", "results", "-o", "out")
    assert "error[V730 changed-results]" in refused.output
    assert "delete `shard-01.zip` and run shard 1 again" in refused.output
    assert good(*call).endswith("1 marked\n")
    assert (len(modes), stat.S_IMODE(place.stat().st_mode)) == (2, 0o600)
    with zipfile.ZipFile(place) as archive:
        assert archive.read("signature.txt") != b"0" * 64
    good("merge", "plan", "results", "-o", "out")


def test_a_plan_is_not_lost_by_accident(lab: Path) -> None:
    good("plan", "lab", "hand-ins", "--shards", "3")
    key = (lab / "plan" / "key.json").read_bytes()
    refused = vrts("plan", "lab", "hand-ins")
    assert refused.exit_code == 2
    assert "there is a plan in `plan` already" in refused.output
    assert (lab / "plan" / "key.json").read_bytes() == key
    good("plan", "lab", "hand-ins", "--shards", "1", "--force")
    assert [path.name for path in (lab / "plan" / "shards").iterdir()] == ["shard-01.json"]


def test_what_is_no_shard_no_key_and_not_there_is_told(lab: Path) -> None:
    (lab / "notes.json").write_text("{}")
    for arguments, status, words in (
        (("run", "notes.json"), 1, "error[V720 bad-shard]"),
        (("run", "nowhere.json"), 2, "cannot read `nowhere.json`"),
        (("merge", "notes.json", "-o", "out"), 1, "error[V723 bad-plan]"),
        (("merge", "nowhere", "-o", "out"), 2, "cannot read `nowhere`"),
    ):
        found = vrts(*arguments)
        assert (found.exit_code, words in found.output) == (status, True), found.output


@pytest.mark.thorough
def test_a_class_is_marked_by_a_cluster(lab: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    good("lab", "hand-ins", "-o", "here", "--no-pages")
    good("lab", "hand-ins", "-o", "there", "--no-pages", "--backend", "dask", "--jobs", "1")
    here, there = (
        (lab / name / "staff" / "results.json").read_bytes() for name in ("here", "there")
    )
    assert here == there
    monkeypatch.setattr(dask_cluster, "CONNECT_S", 0.5)
    asked = vrts("lab", "hand-ins", "--backend", "dask:127.0.0.1:9")
    assert asked.exit_code == 1
    assert "no Dask scheduler answers at `127.0.0.1:9`" in asked.output
    found = vrts("lab", "hand-ins", "-o", "out", "--backend", "ray")
    assert found.exit_code == 2
    assert "there is no backend `ray`" in found.output
