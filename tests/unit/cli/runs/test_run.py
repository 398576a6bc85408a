"""`vrts run` as a time machine: states, replays, tables and files."""

import csv
import io
from pathlib import Path

import pytest

from tests.unit.cli.test_commands import SOLUTION, vrts
from vrts.cli.shared.pacing import show_paced
from vrts.report.screen.replay_text import Told

CANS = (SOLUTION, "--scene", "cans-on-bases")
FAILS = ".PROGRAM main\n  n = 1\n  TYPE n\n  MOVE nowhere\n.END\n"


@pytest.fixture(scope="module")
def saved(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the file of the run of the first example."""
    path = tmp_path_factory.mktemp("runs") / "out.vrun"
    result = vrts("run", *CANS, "--save", path)
    assert result.returncode == 0
    assert f"wrote {path}".encode() in result.stderr
    return path


@pytest.mark.thorough
def test_a_saved_run_is_asked_as_a_program_is(saved: Path) -> None:
    for words in (
        ("--at", "2.8"),
        ("--statement", "9"),
        ("--from", "3", "--to", "1.5"),
        ("--csv", "-", "--rate", "5"),
        (),
    ):
        asked, executed = vrts("run", saved, *words), vrts("run", *CANS, *words)
        assert asked.stdout == executed.stdout != b""
        assert asked.returncode == executed.returncode == 0


def test_a_saved_run_needs_neither_program_nor_scene(saved: Path, tmp_path: Path) -> None:
    elsewhere = tmp_path / "named-as-it-likes"
    elsewhere.write_bytes(saved.read_bytes())
    result = vrts("run", elsewhere, "--at", "2.8", cwd=tmp_path)
    assert result.returncode == 0
    assert b"holds can1" in result.stdout


def test_a_check_executes_again(saved: Path) -> None:
    result = vrts("run", saved, "--check")
    assert result.returncode == 0
    assert result.stderr.endswith(b"holds: executed again, everything is the same\n")


def test_a_damaged_run_is_one_diagnostic_and_status_1(saved: Path, tmp_path: Path) -> None:
    broken = tmp_path / "broken.vrun"
    broken.write_bytes(saved.read_bytes()[:9000])
    result = vrts("run", broken, "--at", "1", "--color", "never")
    assert result.returncode == 1
    assert result.stdout == b""
    assert result.stderr.decode().splitlines()[-1] == "1 error"
    assert result.stderr.startswith(b"error[V540 damaged-run]: the saved run ")


def test_a_run_that_failed_is_saved_and_still_fails(tmp_path: Path) -> None:
    program, path = tmp_path / "fails.v2", tmp_path / "fails.vrun"
    program.write_text(FAILS)
    first = vrts("run", program, "--save", path)
    again = vrts("run", path)
    assert first.returncode == again.returncode == 1
    assert first.stdout == again.stdout
    assert b"error[V250" in again.stderr
    assert b"MOVE nowhere" in again.stderr


def test_the_end_may_be_given_as_it_is_printed(saved: Path) -> None:
    end = vrts("run", saved).stderr.split(b"completed after ")[1].split()[0].decode()
    for words in (("--at", end), ("--from", end, "--to", "9"), ("--to", end)):
        assert vrts("run", saved, *words).returncode == 0


@pytest.mark.thorough
def test_wrong_calls_say_what_is_wrong(saved: Path, tmp_path: Path) -> None:
    program = tmp_path / "fails.v2"
    program.write_text(FAILS)
    for words, reason in (
        ((saved, "--scene", "cans-on-bases"), "a saved run has its own scene, scenario"),
        ((program, "--check"), "only a saved run can be checked"),
        ((saved, "--at", "1", "--statement", "2"), "is shown at a time"),
        ((saved, "--at", "99"), "the run goes from 0 to "),
        ((saved, "--speed", "nan"), "--speed is 0, or from 0.001 to 1e+06"),
        ((saved, "--speed", "1e-300"), "--speed is 0, or from 0.001 to 1e+06"),
        ((saved, "--at", "inf"), "the run goes from 0 to "),
        ((saved, "--at", "nan"), "the run goes from 0 to "),
        ((saved, "--from", "-1"), "the run goes from 0 to "),
        ((saved, "--statement", "3200"), "the run has "),
        ((saved, "--from", "5", "--to", "1", "--speed", "2"), "goes backward"),
        ((saved, "--csv", "-", "--rate", "0"), "--rate goes from 0.001 to 1000 Hz"),
        ((program, "--save", program, "--overwrite"), "is what is to be run"),
    ):
        result = vrts("run", *words)
        assert result.returncode == 2, words
        assert reason in result.stderr.decode()


def test_files_are_not_replaced_without_being_told(saved: Path, tmp_path: Path) -> None:
    for option, name in (("--save", "there.vrun"), ("--csv", "there.csv")):
        there = tmp_path / name
        there.write_bytes(b"mine")
        refused = vrts("run", saved, option, there)
        assert refused.returncode == 2
        assert b"is there already" in refused.stderr
        assert there.read_bytes() == b"mine"
        assert vrts("run", saved, option, there, "--overwrite").returncode == 0
        assert there.read_bytes() != b"mine"
    assert (tmp_path / "there.vrun").read_bytes() == saved.read_bytes()


def test_a_replay_tells_every_step_with_its_line(saved: Path) -> None:
    lines = vrts("run", saved, "--speed", "0").stdout.decode().splitlines()
    assert lines[0] == "    0.000 s            * program main starts"
    words = [line[13:] for line in lines]
    assert "line 16   * can1 grasped" in words
    assert words.count("line 14     SPEED 30") == 2
    assert words[-1] == "          * program over: completed"
    assert [line for line in words if "  + " in line] == ["line 9    + Both cans are in place."]
    times = [float(line[:9]) for line in lines]
    assert times == sorted(times)


def test_backward_is_the_same_from_behind(saved: Path) -> None:
    forward = vrts("run", saved, "--from", "4", "--to", "10").stdout.decode().splitlines()
    backward = vrts("run", saved, "--from", "10", "--to", "4").stdout.decode().splitlines()
    assert [line.replace("  - ", "  + ") for line in backward[::-1]] == forward
    assert len(forward) > 30
    assert any("  - Both cans are in place." in line for line in backward)


def test_a_negative_speed_turns_the_times_round(saved: Path) -> None:
    words = ("--from", "2", "--to", "3", "--speed", "-50")
    turned = vrts("run", saved, *words)
    assert turned.returncode == 0
    assert turned.stdout == vrts("run", saved, "--from", "3", "--to", "2").stdout


def test_a_table_has_a_row_for_every_instant(saved: Path, tmp_path: Path) -> None:
    path = tmp_path / "motion.csv"
    result = vrts("run", saved, "--csv", path, LC_ALL="de_DE.UTF-8")
    assert result.returncode == 0
    assert result.stdout == b"Both cans are in place.\n"
    rows = list(csv.DictReader(io.StringIO(path.read_text("utf-8"))))
    ended = float(result.stderr.split(b"completed after ")[1].split()[0])
    assert len(rows) == int(ended * 50 + 1e-6) + 1
    assert [row["time_s"] for row in rows[:3]] == ["0.000", "0.020", "0.040"]
    assert rows[150]["time_s"] == "3.000"
    assert rows[150]["held"] == "can1"
    assert rows[150]["program"] == "carry"


class Clock:
    """A clock that only waiting moves."""

    def __init__(self) -> None:
        self.now = 100.0
        self.shown: list[tuple[float, str]] = []

    def tell(self) -> float:
        return self.now

    def wait(self, seconds: float) -> None:
        assert seconds > 0.0
        self.now += seconds

    def write(self, text: str) -> None:
        self.shown.append((round(self.now - 100.0, 6), text))


@pytest.mark.parametrize(
    ("speed", "due"),
    [
        (1.0, [0.0, 2.0, 2.0, 5.0]),
        (4.0, [0.0, 0.5, 0.5, 1.25]),
        (0.5, [0.0, 4.0, 4.0, 10.0]),
        (0.0, [0.0, 0.0, 0.0, 0.0]),
    ],
)
def test_lines_are_shown_when_they_are_due(speed: float, due: list[float]) -> None:
    lines = [Told(10.0, "a"), Told(12.0, "b"), Told(12.0, "c"), Told(15.0, "d")]
    clock = Clock()
    show_paced(lines, 10.0, speed, clock.write, clock.tell, clock.wait)
    assert clock.shown == list(zip(due, "abcd", strict=True))
    backward = Clock()
    show_paced(lines[::-1], 15.0, -speed, backward.write, backward.tell, backward.wait)
    waited = [round(due[-1] - time_s, 6) for time_s in due[::-1]]
    assert backward.shown == list(zip(waited, "dcba", strict=True))


# --- where it runs ------------------------------------------------------------------------------


def test_without_a_scene_it_says_that_the_robot_is_bare(tmp_path: Path) -> None:
    (tmp_path / "p.v2").write_text(".PROGRAM main\n  TYPE 1\n.END\n")
    said = vrts("run", "p.v2", cwd=tmp_path)
    assert said.stdout == b" 1\n"
    assert b"no scene: a bare Unimation PUMA 761 with no tool" in said.stderr
    named = vrts("run", "p.v2", "--scene", "cans-on-bases", cwd=tmp_path)
    assert b"bare" not in named.stderr


def test_the_task_beside_the_program_is_taken(tmp_path: Path) -> None:
    beside, named = vrts("run", SOLUTION), vrts("run", *CANS)
    assert beside.stdout == named.stdout == b"Both cans are in place.\n"
    assert b"in the scene `cans-on-bases`, as the task beside the program has it" in beside.stderr
    elsewhere = tmp_path / "p.v2"
    elsewhere.write_bytes(Path(SOLUTION).read_bytes())
    given = vrts("run", elsewhere, "--task", Path(SOLUTION).parent)
    assert given.stdout == named.stdout


# --- what it tells as `verify` does -------------------------------------------------------------

FAST = """.PROGRAM main
        MOVE TRANS(250,-300,400,0,180,0)
        BREAK
        MOVES TRANS(250,300,400,0,180,0)
.END
"""


@pytest.mark.thorough
def test_a_joint_that_is_too_fast_is_told_as_verify_tells_it(tmp_path: Path) -> None:
    program = tmp_path / "fast.v2"
    program.write_text(FAST)
    ran, verified = (vrts(word, program, "--scene", "one-can-ur5") for word in ("run", "verify"))
    assert ran.returncode == verified.returncode == 1

    def told(text: bytes) -> list[bytes]:
        return [part for part in text.split(b"\n\n") if b"[V302 joint-speed]" in part]

    (found,) = told(ran.stderr)
    assert found.strip() in verified.stdout + verified.stderr
    assert b"would do" in found
    saved = tmp_path / "fast.vrun"
    vrts("run", program, "--scene", "one-can-ur5", "--save", saved)
    again = vrts("run", saved)
    assert again.returncode == 1
    assert told(again.stderr) == [found]
