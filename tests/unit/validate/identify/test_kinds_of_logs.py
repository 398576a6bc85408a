"""Whatever wrote the log, and whatever its clock shows: the same joint is named."""

import json
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
import scipy.io
from mcap_ros2.writer import Writer

from tests.support_commands import vrts_text
from tests.unit.validate.identify.test_identify import WITHOUT
from tests.unit.validate.log.test_bags import DEFINITION, KIND, NAMES
from tests.unit.validate.support import TOOL_TURNS, turning_run
from vrts.base.units import DEG
from vrts.validate.identify.causes import Cause, Kind
from vrts.validate.identify.identify import identify
from vrts.validate.log.log import GivenLog
from vrts.validate.synthetic import logged

ROBOT = WITHOUT._replace(zero_deg=(0.0, 0.0, 0.5, 0.0, 0.0, 0.0))
LATER_S = 1_790_000_000.0  # some day of 2026
TIMES, JOINTS, _ = logged(turning_run(), ROBOT)


def rows(names: list[str], unit: float, shift_s: float) -> bytes:
    table = np.column_stack((TIMES + shift_s, JOINTS / unit))
    lines = [",".join(f"{value:.6f}" for value in row) for row in table.tolist()]
    return "\n".join([",".join(names), *lines]).encode()


def of_rtde() -> bytes:
    return rows(["timestamp", *(f"actual_q_{k}" for k in range(6))], 1.0, 12345.678)


def of_plotjuggler() -> bytes:
    joints = [f"/joint_states/joint_{k}/position" for k in range(1, 7)]
    return rows(["__time", *joints], 1.0, LATER_S)


def of_matlab() -> bytes:
    stream = BytesIO()
    scipy.io.savemat(stream, {"t": TIMES - 7.5, "jt": JOINTS / DEG})
    return stream.getvalue()


def of_bag() -> bytes:
    stream = BytesIO()
    writer = Writer(stream)
    schema = writer.register_msgdef(KIND, DEFINITION)
    for time_s, row in zip((TIMES + 10.0).tolist(), JOINTS.tolist(), strict=True):
        time_ns = round(1e9 * LATER_S) + round(1e9 * time_s)
        stamp = {"sec": time_ns // 10**9, "nanosec": time_ns % 10**9}
        message = {"header": {"stamp": stamp, "frame_id": ""}, "name": NAMES, "position": row}
        message |= {"velocity": [], "effort": []}
        writer.write_message("/joint_states", schema, message, log_time=time_ns)
    writer.finish()
    return stream.getvalue()


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("rtde.csv", of_rtde()),
        ("plotjuggler.csv", of_plotjuggler()),
        ("log.mat", of_matlab()),
        ("log.mcap", of_bag()),
    ],
    ids=["RTDE", "PlotJuggler", "MATLAB", "MCAP"],
)
def test_the_same_joint_is_named(name: str, data: bytes) -> None:
    found = identify(turning_run(), GivenLog(name, (data,)))
    (number,) = found.numbers
    assert number.cause == Cause(Kind.ZERO, 2)
    assert number.value == pytest.approx(0.5 * DEG, abs=2.0 * number.half)
    assert found.fits


def test_several_runs_at_once_with_columns_of_another_name(tmp_path: Path) -> None:
    program, columns = tmp_path / "turns.v2", tmp_path / "columns.toml"
    program.write_text(TOOL_TURNS)
    columns.write_text('time = "when [s]"\njoints = ["a", "b", "c", "d", "e", "f"]\n')
    logs: list[Path | str] = []
    for number, shift_s in enumerate((0.0, 400.0)):
        path = tmp_path / f"run{number}.csv"
        path.write_bytes(rows(["when", "a", "b", "c", "d", "e", "f"], DEG, shift_s))
        logs += ["--log", path]
    said = vrts_text("validate", program, *logs, "--columns", columns, "--identify", "--json")
    assert said.returncode == 0, said.stderr
    first, second = json.loads(said.stdout)["identified"]
    assert first["causes"][0]["name"] == second["causes"][0]["name"] == "joint 3"
    assert second["clock"]["add_s"] - first["clock"]["add_s"] == pytest.approx(-400.0, abs=0.01)
