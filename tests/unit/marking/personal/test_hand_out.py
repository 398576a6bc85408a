"""`vrts grade person`: all of one student, and nothing of any other."""

import io
import json
import re
import zipfile
from pathlib import Path

import pytest

from tests.unit.marking.personal.support import MINE, WORDS, call, ids_of, unpacked
from vrts.marking.personal.kept import KEPT, manual_rows
from vrts.marking.privacy import purge
from vrts.pipeline.files import CHECKOUT

MANUAL = CHECKOUT / "vrts" / "manual" / "understand" / "what-a-marking-keeps.md"


def test_the_manual_has_the_table_of_what_is_kept() -> None:
    lines = MANUAL.read_text(encoding="utf-8").splitlines()
    assert [line for line in lines if line.startswith("| ")][1:] == list(manual_rows())


def test_what_is_told_to_be_kept_is_what_purge_deletes() -> None:
    places = [one for kept in KEPT for one in re.findall("`([^`]+)`", kept.where)]
    assert len(places) > 15
    for place in places:
        files = (*purge.FILES, purge.MARKER)
        assert place in files or any(place.startswith(one) for one in purge.FOLDERS), place
    told = {place.split("/")[1] for place in places if "/" in place}
    for name in (*purge.FILES, *purge.FOLDERS):
        own = name.removesuffix(".part").removeprefix("staff/")
        assert own.endswith(".lock") or own in (*told, "students", "marking.json"), name


@pytest.mark.thorough
def test_one_gets_all_of_theirs_and_nothing_of_others(marked: Path, tmp_path: Path) -> None:
    target = tmp_path / "mine.zip"
    done = call(
        "grade", "person", marked / "2025", marked / "2026", "--student", MINE, "-o", target
    )
    assert done.exit_code == 0, done.output
    assert "files of 1 marking" in done.stdout
    data = target.read_bytes()
    names = zipfile.ZipFile(io.BytesIO(data)).namelist()
    assert names[0] == "README.txt"
    assert {name.removeprefix("2025/") for name in names} >= {
        *("students/report.html", "students/result.json", "students/feedback.txt"),
        *("staff/result.json", "row.json", "marks.csv", "intake.csv", "decisions.json"),
        *("changes.json", "program.v2", "motion.json", "likeness.json"),
    }
    files = dict(unpacked("", data))
    others = [one for name, one in ids_of(marked / "2025").items() if name != "querulin"]
    for name, inside in files.items():
        for word in (*others, "Otto", "Ady", "jh", "lang:", "of anna"):
            if not (name.endswith(".html") or name == ""):
                assert word.encode() not in inside, (name, word)
    readme = files["!README.txt"].decode()
    assert "how long: until vrts purge" in readme
    assert "Querulin Zwackelmann" in readme
    assert WORDS.encode() in files["!2025/program.v2"]
    assert len(files["!2025/marks.csv"].splitlines()) == 2
    assert len(files["!2025/intake.csv"].splitlines()) == 2
    alike = json.loads(files["!2025/likeness.json"])
    assert ["another student", "you"] in [sorted(one["members"]) for one in alike["groups"]]
    decided = json.loads(files["!2025/decisions.json"])
    assert {"comment", "item", "give", "change", "finish", "undo", "decide"} == {
        one["does"] for one in decided
    }
    assert json.loads(files["!2025/changes.json"])[0]["reason"] == "Querulin was ill"


@pytest.mark.thorough
def test_nobody_is_told_with_who_may_be_meant(marked: Path, tmp_path: Path) -> None:
    done = call(
        "grade", "person", marked / "2025", "--student", MINE[:-1], "-o", tmp_path / "a.zip"
    )
    assert done.exit_code == 1
    assert f"did you mean `{MINE}`?" in done.stderr
    assert not (tmp_path / "a.zip").exists()
