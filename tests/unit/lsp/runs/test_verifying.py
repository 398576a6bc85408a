"""What runs in the background find, where it is shown, and the speed that would do."""

import json
import math
import subprocess
import sys
from pathlib import Path

import pytest

from tests.places import ROOT
from vrts.base.diagnostic import Severity
from vrts.lsp.channel.findings import Finding
from vrts.lsp.channel.verification import Answer, Asked
from vrts.lsp.runs.speeds import applied
from vrts.lsp.runs.verifying import verify

EXAMPLES = ROOT / "examples"
CANS = EXAMPLES / "01-cans-on-bases"
TOO_FAST = """.PROGRAM main
        DRIVE 2, 45, 100
        DRIVE 3, 30, 100
        DRIVE 5, 6, 100         ; the hand almost in line with the arm
        HERE p
{}        MOVES SHIFT(p BY 0,-400,0)
.END
"""
LINES = """.PROGRAM main
        SPEED 80 ALWAYS
        MOVE a
        MOVES b
20      MOVES a
        MOVE b
.END
.LOCATIONS
a               600 0 0 90 90 0
b               600 200 0 90 90 0
.END
"""
TASK = """[task]
title = "a"
scene = "cans-on-bases"
[time]
reference_s = 10
[[goal]]
object = "can1"
on = "base2"
"""


def found(text: str, path: Path = Path("/nowhere/a.v2")) -> tuple[Finding, ...]:
    return verify(Asked(str(path), text)).findings


def codes(findings: tuple[Finding, ...]) -> list[str]:
    return [finding.code for finding in findings]


def mended(text: str, code: str, path: Path = Path("/nowhere/a.v2")) -> str:
    """Return the text with the edits that are offered for its findings of a code."""
    findings = [finding for finding in found(text, path) if finding.code == code]
    (mending,) = {finding.mending for finding in findings}
    assert mending is not None
    return applied(text, mending.edits)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("", "        SPEED {}\n        MOVES"),
        ("        SPEED 100 ALWAYS\n", "SPEED 100 ALWAYS\n        SPEED {}\n        MOVES"),
        ("        SPEED 500 MMPS ; quick\n; away\n", "SPEED {} ; quick\n; away\n        MOVES"),
        ("        SPEED 500 MMPS\n10", "SPEED 500 MMPS\n10      SPEED {}\n        MOVES"),
    ],
)
def test_the_speed_that_would_do_does(before: str, after: str) -> None:
    text = TOO_FAST.format(before).replace("10        MOVES", "10      MOVES")
    assert "V302" in codes(found(text))
    result = mended(text, "V302")
    assert "V302" not in codes(found(result))
    speeds = [n for n in range(1, 100) if after.format(n) in result]
    assert len(speeds) == 1  # one that is written where it should be
    faster = result.replace(f"SPEED {speeds[0]}", f"SPEED {math.ceil(1.4 * speeds[0])}")
    assert "V302" in codes(found(faster))  # and it is not much slower than it has to be


def task(folder: Path, more: str) -> Path:
    (folder / "task.toml").write_text(TASK + more, "utf-8")
    return folder / "a.v2"


def test_every_motion_that_is_too_fast_for_the_task_gets_its_speed(tmp_path: Path) -> None:
    path = task(tmp_path, "[[limit]]\ntool_mm_s = 250\n")
    (finding,) = [f for f in found(LINES, path) if f.code == "V434"]
    assert "faster than 250 mm/s" in finding.message
    assert "found in the scene `cans-on-bases`, at " in finding.message
    assert "help: set SPEED 15 to 25 for 4 motions: that would do" in finding.message
    result = mended(LINES, "V434", path)
    assert result.count("SPEED") == 5
    assert "20      SPEED " in result
    assert "V434" not in codes(found(result, path))


@pytest.mark.thorough
def test_a_via_point_that_is_passed_too_fast(tmp_path: Path) -> None:
    via = '[[via]]\nname = "v"\nat_mm = [600, 100, 0]\nradius_mm = 10\nspeed_mm_s = [{}]\n'
    text = LINES.replace("        MOVE b\n", "").replace("20      MOVES a\n", "")
    path = task(tmp_path, via.format("0, 300"))
    assert "V441" in codes(found(text, path))
    assert "V441" not in codes(found(mended(text, "V441", path), path))
    slow = text.replace("SPEED 80", "SPEED 10")
    path = task(tmp_path, via.format("200, 300"))
    assert "V441" in codes(found(slow, path))
    result = mended(slow, "V441", path)
    assert "V441" not in codes(found(result, path))


