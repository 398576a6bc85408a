"""The autograder for Gradescope: its zip unpacked, its script run by a real shell."""

import io
import json
import os
import re
import shutil
import subprocess
import sys
import time
import zipfile
from importlib.metadata import PackageNotFoundError
from pathlib import Path
from typing import Any, NoReturn

import jsonschema
import pytest
from click.testing import CliRunner

from tests.places import ROOT
from tests.support_exports import DATA
from vrts import __version__
from vrts.assignments.pack import read_zip, student_zip
from vrts.assignments.task_folder import read_folder
from vrts.cli.grade import init_command
from vrts.marking.exports.autograders import own_wheel as own_wheel_module
from vrts.marking.exports.autograders.autograder_zip import MODE, autograder_zip, staff_task
from vrts.marking.exports.autograders.own_wheel import NAME, own_wheel

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SCHEMA = json.loads((DATA / "exports" / "gradescope-results.schema.json").read_text("utf-8"))

WHERE = """
import vrts, vrts.cli.main
from vrts.pipeline.files import find_example
print(vrts.__file__)
print(find_example("01-cans-on-bases"))
"""


def init(*words: object) -> tuple[int, str]:
    called = CliRunner().invoke(init_command.command, [str(word) for word in words])
    return called.exit_code, called.output


HIDDEN = """
[[via]]
name = "a secret gate 4711"
at_mm = [731, 213, 517]
radius_mm = 43
"""


