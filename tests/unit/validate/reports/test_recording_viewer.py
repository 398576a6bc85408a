"""The Rerun viewer shows both robots, without a complaint and without a screen."""

import sys
from pathlib import Path

import pytest

from tests.unit.report.recording.test_recording_viewer import DRIVERS, loaded, viewer
from tests.unit.validate.support import EXAMPLE, path_run
from vrts.validate.comparison import read_and_compare
from vrts.validate.log.log import GivenLog
from vrts.validate.offsets import Wanted
from vrts.validate.reports.comparison_recording import write_both

VIEWS = {
    "Both robots": "3D",
    "Path error [mm]": "TimeSeries",
    "Joint error [deg]": "TimeSeries",
    "Summary": "TextDocument",
}

pytestmark = pytest.mark.skipif(
    sys.platform != "linux" or not any(DRIVERS.glob("lvp_icd.*.json")),
    reason="needs Debian's mesa-vulkan-drivers",
)


def test_every_view_shows_what_it_should(tmp_path: Path) -> None:
    data = (EXAMPLE / "robot.csv").read_bytes()
    found = read_and_compare(path_run(), GivenLog("robot.csv", (data,)), Wanted())
    write_both(found, "path.v2", tmp_path / "both.rrd")
    with viewer(tmp_path, tmp_path / "both.rrd") as client:
        loaded(client)
        client.set_time("t", duration=8.0)
        client.save_screenshot(str(tmp_path / "shown.png"))  # now all has been drawn once
        state = client.get_state()
        assert {view.name: view.view_class for view in state.views} == VIEWS
        assert [(view.name, view.reports) for view in state.views if view.reports] == []
    assert (tmp_path / "shown.png").stat().st_size > 50_000
