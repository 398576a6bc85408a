"""Text, JSON, page and recording say the same, and foreign names mean nothing in them."""

import json
import re
import subprocess
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import rerun_cli

from tests.unit.validate.support import EXAMPLE, path_run, run_of
from vrts.report.figures.figures import path_figure, series_figure
from vrts.report.formats.json_text import json_text
from vrts.validate.comparison import Comparison, read_and_compare
from vrts.validate.errors import measures
from vrts.validate.log.log import GivenLog
from vrts.validate.offsets import Wanted
from vrts.validate.reports.comparison_json import comparison_json
from vrts.validate.reports.comparison_page import comparison_page
from vrts.validate.reports.comparison_recording import write_both
from vrts.validate.reports.comparison_text import comparison_text

HOSTILE = "<script>alert(1)</script>\x1b[31m::error::.csv"


@cache
def found(name: str = "robot.csv") -> Comparison:
    data = (EXAMPLE / "robot.csv").read_bytes()
    return read_and_compare(path_run(), GivenLog(name, (data,)), Wanted(time=True, base=True))


def test_the_table_of_the_paper_is_reproduced() -> None:
    data = (EXAMPLE / "robot.csv").read_bytes()
    plain = read_and_compare(path_run(), GivenLog("robot.csv", (data,)), Wanted())
    x, y, _ = (measures(1e3 * plain.after.path[:, k]) for k in range(3))
    assert round(x.mean_square, 2) == 0.61
    assert round(y.mean_square, 2) == 0.94
    assert measures(np.linalg.norm(1e3 * plain.after.path, axis=1)).largest < 2.5
    assert plain.after.joints is not None
    rms = np.degrees(np.sqrt((plain.after.joints**2).mean(axis=0)))
    assert ((rms > 0.005) & (rms < 0.02)).all()


def test_text_says_that_the_log_is_synthetic_and_what_came_out() -> None:
    text = comparison_text(found())
    assert "synthetic: this log was made by a computer" in text
    assert re.search(r"^  X +24\.935 +0\.041 +4\.993 +0\.203 +22\.189 +1\.493$", text, re.M)
    assert re.search(r"^  base   X Y Z \+0\.739 \+0\.636 \+0\.053 mm", text, re.M)
    assert text.count("line ") == len(path_run().motions)


def test_json_has_the_numbers_of_the_text() -> None:
    said = json.loads(json_text(comparison_json(found())))
    assert said["log"]["synthetic"] is True
    assert said["after"]["path"]["x"]["mean_square_mm2"] == pytest.approx(0.041, abs=0.001)
    assert said["after"]["joints"]["jt3"]["rms_deg"] == pytest.approx(0.0141, abs=0.0001)
    assert said["after"]["offsets"]["base_mm"] == [0.739, 0.636, 0.053]
    assert [m["line"] for m in said["motions"]] == [4, 7, 8, 9, 10, 11, 12]


def test_the_page_is_whole_and_calls_nobody() -> None:
    text = comparison_page(found(), "path.v2")
    assert "Synthetic: this log was made by a computer" in text
    assert text.count("<svg") == 8
    assert not re.search(r"(?:src|href)=\"(?:https?:)?//", text)
    assert "<script" not in text
    assert "default-src &#x27;none&#x27;" in text
    assert found().log.sha256 in text


def test_foreign_names_mean_nothing_but_themselves() -> None:
    hostile = found(HOSTILE)
    page = comparison_page(hostile, HOSTILE)
    assert "<script>alert" not in page
    assert "&lt;script&gt;alert" in page
    for text in (page, comparison_text(hostile), json_text(comparison_json(hostile))):
        assert "\x1b" not in text


@pytest.mark.parametrize("joints", [True, False])
def test_the_recording_holds_both_robots(tmp_path: Path, *, joints: bool) -> None:
    c = found()
    if not joints:
        lines = (EXAMPLE / "robot.csv").read_text().splitlines()[2:]
        kept = [",".join([row.split(",")[0], *row.split(",")[7:]]) for row in lines]
        c = read_and_compare(
            path_run(), GivenLog("robot.csv", ("\n".join(kept).encode(),)), Wanted()
        )
    path = tmp_path / "both.rrd"
    write_both(c, "path.v2", path)
    viewer = Path(rerun_cli.__file__).parent / "rerun"
    checked = subprocess.run(
        [viewer, "rrd", "verify", path], capture_output=True, text=True, check=False
    )
    assert checked.returncode == 0, checked.stderr
    shown = subprocess.run(
        [viewer, "rrd", "print", path], capture_output=True, text=True, check=True
    ).stdout
    assert "/world/virtual/forearm" in shown
    assert ("/world/real/forearm" in shown) is joints
    assert "/world/real_path" in shown
    assert "/path_error" in shown
    again = tmp_path / "again.rrd"
    write_both(c, "path.v2", again)
    assert again.read_bytes()[:4] == b"RRF2"


def test_another_robot_is_told_by_its_log() -> None:
    """A PUMA 762 that goes where a 761 went has other joints."""
    lines = (EXAMPLE / "path.v2").read_text()
    other = run_of(lines.replace("-250.00", "350.00").encode())
    data = (EXAMPLE / "robot.csv").read_bytes()
    codes = [
        d.rule.code
        for d in read_and_compare(other, GivenLog("robot.csv", (data,)), Wanted()).findings
    ]
    assert "V891" in codes


def test_figures_keep_extremes_of_long_logs() -> None:
    times = np.linspace(0.0, 60.0, 6000)
    values = np.zeros(6000)
    values[4321] = 7.0
    text = str(series_figure(times, [("X", values)], "mm"))
    assert len(text) < 30_000
    assert text.count("<polyline") == 1
    points = re.search(r'points="([^"]*)"', text)
    assert points is not None
    heights = [float(pair.split(",")[1]) for pair in points[1].split()]
    assert min(heights) < 60.0 < max(heights)


def test_what_is_never_negative_begins_at_nothing_and_is_not_joined_across_a_mark() -> None:
    times = np.concatenate((np.linspace(0.0, 1.0, 50), np.linspace(3.0, 4.0, 50)))
    far = np.concatenate((np.full(50, 2.0), np.full(50, 1.0)))
    text = str(series_figure(times, [("far", far)], "mm", marks=[(0.0, "1"), (3.0, "2")]))
    assert text.count("<polyline") == 2
    assert ">-" not in text
    signed = str(series_figure(times, [("far", -far)], "mm"))
    assert signed.count("<polyline") == 1
    assert ">-2<" in signed


def test_errors_of_a_path_are_drawn_enlarged() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 200)
    circle = np.column_stack((300.0 * np.cos(angle), 300.0 * np.sin(angle), 0.0 * angle))
    text = str(path_figure(circle, circle * 1.003))
    assert "real, errors 50 times as large" in text
