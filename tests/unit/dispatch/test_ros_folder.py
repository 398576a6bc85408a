"""A verified program as goals of a controller under ROS 2."""

from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
import yaml
from scipy.interpolate import CubicHermiteSpline

from tests.places import ROOT
from vrts.dispatch.ros_folder import _cell, exported_messages  # pyright: ignore[reportPrivateUsage]
from vrts.pipeline.assess import assess
from vrts.pipeline.requesting import request_for
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import Where
from vrts.report.ros.trajectories import TOLERANCE, ways

CANS = ROOT / "examples" / "01-cans-on-bases"


@pytest.fixture(scope="module")
def files() -> dict[str, bytes]:
    found = exported_messages(request_for(CANS / "solution.v2")).files
    assert found is not None
    return found


@pytest.mark.thorough
def test_goals_are_the_ways_of_the_run_one_after_the_other(files: dict[str, bytes]) -> None:
    run = assess(request_for(CANS / "solution.v2")).run
    assert run is not None
    goals = sorted(name for name in files if name.startswith("goals/"))
    for name, way in zip(goals, ways(run), strict=True):
        goal = cast(dict[str, Any], yaml.safe_load(files[name]))["trajectory"]
        assert goal["joint_names"] == [f"joint_{k}" for k in range(1, 7)]
        times = [
            point["time_from_start"]["sec"] + point["time_from_start"]["nanosec"] / 1e9
            for point in goal["points"]
        ]
        spline = CubicHermiteSpline(
            times,
            [point["positions"] for point in goal["points"]],
            [point["velocities"] for point in goal["points"]],
        )
        asked = np.linspace(0.0, float(times[-1]), 50)
        joints = [run.at(way.start_s + time_s).configuration for time_s in asked.tolist()]
        assert np.abs(spline(asked) - np.array(joints)).max() < 2.0 * TOLERANCE


def test_the_sheet_says_what_to_do_between_goals(files: dict[str, bytes]) -> None:
    rows = files["sheet.md"].decode().splitlines()
    told = [row for row in rows if row.startswith("| ") and ("goal" in row or "hand" in row)]
    words = [row.split(" | ")[2].split(",")[0].removesuffix(" |") for row in told]
    assert words[:5] == [
        "line 4: hand: open",
        "**goal 01**",
        "line 16: hand: close",
        "**goal 02**",
        "line 21: hand: open",
    ]


def test_the_folder_holds_a_bag(files: dict[str, bytes]) -> None:
    assert files["bag/bag.mcap"].startswith(b"\x89MCAP0")
    assert b"storage_identifier: mcap" in files["bag/metadata.yaml"]


def test_what_is_not_verified_is_not_written() -> None:
    program = CANS / "submissions" / "hits-base.v2"
    setting = setting_for(program, Where(task=Path(CANS)))
    found = exported_messages(request_for(program, setting=setting))
    assert found.files is None
    assert found.diagnostics[-1].rule.code == "V862"


def test_what_a_program_says_stays_one_cell() -> None:
    assert _cell("a | b \\ c\n| d") == "a \\| b \\\\ c \\| d"
