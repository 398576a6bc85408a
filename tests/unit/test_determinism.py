"""Two processes with different hash seeds write the same bytes."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.places import ROOT

PROGRAM = ROOT / "examples" / "01-cans-on-bases" / "submissions" / "hits-base.v2"

# Events and segments of two runs, each executed twice, and the bytes of their files.
TOLD = """
import hashlib, json
from tests.support_saved import BUSY, TRAFFIC, SOLUTION, plain, with_scenario
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.request import Request
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.alone import robot_alone
from vrts.run_files.saving import saved_bytes
from vrts.run_files.simulated import simulate

def told(value):
    return getattr(value, "value", None) or repr(value)

alone = with_scenario(robot_alone(), TRAFFIC)
for _ in range(2):
    for text, setting in ((BUSY, alone), (SOLUTION, load_scene("cans-on-bases"))):
        found = simulate(Request(ProgramFile(text, "main.v2"), setting, Reading("val2+")))
        run = found.run
        events = [[type(event).__name__, plain(event)] for event in run.events]
        print(json.dumps([events, plain(run.timeline.segments)], default=told))
        print(hashlib.sha256(saved_bytes(found)).hexdigest())
"""


def run(words: "list[str | Path]", seed: str) -> bytes:
    result = subprocess.run(
        [sys.executable, *words],
        capture_output=True,
        cwd=ROOT,
        env={**os.environ, "PYTHONHASHSEED": seed},
        check=False,
    )
    assert not result.stderr, result.stderr.decode()
    return result.stdout


@pytest.mark.thorough
def test_results_do_not_depend_on_the_hash_seed(tmp_path: Path) -> None:
    outputs: list[bytes] = []
    pages: list[bytes] = []
    for seed in ("1", "2"):
        page = tmp_path / f"{seed}.html"
        result = subprocess.run(
            [
                *(sys.executable, "-m", "vrts.cli.main", "verify", PROGRAM),
                *("--format", "json", "--html", page),
            ],
            capture_output=True,
            cwd=ROOT,
            env={**os.environ, "PYTHONHASHSEED": seed},
            check=False,
        )
        outputs.append(result.stdout)
        pages.append(page.read_bytes())
    assert outputs[0] == outputs[1]
    assert pages[0] == pages[1]


LOOKING = """.PROGRAM main()
        MOVE safe
        REACT 1003, up
        FOR i = 1 TO 2
        IF SIG(1001) THEN
        IF SIG(1002) GOTO 20
        END
        END
        WAIT SIG(1004)
        IF RANDOM < 0.4 GOTO 20
        READY
        RETURN
20      MOVES SHIFT(safe BY 0, 0, -500)
.END
.PROGRAM up()
        DEPARTS 20
.END
.LOCATIONS
safe 900 30 100 90 90 0
.END
"""


@pytest.mark.thorough
def test_futures_do_not_depend_on_the_hash_seed(tmp_path: Path) -> None:
    program = tmp_path / "looking.v2"
    program.write_text(LOOKING, "utf-8")
    words = ["-m", "vrts.cli.main", "prove", program, "--scene", "cans-on-bases"]
    found = [run([*words, "--format", "json"], seed) for seed in ("1", "2", "3")]
    assert b"touches table" in found[0]
    assert found[0] == found[1] == found[2]


@pytest.fixture(scope="module")
def first() -> list[bytes]:
    """Return what the first process told, line by line."""
    return run(["-c", TOLD], "0").splitlines()


def test_a_repetition_gives_the_same_events_and_segments(first: list[bytes]) -> None:
    assert len(first) == 8
    assert first[:4] == first[4:]
    assert first[0] != first[2]
    for name in (b"Printed", b"Reacted", b"MotionStarted", b"SignalChanged", b"Found"):
        assert name in first[0]
    assert b"Grasped" in first[2]


@pytest.mark.thorough
@pytest.mark.parametrize("seed", ["1", "4711", "random"])
def test_events_and_segments_do_not_depend_on_the_hash_seed(first: list[bytes], seed: str) -> None:
    assert run(["-c", TOLD], seed).splitlines() == first
