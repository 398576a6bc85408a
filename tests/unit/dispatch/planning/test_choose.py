"""`vrts dispatch choose`: ready programs of a real marking, in order, without names if need be."""

import json
import shutil
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from tests.places import ROOT
from vrts.cli.main import vrts
from vrts.dispatch.planning.choose import Choice, choices, choices_text
from vrts.marking.layout import Layout
from vrts.marking.row import class_from_bytes

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
CLASS = {"Vera Ready": "slow.v2", "Walter Hits": "hits-base.v2"}

READY = "programs are ready for the real robot, each in the scenario of its task"


def call(*words: str) -> Result:
    return CliRunner().invoke(vrts, list(words))


def marked(home: Path, *options: str) -> Path:
    """Mark a class of three from folders, one of them the reference solution."""
    handed_in = home / "handed-in"
    for name, file in CLASS.items():
        (handed_in / name).mkdir(parents=True)
        shutil.copy(EXAMPLE / "submissions" / file, handed_in / name / "program.v2")
    (handed_in / "Xenia Best").mkdir()
    shutil.copy(EXAMPLE / "solution.v2", handed_in / "Xenia Best" / "program.v2")
    out = home / "out"
    done = call("grade", str(EXAMPLE), str(handed_in), "-o", str(out), "--no-pages", *options)
    assert done.exit_code == 0, done.output
    return out


@pytest.mark.thorough
def test_ready_programs_stand_in_order_of_clearance_and_mark(tmp_path: Path) -> None:
    out = marked(tmp_path)
    found = call("dispatch", "choose", str(out))
    assert found.exit_code == 0, found.output
    lines = found.stdout.splitlines()
    assert "Xenia" in lines[1], "the same clearance, the higher mark"
    assert "Vera" in lines[2]
    assert "Walter" not in found.stdout
    assert lines[-1] == f"2 of 3 {READY}"
    data = json.loads(call("dispatch", "choose", str(out), "--format", "json").stdout)
    assert [entry["mark"] for entry in data["ready"]] == sorted(
        (entry["mark"] for entry in data["ready"]), reverse=True
    )
    assert data["marked"] == 3


@pytest.mark.thorough
def test_nobody_is_named_where_the_class_has_pseudonyms(tmp_path: Path) -> None:
    out = marked(tmp_path, "--pseudonyms")
    assert (out / "staff" / "names.csv").is_file()
    found = call("dispatch", "choose", str(out))
    assert found.exit_code == 0, found.output
    assert "2 of 3 programs" in found.stdout
    for name in ("Vera", "Xenia", "Walter", "program.v2"):
        assert name not in found.stdout


@pytest.mark.thorough
def test_a_larger_clearance_comes_first_and_less_than_a_millimetre_does_not_count(
    tmp_path: Path,
) -> None:
    rows = class_from_bytes(Layout(marked(tmp_path)).results.read_bytes())
    best, slow = choices(rows)
    assert best.clearance_mm == slow.clearance_mm == pytest.approx(10.0)
    assert best.mark is not None
    assert slow.mark is not None
    assert best.mark > slow.mark


def test_the_list_says_when_there_is_none() -> None:
    assert choices_text([], 4) == f"0 of 4 {READY}"
    one = choices_text([Choice("a", "", None, 9.5, None)], 1)
    assert "9.5" in one
    assert one.endswith(f"1 of 1 {READY}")


def test_what_is_no_marking_is_refused(tmp_path: Path) -> None:
    found = call("dispatch", "choose", str(tmp_path))
    assert found.exit_code in (1, 2)
    assert "vrts grade" in found.output


@pytest.mark.thorough
def test_only_a_proof_says_ready_in_every_future(tmp_path: Path) -> None:
    task = tmp_path / "asks"
    shutil.copytree(EXAMPLE, task, ignore=shutil.ignore_patterns("submissions"))
    whole = (task / "task.toml").read_text()
    (task / "task.toml").write_text(f"{whole}\n[prove]\nstates = 2000\n")
    (tmp_path / "in").mkdir()
    shutil.copy(EXAMPLE / "solution.v2", tmp_path / "in" / "best.v2")
    out = tmp_path / "out"
    done = call("grade", str(task), str(tmp_path / "in"), "-o", str(out))
    assert done.exit_code == 0, done.output
    found = call("dispatch", "choose", str(out))
    assert found.stdout.splitlines()[-1] == (
        "1 of 1 programs are ready for the real robot, each in every future"
    )
    data = json.loads(call("dispatch", "choose", str(out), "--format", "json").stdout)
    assert data["ready"][0]["ready_in"] == "every future"
    (overview,) = (out / "staff").glob("index.html")
    assert "ready, in every future" in overview.read_text()
