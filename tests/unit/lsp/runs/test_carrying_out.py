"""What is done when somebody orders in an editor that a program is run, verified or debugged."""

import shutil
from pathlib import Path

import pytest

from tests.places import ROOT
from vrts.lsp.channel.ordered import FAULT, Ordered, done_of, line_of_ordered, ordered_of
from vrts.lsp.runs.carrying_out import carry_out

CANS = ROOT / "examples" / "01-cans-on-bases"
HITS = (CANS / "submissions" / "hits-base.v2").read_text("utf-8")
TWO = """.PROGRAM main
        TYPE "nothing to do"
.END
.PROGRAM other
        DRIVE 1, 10, 50
        TYPE "turned"
.END
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("cell")
    shutil.copy(CANS / "task.toml", found)
    return found


def test_a_buffer_runs_in_the_scene_of_its_task(folder: Path) -> None:
    done = carry_out(Ordered("run", str(folder / "a.v2"), TWO, "other"))
    assert done.status == 0
    assert done.short.startswith("`other`: completed after ")
    assert done.short.endswith("in the scene `cans-on-bases`\nturned")
    assert done.text.startswith("turned\n")


def test_without_a_task_the_robot_is_alone(tmp_path: Path) -> None:
    done = carry_out(Ordered("run", str(tmp_path / "a.v2"), TWO))
    assert done.short.endswith("with the robot alone\nnothing to do")
    assert carry_out(Ordered("verify", str(tmp_path / "a.v2"), TWO)).status == 0


def test_a_verification_is_that_of_the_command(folder: Path) -> None:
    done = carry_out(Ordered("verify", str(folder / "a.v2"), HITS))
    assert done.status == 1
    assert done.short.startswith("7.0 / 10  a.v2")
    assert "the held `can1` hits `base1`" in done.short
    assert "mark, of 10" in done.text


def test_debugging_shows_the_run_and_says_how_to_go_on(folder: Path) -> None:
    done = carry_out(Ordered("debug", str(folder / "a.v2"), TWO, "other"))
    assert done.status == 0
    assert "`vrts debug a.v2 --entry other`" in done.short
    assert "<html" in done.page
    assert "turned" in done.page


@pytest.mark.parametrize("work", ["run", "verify", "debug"])
def test_what_cannot_run_is_told(folder: Path, tmp_path: Path, work: str) -> None:
    text = TWO.replace("DRIVE", "DRIVVE")
    done = carry_out(Ordered(work, str(folder / "a.v2"), text))
    assert done.status == 1
    assert "DRIVVE" in done.text
    assert done.page == ""
    (tmp_path / "task.toml").write_text("[task]\nscene = 5\n", "utf-8")
    done = carry_out(Ordered(work, str(tmp_path / "a.v2"), TWO))
    assert (done.status, done.short) == (1, "the task beside this program cannot be read")
    assert "scene" in done.text


def test_words_between_the_processes() -> None:
    ordered = Ordered("run", "/c/a.v2", TWO, None, (("/c/b.v2", "x"),))
    assert ordered_of(line_of_ordered(ordered)) == ordered
    assert done_of(b"").status == FAULT
