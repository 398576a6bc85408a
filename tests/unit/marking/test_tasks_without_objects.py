"""Tasks that ask for a path, or for rules alone: checked, verified, marked, exported, reported."""

import json
import os
import subprocess
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text

HEAD = '[task]\ntitle = "A path"\nscene = "cans-on-bases"\n'
PATH = '[[via]]\nname = "gate1"\nat_mm = [900, 300, 100]\n'
ZONE = '[[zone]]\nname = "left"\nfrom_mm = [0, 1000, 0]\nto_mm = [10, 1010, 10]\npoints = 0.5\n'
RULES = '[[rule]]\nmust_use = "MOVES"\npoints = 9\n'
TIME = "[time]\nreference_s = 3\n"
GOOD = """.PROGRAM main()
        MOVE gate1
        BREAK
        MOVES gate2
.END
.LOCATIONS
gate1 900 300 100 90 90 0
gate2 900 -300 100 90 90 0
.END
"""
STOPS = GOOD.replace("MOVES gate2", "MOVES nowhere")
EMPTY = ".PROGRAM main()\n        DELAY 1\n.END\n"
EXPORTS = (
    *("csv", "json", "junit", "sarif", "gradescope", "prairielearn", "folders", "moodle-feedback"),
)


def vrts(*words: str | Path, cwd: Path) -> "subprocess.CompletedProcess[str]":
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "NO_COLOR": "1"}
    return vrts_text(*words, cwd=cwd, env=environment)


TASKS = [
    (HEAD + PATH + TIME, {"good": 10.0, "stops": 8.5, "empty": 0.0}, "Via points"),
    pytest.param(
        HEAD + PATH + ZONE + RULES + TIME,
        {"good": 10.0, "stops": 8.5, "empty": 0.0},
        "Via points",
        marks=pytest.mark.thorough,
    ),
    pytest.param(
        HEAD + RULES + TIME,
        {"good": 10.0, "stops": 0.0, "empty": 0.0},
        "Coming to the end",
        marks=pytest.mark.thorough,
    ),
]


@pytest.mark.thorough
@pytest.mark.parametrize(("text", "marks", "part"), TASKS)
def test_a_task_without_objects(
    text: str, marks: dict[str, float], part: str, tmp_path: Path
) -> None:
    folder = tmp_path / "path"
    (folder / "staff").mkdir(parents=True)
    (folder / "task.toml").write_text(text)
    (folder / "staff" / "solution.v2").write_text(GOOD)
    checked = vrts("task", "check", "path", cwd=tmp_path)
    assert checked.returncode == 0, checked.stderr
    assert "reference      10.0 of 10\n  empty program   0.0 of 10" in checked.stdout
    assert vrts("scene", "check", "path", cwd=tmp_path).returncode == 0
    assert vrts("task", "pack", "path", cwd=tmp_path).returncode == 0
    for name, program in (("good", GOOD), ("stops", STOPS), ("empty", EMPTY)):
        (tmp_path / f"{name}.v2").write_text(program)
    files = [f"{name}.v2" for name in marks]
    graded = vrts("grade", "path-staff.zip", *files, "-o", "out", cwd=tmp_path)
    assert graded.returncode == 0, graded.stderr
    for name, mark in marks.items():
        path = tmp_path / "out" / "staff" / "students" / name / "result.json"
        result = json.loads(path.read_text())
        assert result["mark"] == mark
        assert sum(check["points"] for check in result["checks"]) == pytest.approx(mark)
        assert sum(check["most"] for check in result["checks"]) == pytest.approx(10)
        lost = sum(loss["points"] for loss in result["losses"])
        assert lost == pytest.approx(10 - mark)
        page = path.with_name("report.html").read_text()
        assert f">{part}<" in page
        assert ">Goals<" not in page
    words = [word for form in EXPORTS for word in ("--to", form)]
    exported = vrts("grade", "export", "out", *words, cwd=tmp_path)
    assert exported.returncode == 0, exported.stderr
    verified = vrts("verify", "good.v2", "--task", "path/task.toml", cwd=tmp_path)
    assert verified.returncode == 0, verified.stdout
    assert "every goal" not in verified.stdout
