"""The table of a run says at every instant what the run says."""

import csv
import io
from collections.abc import Callable
from itertools import pairwise

import pytest

from tests.support_saved import busy, carrying
from vrts.base.oat import components
from vrts.base.units import deg, mm
from vrts.engine.run import Run
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.report.formats.run_csv import run_csv
from vrts.run_files.simulated import Simulated, simulate

HALF = {3: 0.000501, 2: 0.00501}  # of the last decimal


def rows_of(run: Run, rate_hz: float) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO("".join(run_csv(run, rate_hz)))))


@pytest.mark.parametrize("which", [busy, carrying])
def test_rows_are_what_the_run_answers(which: Callable[[], Simulated]) -> None:
    run = which().run
    assert run is not None
    rows = rows_of(run, 20.0)
    assert len(rows) == int(run.horizon_s * 20.0 + 1e-9) + 1
    for number, row in enumerate(rows):
        time_s = number / 20.0
        state = run.at(time_s)
        x, y, z, o, a, t = components(state.X_WT)
        expected = {
            "time_s": (time_s, 3),
            **{f"jt{k + 1}_deg": (deg(q), 3) for k, q in enumerate(state.configuration)},
            **{f"v{k + 1}_deg_s": (deg(rate), 2) for k, rate in enumerate(state.velocity)},
            "x_mm": (x, 2),
            "y_mm": (y, 2),
            "z_mm": (z, 2),
            "o_deg": (o, 3),
            "a_deg": (a, 3),
            "t_deg": (t, 3),
            "hand_mm": (mm(state.hand_opening), 2),
        }
        for name, (value, decimals) in expected.items():
            assert len(row[name].split(".")[1]) == decimals, name
            off = float(row[name]) - value
            if name in ("o_deg", "t_deg"):  # 180 and -180 are one angle
                off = (off + 180.0) % 360.0 - 180.0
            assert abs(off) <= HALF[decimals], (name, time_s)
        assert row["held"] == (state.held or "")
        cause = state.cause
        assert (row["program"], row["step"]) == (
            (cause.program, str(cause.step)) if cause else ("", "")
        )
        for name in row:
            if name.startswith("signal_"):
                assert row[name] == str(int(int(name[7:]) in state.signals)), (name, time_s)


def test_only_signals_that_change_have_columns() -> None:
    run = busy().run
    assert run is not None
    names = [name for name in rows_of(run, 1.0)[0] if name.startswith("signal_")]
    assert {"signal_3", "signal_1001", "signal_2001"} <= set(names)
    assert names == sorted(names, key=lambda name: int(name[7:]))
    assert "signal_1" not in names


def test_no_number_depends_on_more_than_the_run() -> None:
    run = carrying().run
    assert run is not None
    text = "".join(run_csv(run, 50.0))
    assert "-0.000" not in text
    assert "-180.000" not in text
    assert "e-" not in text
    assert text.count("\n") == len(text.splitlines())
    assert "".join(run_csv(run, 50.0)) == text


def test_many_rows_come_in_pieces_of_the_same_table() -> None:
    run = carrying().run
    assert run is not None
    pieces = list(run_csv(run, 1000.0))
    assert len(pieces) > 3
    times = [float(row["time_s"]) for row in rows_of(run, 1000.0)]
    assert all(abs(b - a - 0.001) < 1e-9 for a, b in pairwise(times))


def test_a_vertical_tool_has_t_zero() -> None:
    """At READY only O + T is defined; VAL writes T as 0."""
    found = simulate(Request(ProgramFile(b".PROGRAM a\nDELAY 1\n.END\n", "a.v2"), robot_alone()))
    assert found.run is not None
    assert {row["t_deg"] for row in rows_of(found.run, 10.0)} == {"0.000"}
    assert {row["a_deg"] for row in rows_of(found.run, 10.0)} == {"-90.000"}


def test_a_tool_counts_from_when_it_is_set() -> None:
    text = b".PROGRAM a\nDELAY 1\nTOOL TRANS(0, 0, 100, 90, -90, 0)\nDELAY 1\n.END\n"
    found = simulate(Request(ProgramFile(text, "a.v2"), robot_alone()))
    assert found.run is not None
    heights = [float(row["z_mm"]) for row in rows_of(found.run, 10.0)]
    assert heights[-1] - heights[0] == pytest.approx(100.0)
    assert heights == sorted(heights)
