"""Interactive screens: Ctrl-C stops what is under way; Ctrl-D and a hang-up end them."""

import signal
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support_pty import Child

PROGRAM = """\
.PROGRAM main
        DELAY 1
        FOR i = 1 TO n
          x = x+1
        END
.END
.REALS
n 0
x 0
.END
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "prog.v2").write_text(PROGRAM)
    return tmp_path


@pytest.fixture
def screens() -> Iterator[list[Child]]:
    shown: list[Child] = []
    yield shown
    for child in shown:
        child.close()


def shown(screens: list[Child], folder: Path, *words: str) -> Child:
    screens.append(Child(list(words), folder))
    return screens[-1]


@pytest.mark.thorough
def test_in_the_debugger_ctrl_c_gives_a_typed_line_up_and_ctrl_d_leaves(
    folder: Path, screens: list[Child]
) -> None:
    child = shown(screens, folder, "debug", "prog.v2")
    child.expect("0.000 s of")
    child.send(":x = 5")
    child.expect("x = 5")
    child.send("\x03")
    child.send("\x03")  # nothing is under way any more
    child.expect("stopped: nothing is changed; q or Ctrl-D leaves")
    child.send("\x04")
    child.expect("left at 0.000 s")
    assert child.status() == 0


@pytest.mark.thorough
def test_in_the_debugger_ctrl_c_gives_up_what_is_worked_out(
    folder: Path, screens: list[Child]
) -> None:
    child = shown(screens, folder, "debug", "prog.v2")
    child.expect("0.000 s of")
    child.send(":n = 10000000")
    child.expect("n = 10000000")  # while a key is taken Ctrl-C is a signal too
    child.send("\r")
    child.until_signals()
    child.send("\x03")
    child.expect("stopped: nothing is changed")
    child.send("q")
    child.expect("left at")
    assert child.status() == 0


def test_at_the_pendant_ctrl_c_stops_the_arm_and_ctrl_d_keeps_what_was_recorded(
    folder: Path, screens: list[Child]
) -> None:
    child = shown(screens, folder, "teach", "cans-on-bases", "-o", "points.v2", "--terminal")
    child.expect("joint")
    record(child, "p1")
    child.send("++++q\x03")  # joint 1 begins to move far
    child.expect("stopped")
    record(child, "p2")
    child.send("\x04")
    child.expect("2 locations written to points.v2")
    assert child.status() == 0
    first, second = (folder / "points.v2").read_text().splitlines()[1:3]
    assert abs(float(second.split()[4]) - float(first.split()[4])) < 45.0  # not all of the way


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("words", "ready"),
    [(("monitor", "prog.v2"), "Ctrl-D leaves"), (("debug", "prog.v2"), "0.000 s of")],
    ids=["monitor", "debug"],
)
def test_a_hang_up_ends_a_screen(
    words: tuple[str, ...], ready: str, folder: Path, screens: list[Child]
) -> None:
    child = shown(screens, folder, *words)
    child.expect(ready)
    assert child.hang_up() in (129, -signal.SIGHUP)


def test_a_hang_up_at_the_pendant_loses_nothing(folder: Path, screens: list[Child]) -> None:
    child = shown(screens, folder, "teach", "cans-on-bases", "-o", "points.v2", "--terminal")
    child.expect("joint")
    record(child, "p1")
    child.hang_up()
    assert "p1" in (folder / "points.v2").read_text()


def record(child: Child, name: str) -> None:
    child.send(" ")
    child.expect(rf"name of the location \[{name}\]")
    child.send("\r")
    child.expect("recorded")