def test_no_speed_is_offered_where_none_does(tmp_path: Path) -> None:
    path = task(tmp_path, "[[limit]]\ntool_mm_s = 1\n")
    assert [f.mending for f in found(LINES, path) if f.code == "V434"] == [None]


def test_findings_say_where_they_come_from() -> None:
    path = CANS / "submissions" / "hits-base.v2"
    text = path.read_text("utf-8")
    (contact,) = [f for f in found(text, path) if f.code == "V400"]
    assert contact.message.splitlines()[0].startswith("the held `can1` hits `base1`")
    assert "found in the scene `cans-on-bases`, at 5.0" in contact.message
    assert text[contact.start : contact.end] == "APPROS base2_put, 60"
    missed = (CANS / "submissions" / "forgets-openi.v2").read_text("utf-8")
    goals = [f for f in found(missed, path) if f.code == "V660"]
    assert {missed[goal.start : goal.end] for goal in goals} == {"cans"}
    assert {goal.severity for goal in goals} == {Severity.NOTE}


def test_the_same_at_the_same_place_is_told_once() -> None:
    path = CANS / "submissions" / "endless-loop.v2"
    findings = found(path.read_text("utf-8"), path)
    assert sorted(codes(findings)) == ["V310", "V400", "V503", "V660"]
    assert sum("; 2 times" in finding.message for finding in findings) == 2


def test_answers_come_as_they_are_known() -> None:
    path = CANS / "solution.v2"
    early: list[Answer] = []
    last = verify(Asked(str(path), path.read_text("utf-8")), early.append)
    assert last.is_whole
    assert not any(answer.is_whole for answer in early)
    assert [len(answer.timings) for answer in early] == [len(last.timings)] * 3
    assert all(timing.clearance_mm is None for timing in early[0].timings)
    assert last.findings == ()


def test_bounds_of_the_editor_are_told_as_such() -> None:
    text = ".PROGRAM main\n x = 0\n FOR k = 1 TO 150000\n x = x+k\n END\n READY\n.END\n"
    (finding,) = found(text)
    assert finding.code == "V797"
    assert finding.severity is Severity.NOTE
    assert "200,000 steps" in finding.message
    assert "`vrts verify` takes the time it needs" in finding.message


@pytest.mark.parametrize("lines", ['[task]\nscene = "none-such"\n', "[task]\nscene = 3\n", "[["])
def test_a_task_that_cannot_be_read_is_told(tmp_path: Path, lines: str) -> None:
    (tmp_path / "task.toml").write_text(lines, "utf-8")
    (finding,) = found(LINES, tmp_path / "a.v2")
    assert finding.code == "V798"
    assert LINES[finding.start : finding.end] == "main"
    assert "note: " in finding.message
    assert str(tmp_path) not in finding.message


def test_programs_of_other_files() -> None:
    text = ".PROGRAM main\n        CALL put\n.END\n"
    other = TOO_FAST.format("").replace("main", "put")
    asked = Asked("/c/a.v2", text, (("/c/b.v2", other),))
    (finding,) = [f for f in verify(asked).findings if f.code == "V302"]
    assert text[finding.start : finding.end] == "main"
    (place,) = finding.related
    assert place.path == "/c/b.v2"
    assert other[place.start : place.end].startswith("MOVES")
    assert finding.mending is None  # it would be in the other file
    alone = Asked("/c/b.v2", other, (("/c/a.v2", text),), is_called=True)
    assert verify(alone) == Answer(is_whole=True)  # it is no program by itself


def test_a_verification_ends_where_its_input_ends() -> None:
    path = CANS / "solution.v2"
    asked = Asked(str(path), path.read_text("utf-8"))
    done = subprocess.run(
        [sys.executable, "-m", "vrts.lsp.runs.verifying"],
        input=json.dumps(asked).encode() + b"\n",
        capture_output=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == 1  # nobody is left who would read the answer
    assert done.stdout == done.stderr == b""