def stand_in(folder: Path, says: str, build: str = "") -> Path:
    """Write a wheel of the name and version of vrts, which needs nothing and says who it is."""
    folder.mkdir()
    name = f"vrts-{__version__}"
    target = folder / f"{name}{build}-py3-none-any.whl"
    info = f"{name}.dist-info"
    with zipfile.ZipFile(target, "w") as wheel:
        wheel.writestr("vrts_stand_in.py", f"def main():\n    print({says!r})\n")
        wheel.writestr(
            f"{info}/METADATA", f"Metadata-Version: 2.1\nName: vrts\nVersion: {__version__}\n"
        )
        wheel.writestr(
            f"{info}/WHEEL",
            "Wheel-Version: 1.0\nGenerator: test\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        )
        wheel.writestr(f"{info}/entry_points.txt", "[console_scripts]\nvrts = vrts_stand_in:main\n")
        wheel.writestr(f"{info}/RECORD", "")
    return target


def unpacked(task: Path, home: Path) -> Path:
    """Return a folder like /autograder: the zip unpacked, and vrts of this very checkout."""
    wheels = stand_in(home / "wheels", "ours").parent  # to pack vrts itself takes longer
    status, said = init("gradescope", task, "--wheels", wheels, "-o", home / "a.zip")
    assert status == 0, said
    root = home / "autograder"
    with zipfile.ZipFile(home / "a.zip") as archive:
        archive.extractall(root / "source")
    (root / "submission").mkdir()
    vrts = root / "vrts" / "bin" / "vrts"
    vrts.parent.mkdir(parents=True)
    vrts.write_text(
        f'#!/bin/sh\nPYTHONPATH="{ROOT}" exec "{sys.executable}" -m vrts.cli.main "$@"\n', "utf-8"
    )
    vrts.chmod(0o755)
    shutil.copy(root / "source" / "run_autograder", root / "run_autograder")
    (root / "run_autograder").chmod(0o755)
    return root


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """Return what Gradescope makes of the example."""
    return unpacked(EXAMPLE, tmp_path)


def run(root: Path, **environment: str) -> dict[str, Any]:
    """Run the script as the harness does, and return its result."""
    done = subprocess.run(
        [root / "run_autograder"],
        cwd="/",
        env={"PATH": os.environ["PATH"], "AUTOGRADER_ROOT": str(root), **environment},
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr.decode()
    found = json.loads((root / "results" / "results.json").read_bytes())
    jsonschema.validate(found, SCHEMA)
    assert str(root) not in json.dumps(found)
    return found


def test_the_zip_has_what_the_harness_looks_for(tmp_path: Path) -> None:
    data = autograder_zip(staff_task(EXAMPLE), {})
    assert data == autograder_zip(staff_task(EXAMPLE), {})
    (tmp_path / "a.zip").write_bytes(data)
    with zipfile.ZipFile(tmp_path / "a.zip") as archive:
        assert set(archive.namelist()) == {
            "setup.sh", "run_autograder", "not-marked.json", "README.md", "task.zip", "version",
        }  # fmt: skip
        assert archive.getinfo("run_autograder").external_attr >> 16 == MODE
        assert archive.read("version").decode().strip() == __version__
        assert read_zip(archive.read("task.zip")).manifest.staff
        for script in ("setup.sh", "run_autograder"):
            text = archive.read(script)
            assert text.startswith(b"#!/usr/bin/env bash\n")
            subprocess.run(["bash", "-n"], input=text, check=True)
        jsonschema.validate(json.loads(archive.read("not-marked.json")), SCHEMA)


@pytest.mark.thorough
def test_one_submission_is_marked(root: Path) -> None:
    shutil.copy(EXAMPLE / "submissions" / "hits-base.v2", root / "submission" / "mine.v2")
    found = run(root)
    assert found["score"] == 7
    assert sum(test["score"] for test in found["tests"]) == 7


@pytest.mark.thorough
def test_lateness_is_left_to_gradescope(tmp_path: Path) -> None:
    shutil.copytree(EXAMPLE, tmp_path / "task")
    with (tmp_path / "task" / "task.toml").open("a", encoding="utf-8") as task:
        task.write("\n[late]\ndue = 2026-11-01T12:00:00+01:00\nper_day = 1\n")
    root = unpacked(tmp_path / "task", tmp_path)
    shutil.copy(EXAMPLE / "solution.v2", root / "submission" / "pick.v2")
    found = run(root)
    assert found["score"] == 10
    assert "not sure" not in json.dumps(found)
    assert "when it came" not in json.dumps(found)


@pytest.mark.thorough
def test_hidden_checks_are_in_hidden_tests_only(tmp_path: Path) -> None:
    shutil.copytree(EXAMPLE, tmp_path / "task")
    (tmp_path / "task" / "staff").mkdir(exist_ok=True)
    (tmp_path / "task" / "staff" / "task.toml").write_text(HIDDEN, "utf-8")
    root = unpacked(tmp_path / "task", tmp_path)
    shutil.copy(EXAMPLE / "solution.v2", root / "submission" / "pick.v2")
    found = run(root)
    hidden = [test for test in found["tests"] if test["visibility"] == "hidden"]
    assert "a secret gate 4711" in {test["name"] for test in hidden}
    assert found["score"] < 10
    assert abs(sum(test.get("score", 0) for test in found["tests"]) - found["score"]) < 1e-4
    (later,) = [test for test in found["tests"] if test["visibility"] == "after_published"]
    assert later["score"] < 0
    seen = [test for test in found["tests"] if test["visibility"] != "hidden"]
    assert sum(test["score"] for test in seen if test["visibility"] == "visible") == 10
    assert "secret" not in json.dumps([seen, found["output"]])
    assert "more checks are made" in found["output"]


@pytest.mark.thorough
def test_a_mark_without_the_hidden_checks_is_none(root: Path) -> None:
    (root / "source" / "task.zip").write_bytes(student_zip(read_folder(EXAMPLE), 3))
    shutil.copy(EXAMPLE / "solution.v2", root / "submission" / "pick.v2")
    found = run(root)
    assert found["score"] == 0
    assert "could not be marked" in found["output"]


@pytest.mark.thorough
def test_several_files_are_of_one_student(root: Path) -> None:
    shutil.copy(EXAMPLE / "solution.v2", root / "submission" / "pick.v2")
    (root / "submission" / "notes").mkdir()
    (root / "submission" / "notes" / "readme.txt").write_text("my notes")
    assert run(root)["score"] == 10


@pytest.mark.thorough
def test_an_empty_submission_has_a_result(root: Path) -> None:
    found = run(root)
    assert found["score"] == 0
    assert found["output"]


@pytest.mark.thorough
def test_a_time_out_ends_with_a_result(root: Path) -> None:
    shutil.copy(EXAMPLE / "solution.v2", root / "submission" / "pick.v2")
    before = time.monotonic()
    found = run(root, AUTOGRADER_SECONDS="0.2")
    assert time.monotonic() - before < 20
    assert found["score"] == 0
    assert "could not be marked" in found["output"]


def set_up(home: Path, **environment: str) -> "subprocess.CompletedProcess[str]":
    """Run setup.sh with real pip."""
    path = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
    return subprocess.run(
        ["bash", home / "source" / "setup.sh"],
        env={"PATH": path, "AUTOGRADER_ROOT": str(home), **environment},
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.thorough
def test_setup_installs_the_wheel_of_the_zip_and_no_strangers(tmp_path: Path) -> None:
    """Stand-ins, without network: pip would take the stranger's if it were asked for the name."""
    ours = stand_in(tmp_path / "wheels", "ours")
    stranger = stand_in(tmp_path / "index", "a stranger's", build="-9")
    target = tmp_path / "a.zip"
    status, said = init("gradescope", EXAMPLE, "--wheels", ours.parent, "-o", target)
    assert status == 0, said
    home = tmp_path / "autograder"
    with zipfile.ZipFile(target) as archive:
        archive.extractall(home / "source")
    done = set_up(home, PIP_NO_INDEX="1", PIP_FIND_LINKS=str(stranger.parent))
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[-1] == "ours"


def test_setup_ends_where_the_wheel_is_missing(tmp_path: Path) -> None:
    (tmp_path / "source").mkdir()
    data = autograder_zip(staff_task(EXAMPLE), {})
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        archive.extractall(tmp_path / "source")
    done = set_up(tmp_path)
    assert done.returncode == 1
    assert "the wheel of vrts is not in this zip" in done.stderr
    assert not (tmp_path / "vrts").exists()


def test_no_script_asks_an_index_for_vrts(tmp_path: Path) -> None:
    """Not by name: after `install` stand options and the wheel's file."""
    with zipfile.ZipFile(io.BytesIO(autograder_zip(staff_task(EXAMPLE), {}))) as archive:
        texts = [archive.read(name).decode() for name in ("setup.sh", "run_autograder")]
    installs = re.findall(r"pip\S* install (.*)", "".join(texts))
    assert installs == [
        '--no-index --find-links "$wheels" "$wheel" ||',
        '--find-links "$wheels" "$wheel"',
    ]


@pytest.mark.thorough
def test_a_wheel_of_what_runs_here_goes_in(tmp_path: Path) -> None:
    target = tmp_path / "a.zip"
    status, said = init("gradescope", EXAMPLE, "-o", target)
    assert status == 0, said
    with zipfile.ZipFile(target) as archive:
        (name,) = [name for name in archive.namelist() if name.startswith("wheels/")]
        data = archive.read(name)
    assert name == f"wheels/vrts-{__version__}-py3-none-any.whl"
    site = tmp_path / "site"
    with zipfile.ZipFile(io.BytesIO(data)) as wheel:
        wheel.extractall(site)
        record = wheel.read(f"vrts-{__version__}.dist-info/RECORD").decode().splitlines()
        assert {line.split(",")[0] for line in record} == set(wheel.namelist())
    assert not list(site.rglob("__pycache__"))
    done = subprocess.run(
        [sys.executable, "-c", WHERE],
        cwd=tmp_path,
        env={"PATH": os.environ["PATH"], "PYTHONPATH": str(site), "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == [
        str(site / "vrts" / "__init__.py"),
        str(site / "vrts" / "library" / "examples" / "01-cans-on-bases"),
    ]


@pytest.mark.thorough
def test_pip_takes_the_wheel_that_was_made(tmp_path: Path) -> None:
    place = tmp_path / NAME
    place.write_bytes(own_wheel())
    pip = [sys.executable, "-m", "pip", "install", "-q", "--no-index", "--no-deps", "--no-compile"]
    subprocess.run([*pip, "--target", tmp_path / "site", place], check=True)
    assert (tmp_path / "site" / "bin" / "vrts").is_file()
    check = "from importlib.metadata import distribution as d; print(d('vrts').version)"
    told = subprocess.run(
        [sys.executable, "-c", check],
        env={"PYTHONPATH": str(tmp_path / "site")},
        capture_output=True,
        text=True,
        check=True,
    )
    assert told.stdout.strip() == __version__


def test_where_no_wheel_can_be_made_nothing_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def missing(name: str) -> NoReturn:
        raise PackageNotFoundError(name)

    monkeypatch.setattr(own_wheel_module, "distribution", missing)
    status, said = init("gradescope", EXAMPLE, "-o", tmp_path / "a.zip")
    assert status == 1
    assert "error[V755 no-wheel-of-vrts]: no wheel of vrts can be made" in said
    assert "--wheels dist" in said
    assert not (tmp_path / "a.zip").exists()


def test_wheels_without_vrts_are_refused(tmp_path: Path) -> None:
    (tmp_path / "click-8.1-py3-none-any.whl").write_bytes(b"")
    status, said = init("gradescope", EXAMPLE, "--wheels", tmp_path, "-o", tmp_path / "a.zip")
    assert status == 2
    assert f"the wheel of vrts {__version__} is not among the wheels" in said
    assert not (tmp_path / "a.zip").exists()


def test_what_students_get_makes_no_autograder(tmp_path: Path) -> None:
    place = tmp_path / "lab-student.zip"
    place.write_bytes(student_zip(read_folder(EXAMPLE), 3))
    status, said = init("gradescope", place, "-o", tmp_path / "a.zip")
    assert status == 1
    assert "V750" in said
    assert "3 checks are missing" in said
