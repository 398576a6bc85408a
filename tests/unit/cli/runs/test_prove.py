"""`vrts prove`: every future, told, written as a scenario, and ended early."""

import json
import os
import re
import shlex
import signal
import subprocess
import sys
from importlib.resources import files
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.unit.cli.test_commands import SOLUTION, vrts

COLOR = ("--color", "never")
COUNTS_FOR_EVER = """\
.PROGRAM count()
  n = 0
  WHILE NOT SIG(1001) DO
    IF SIG(1002) THEN
      n = n+1
    END
    IF SIG(1003) THEN
      n = n*3
    END
    WAIT TIMER(1) > n/100
    DELAY 0.1+n/1000
  END
.END
"""


@pytest.fixture
def share(tmp_path: Path) -> Path:
    """A program that two inputs together make divide by zero: that of the page of V560."""
    page = files("vrts").joinpath("pages", "V560.md").read_text("utf-8")
    program = re.search(r"```val2\n(.*?)```", page, re.DOTALL)
    assert program is not None
    path = tmp_path / "share.v2"
    path.write_text(program[1])
    return path


def test_what_holds_ends_with_status_0() -> None:
    result = vrts("prove", SOLUTION)
    assert result.returncode == 0
    text = result.stdout.decode()
    assert text.startswith("solution.v2: holds\nNothing goes wrong, in any future\n")
    assert "taken for granted:" in text


def test_what_goes_wrong_is_told_with_what_came_from_outside(share: Path) -> None:
    result = vrts("prove", share, *COLOR)
    assert result.returncode == 1
    text = result.stdout.decode()
    assert "error[V560 in-some-future]: for some inputs: division by zero" in text
    assert "line 3: input 1001 is on" in text
    assert "line 6: input 1002 is on" in text


def test_the_counterexample_repeats_what_went_wrong(share: Path, tmp_path: Path) -> None:
    bad = tmp_path / "bad.toml"
    result = vrts("prove", share, "--counterexample", bad)
    assert f"wrote {bad}".encode() in result.stderr
    again = vrts("run", share, "--scenario", bad)
    assert f"see it with `vrts run {share} --scenario {bad}`".encode() in result.stderr
    assert again.returncode == 1
    assert b"division by zero" in again.stdout + again.stderr
    assert vrts("run", share).returncode == 0


def test_what_to_type_to_see_it_names_the_setting_too(share: Path, tmp_path: Path) -> None:
    bad = tmp_path / "bad one.toml"
    where = ("--scene", "cans-on-bases", "--controller", "val2", "--dialect", "val2")
    result = vrts("prove", share, *where, "--no-collisions", "--counterexample", bad)
    _, typed, _ = result.stderr.decode().split("`")
    command, *words = shlex.split(typed)
    assert command == "vrts"
    assert words[1:] == [str(share), *where, "--scenario", str(bad)]
    again = vrts(*words)
    assert b"division by zero" in again.stdout + again.stderr


def test_an_environment_says_what_cannot_come(share: Path, tmp_path: Path) -> None:
    environment = tmp_path / "environment.toml"
    environment.write_text('[[inputs]]\nsignal = 1002\nis = "held"\nstate = "off"\n')
    assert vrts("prove", share, "--environment", environment).returncode == 0


def test_a_faulty_environment_is_told(share: Path, tmp_path: Path) -> None:
    environment = tmp_path / "environment.toml"
    environment.write_text("[[inputs]]\nsignal = 1002\nis = 'hold'\n")
    result = vrts("prove", share, "--environment", environment, *COLOR)
    assert result.returncode == 1
    assert b"environment.toml:3:6" in result.stderr


def test_json_has_everything(share: Path) -> None:
    found = json.loads(vrts("prove", share, "--format", "json").stdout)
    assert found["schema"] == "vrts.futures/1"
    assert found["answer"] == "violated"
    assert [one["number"] for one in found["found"][0]["decisions"]] == [1001, 1002]
    assert "signal = 1002" in found["found"][0]["scenario"]


def test_a_spent_budget_is_undetermined(tmp_path: Path) -> None:
    program = tmp_path / "count.v2"
    program.write_text(COUNTS_FOR_EVER)
    result = vrts("prove", program, "--states", "50")
    assert result.returncode == 3
    assert b"not looked at:" in result.stdout


def test_what_does_not_compile_is_not_looked_at(tmp_path: Path) -> None:
    program = tmp_path / "broken.v2"
    program.write_text(".PROGRAM a()\n  MOVE\n.END\n")
    result = vrts("prove", program)
    assert result.returncode == 1
    assert result.stdout == b""


LONG_REPLAYS = """\
.PROGRAM slow()
  n = 0
  FOR i = 1 TO 150000
    n = n+1
  END
  IF SIG(1001,1002,1003,1004,1005,1006,1007,1008) THEN
    n = 1/0
  END
  IF SIG(1009,1010,1011,1012,1013,1014,1015,1016) THEN
    n = SQRT(-1)
  END
  IF SIG(1017,1018,1019,1020,1021,1022,1023,1024) THEN
    n = 1/(n-n)
  END
.END
"""


@pytest.mark.thorough
@pytest.mark.parametrize("jobs", ["1", "2"])
def test_ctrl_c_ends_replays_and_their_workers(jobs: str, tmp_path: Path) -> None:
    program = tmp_path / "slow.v2"
    program.write_text(LONG_REPLAYS)
    command = [sys.executable, "-m", "vrts.cli.main", "prove", str(program), "--jobs", jobs]
    master, slave = os.openpty()
    with subprocess.Popen(
        [*command, *COLOR], cwd=ROOT, stdout=subprocess.PIPE, stderr=slave, env=dict(os.environ)
    ) as process:
        os.close(slave)
        shown = b""
        while b"they are replayed" not in shown:
            shown += os.read(master, 1024)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate()
    os.close(master)
    left = re.search(rb"of what seems to go wrong ([123]) was not replayed to its end", out)
    assert left is not None
    assert process.returncode == (3 if left[1] == b"3" else 1)


@pytest.mark.thorough
def test_ctrl_c_tells_what_is_known_so_far(tmp_path: Path) -> None:
    program = tmp_path / "count.v2"
    program.write_text(COUNTS_FOR_EVER)
    command = [sys.executable, "-m", "vrts.cli.main", "prove", str(program), *COLOR]
    master, slave = os.openpty()
    with subprocess.Popen(
        command, cwd=ROOT, stdout=subprocess.PIPE, stderr=slave, env=dict(os.environ)
    ) as process:
        os.close(slave)
        shown = b""
        while b" states, " not in shown:  # the search is under way
            shown += os.read(master, 1024)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate()
    os.close(master)
    assert process.returncode == 3
    assert b"not looked at:" in out
