"""Runs and logs for the tests of validation."""

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import numpy.typing as npt

from tests.places import ROOT
from vrts.engine.run import Run
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.request import Request
from vrts.pipeline.scenes import load_scene
from vrts.report.formats.run_csv import run_csv
from vrts.run_files.simulated import simulate
from vrts.validate.log.log import RobotLog
from vrts.validate.sampling import sampled

Array = npt.NDArray[np.float64]

EXAMPLE = ROOT / "examples" / "05-validation"
TOOL_TURNS = """\
.PROGRAM turns
  SPEED 40 ALWAYS
  MOVE #a
  MOVE #b
  BREAK
  MOVE #c
  MOVE #d
  MOVE #a
.END
.LOCATIONS
#a 0 -60 60 0 30 0
#b 50 -80 40 60 60 90
#c -40 -40 70 -50 -60 -120
#d 20 -90 80 100 40 30
.END
"""


@cache
def path_run() -> Run:
    """Return the run of the closed path."""
    return run_of((EXAMPLE / "path.v2").read_bytes())


@cache
def turning_run() -> Run:
    """Return a run in which the tool turns about all axes."""
    return run_of(TOOL_TURNS.encode())


@cache
def speeds_run() -> Run:
    """Return the run of the program that tells speeds."""
    return run_of((EXAMPLE / "speeds.v2").read_bytes())


def run_of(program: bytes, lab: str | None = None, folder: Path | None = None) -> Run:
    """Return the run of a program, in a laboratory where one is given as text."""
    setting = robot_alone()
    if lab is not None:
        assert folder is not None
        (folder / "lab.toml").write_text(lab)
        setting = load_scene("one-can-puma761", lab=folder / "lab.toml")
    found = simulate(Request(ProgramFile(program, "program.v2"), setting, Reading("val2+"))).run
    assert found is not None
    return found


@cache
def own_csv() -> str:
    """Return the table of the closed path that `vrts run --csv` writes."""
    return "".join(run_csv(path_run(), 50.0))


def exact_log(
    run: Run,
    change: Callable[[Array], Array] = lambda points: points,
    *,
    shift_s: float = 0.0,
    joints: bool = True,
    tool_m: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> RobotLog:
    """Return the log of a robot that follows a run without error, and is displaced.

    Args:
        run: The run.
        change: What displaces the positions of the tool.
        shift_s: What the clock shows when the run begins.
        joints: Whether joints are logged, too.
        tool_m: The error of the tool in T.
    """
    times = np.arange(-0.5, run.horizon_s + 0.5, 0.02)
    samples = sampled(run, times)
    points = samples.positions + samples.rotations @ np.array(tool_m)
    own = samples.joints if joints else None
    return RobotLog("log.csv", "0" * 64, times + shift_s, own, change(points), False, ())
