"""What `vrts grade` writes for students: nothing of the staff, of others, or of the machine."""

import os
import re
import shutil
import sys
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
HIDDEN = """
[[via]]
name = "a secret gate 471108150815"
at_mm = [731.48, 213.95, 517.61]
radius_mm = 43.27
"""
STAFF_VALUES = (  # so long that nothing else has them by chance
    *("secret gate 471108150815", "471108150815", "a secret"),
    *("0.73148", "0.21395", "0.51761", "0.04327", "731.48", "213.95", "517.61", "43.27"),
)
PACKED = re.compile(rb"[A-Za-z0-9+/=]{200,}")  # pictures and the replay: any letters, by chance
NAMES = ("anna-berg", "zoltan-kis", "not-text")


@pytest.fixture(scope="module", params=[True, False], ids=["hidden checks", "none"])
def out(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    home = tmp_path_factory.mktemp("secret-home-of-the-grader")
    shutil.copytree(EXAMPLE, home / "task")
    if request.param:
        (home / "task" / "staff").mkdir(exist_ok=True)
        (home / "task" / "staff" / "task.toml").write_text(HIDDEN)
    handed_in = home / "class-of-26"
    handed_in.mkdir()
    for name, program in zip(NAMES[:2], ("hits-base.v2", "undefined-location.v2"), strict=True):
        shutil.copy(EXAMPLE / "submissions" / program, handed_in / f"{name}.v2")
    (handed_in / "not-text.v2").write_bytes(b"\0\1\2")
    words = ("grade", home / "task" / "task.toml", handed_in, "--recordings", "-o", "out")
    done = vrts_text(*words, cwd=home)
    assert done.returncode == 0, done.stderr
    return home / "out"


@pytest.mark.thorough
def test_each_has_two_reports(out: Path) -> None:
    for name in NAMES:
        ran = ["motion.json"] if name != "not-text" else []
        assert sorted(p.name for p in (out / "staff" / "students" / name).iterdir()) == [
            *ran,
            "report.html",
            "result.json",
        ]
        student = {p.name for p in (out / "students" / name).iterdir()}
        least = {"feedback.txt", "report.html", "result.json"}
        assert least <= student <= {*least, "run.rrd"}
    assert "Facts for an appeal" in (out / "staff/students/anna-berg/report.html").read_text()


@pytest.mark.thorough
@pytest.mark.parametrize("name", NAMES)
def test_a_student_file_holds_nothing_of_the_staff_of_others_or_of_the_machine(
    out: Path, name: str
) -> None:
    files = [path for path in (out / "students" / name).rglob("*") if path.is_file()]
    assert len(files) >= 2
    others = [other for other in NAMES if other != name]
    machine = [os.fspath(out.parent), out.parent.name, "class-of-26", os.fspath(ROOT), "/tmp/"]
    machine += [os.fspath(Path.home()) + "/", os.fspath(Path(sys.prefix))]
    for path in files:
        data = PACKED.sub(b"", path.read_bytes())
        values = (*others, *machine, *STAFF_VALUES[:3], "Facts for an appeal")
        if path.suffix != ".rrd":  # where digits may stand for anything
            values = (*values, *STAFF_VALUES[3:]) if path.name == "result.json" else values
        found = [value for value in values if value.encode() in data]
        assert found == [], path.name


def test_staff_values_are_in_what_the_staff_gets(out: Path) -> None:
    report = (out / "staff" / "students" / "anna-berg" / "report.html").read_text()
    public = (out / "students" / "anna-berg" / "report.html").read_text()
    hidden = (out.parent / "task" / "staff").exists()
    assert (STAFF_VALUES[0] in report) == hidden
    assert ('class="tag hidden"' in report) == hidden
    assert ("1 more at marking" in public) == hidden
