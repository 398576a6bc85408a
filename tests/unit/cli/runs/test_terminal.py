"""The monitor and the pendant at a real terminal (a pty), and the monitor from a pipe."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.support_pty import Child
from vrts import __version__

PROGRAM = """\
.PROGRAM main
        MOVE #far
        BREAK
        TYPE "there"
.END
.PROGRAM forever
        DO
          n = n+1
          DELAY 0.1
          BREAK
        UNTIL n < 0
.END
.LOCATIONS
#far 20 -90 90 0 0 0
.END
.REALS
n 0
.END
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "cell.v2").write_text(PROGRAM)
    return tmp_path


def pipe(folder: Path, text: str, *options: str) -> str:
    found = subprocess.run(
        [sys.executable, "-m", "vrts.cli.main", "monitor", *options],
        input=text,
        capture_output=True,
        text=True,
        check=False,
        cwd=folder,
    )
    assert (found.returncode, found.stderr) == (0, "")
    return found.stdout


def test_a_pipe_is_a_transcript(folder: Path) -> None:
    assert pipe(folder, "LOAD cell\nEXECUTE main\nID\n") == (
        ".LOAD cell\n.PROGRAM main\n.PROGRAM forever\n"
        ".EXECUTE main\nthere\nProgram completed\n"
        f".ID\nvrts {__version__}, simulated VAL-II controller\n"
    )


def test_a_pipe_gives_commands_at_simulated_times(folder: Path) -> None:
    shown = pipe(folder, ";@ 1\nEXECUTE forever\n;@ 2\nABORT\nLISTR n > 5, n < 12\n", "cell.v2")
    assert "*ABORT\n(ABORTED)\nProgram stopped at forever, step 4\n" in shown
    assert shown.endswith("n > 5     -1\nn < 12    -1\n")


def test_a_pipe_confirms_what_is_asked_but_overwrites_nothing(folder: Path) -> None:
    shown = pipe(folder, "STORE cell\nZERO\nDIRECTORY\n", "cell.v2")
    assert "*File already exists*" in shown
    assert shown.endswith(".ZERO\n.DIRECTORY\n")
    assert (folder / "cell.v2").read_text() == PROGRAM
    pipe(folder, "STORE cell = forever\n", "cell.v2", "--overwrite")
    assert "#far" not in (folder / "cell.v2").read_text()


def test_a_program_without_end_is_followed_for_a_while(folder: Path) -> None:
    found = subprocess.run(
        [sys.executable, "-m", "vrts.cli.main", "monitor", "cell.v2"],
        input="EXECUTE forever\n",
        capture_output=True,
        text=True,
        check=False,
        cwd=folder,
    )
    assert found.returncode == 0
    assert found.stderr == "the program still executes, after 600 s of simulated time\n"


def test_answers_of_a_scenario_are_shown_and_typed_ones_follow(folder: Path) -> None:
    (folder / "ask.v2").write_text('.PROGRAM main\nPROMPT "a ", a\nPROMPT "b ", b\n.END\n')
    (folder / "cell.toml").write_text('[prompts]\nanswers = ["1"]\n')
    shown = pipe(folder, "EXECUTE main\n2\nLISTR\n", "ask.v2", "--scenario", "cell.toml")
    assert "a 1\nb 2\nProgram completed\n" in shown
    assert shown.endswith("a         1\nb         2\n")


def test_what_programs_write_cannot_steer_the_terminal(folder: Path) -> None:
    (folder / "bell.v2").write_text('.PROGRAM main\nTYPE /B, $CHR(27), "[2J"\n.END\n')
    shown = pipe(folder, "EXECUTE main\n", "bell.v2")
    assert "\x1b" not in shown
    assert "\a" not in shown


@pytest.mark.thorough
def test_the_monitor_at_a_terminal(folder: Path) -> None:
    child = Child(["monitor", "cell.v2"], folder)
    child.expect("Ctrl-D leaves")
    child.send("EXECUTE main\r")
    child.expect("there")  # while nothing is typed: real time goes on
    child.expect("Program completed")
    child.send("LISTR 6*7\r")
    child.expect(r"6\*7 +42")
    child.send("EXECUTE forever\r")
    child.expect(r"\*")  # the prompt changes
    child.send("\x03")
    child.expect(r"\(ABORTED\)")
    child.expect(r"Program stopped at forever, step \d")
    child.send("DIRECT\t\r")  # completion
    child.expect("DIRECTORY")
    child.expect("main")
    child.send("ZERO\r")
    child.expect(r"Are you sure \(Y/N\)\?")
    child.send("N\r")
    child.send("EDIT new\r")
    child.expect(r"1\.\?")
    child.send("\x03")  # leaves the editor
    assert child.leave() == 0
    child.close()
    history = (folder / "cache" / "vrts" / "monitor-history").read_text()
    assert "+EXECUTE main\n" in history


def test_the_pendant_at_a_terminal(folder: Path) -> None:
    child = Child(["teach", "cans-on-bases", "-o", "points.v2", "--terminal"], folder)
    child.expect("joint")
    record(child, "p1")
    child.send("q")  # joint 1, one step: 5 degrees
    child.expect(r"1     5\.000 ")  # the arm has come to where joint 1 is to be
    record(child, "p2")
    child.send("x")
    child.expect("2 locations written to points.v2")
    assert child.status() == 0
    child.close()
    title, first, second, end = (folder / "points.v2").read_text().splitlines()
    assert (title, end) == (".LOCATIONS", ".END")
    turned = float(second.split()[4]) - float(first.split()[4])  # O of a hand that points up
    assert turned == pytest.approx(5.0, abs=1e-3)


def record(child: Child, name: str) -> None:
    child.send(" ")
    child.expect(rf"name of the location \[{name}\]")
    child.send("\r")
    child.expect("recorded")


def test_teaching_needs_a_terminal_and_overwrites_nothing(folder: Path) -> None:
    command = [sys.executable, "-m", "vrts.cli.main", "teach", "cans-on-bases", "-o", "cell.v2"]
    found = subprocess.run(
        [*command, "--terminal"], capture_output=True, text=True, check=False, cwd=folder
    )
    assert found.returncode == 2
    assert "the pendant needs a terminal" in found.stderr
