"""The Rerun viewer shows every view of a recording, without a complaint and without a screen.

It draws by software (Mesa's lavapipe), so this needs neither a graphics card nor a display.
"""

import os
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeVar

import pytest
import rerun as rr
import rerun_cli
from rerun.experimental import ViewerClient

from tests.places import ROOT
from vrts.pipeline.assess import assess
from vrts.pipeline.request import Checks
from vrts.pipeline.requesting import request_for
from vrts.pipeline.where import Where
from vrts.report.recording import write_recording
from vrts.report.recording.blueprint import blueprint
from vrts.report.recording.names import of_body

HITS = ROOT / "examples" / "01-cans-on-bases" / "submissions" / "hits-base.v2"
VIEWER = Path(rerun_cli.__file__).parent / "rerun"  # not the wrapper: it is what we must end
DRIVERS = Path("/usr/share/vulkan/icd.d")
PATIENCE_S = 60.0
VIEWS = {
    "Scene": "3D",
    "Lines, gripper and signals": "StateTimeline",
    "Program": "TextLog",
    "Joints [% of half the range]": "TimeSeries",
    "Joints [deg]": "TimeSeries",
    "Joint speed [% of limit]": "TimeSeries",
    "Clearance [mm]": "TimeSeries",
    "Hand opening [mm]": "TimeSeries",
    "Summary": "TextDocument",
}
Found = TypeVar("Found")

pytestmark = pytest.mark.skipif(
    sys.platform != "linux" or not any(DRIVERS.glob("lvp_icd.*.json")),
    reason="needs Debian's mesa-vulkan-drivers",
)


def test_every_view_shows_what_it_should(tmp_path: Path) -> None:
    a = assess(
        request_for(HITS, Where(task=HITS.parent.parent / "task.toml"), checks=Checks(curve=True))
    )
    assert a.judgement is not None
    assert a.judgement.collisions is not None
    moment = a.judgement.collisions.contacts[0].deepest_s
    write_recording(a, tmp_path / "run.rrd")
    with viewer(tmp_path, tmp_path / "run.rrd") as client:
        loaded(client)
        client.set_time("t", duration=moment)
        client.save_screenshot(str(tmp_path / "shown.png"))  # now all has been drawn once
        state = client.get_state()
        assert {view.name: view.view_class for view in state.views} == VIEWS
        assert [(view.name, view.reports) for view in state.views if view.reports] == []
        assert all(view.visible for view in state.views)
    assert (tmp_path / "shown.png").stat().st_size > 50_000


def test_a_view_that_cannot_show_something_reports_it(tmp_path: Path) -> None:
    stream = rr.RecordingStream("vrts", recording_id="lost", send_properties=False)
    with stream:
        stream.save(tmp_path / "lost.rrd", default_blueprint=blueprint(80.0))
        rr.log(of_body("table"), rr.Boxes3D(half_sizes=[[1, 1, 1]]), static=True)
        rr.log(of_body("can1"), rr.Boxes3D(half_sizes=[[1, 1, 1]]), static=True)
        rr.log(of_body("can1"), rr.CoordinateFrame("no such frame"), static=True)
    stream.flush()
    stream.disconnect()
    with viewer(tmp_path, tmp_path / "lost.rrd") as client:
        loaded(client)
        client.save_screenshot(str(tmp_path / "shown.png"))
        assert any(view.reports for view in client.get_state().views)


@contextmanager
def viewer(home: Path, recording: Path) -> Generator[ViewerClient]:
    """Run a viewer of its own, that reports nothing to anybody, and end it."""
    env = {
        **os.environ,
        "HOME": str(home),
        "XDG_CONFIG_HOME": str(home),
        "XDG_RUNTIME_DIR": str(home),
        "VK_DRIVER_FILES": ":".join(str(path) for path in DRIVERS.glob("lvp_icd.*.json")),
    }
    subprocess.run([VIEWER, "analytics", "disable"], env=env, check=True, capture_output=True)
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    process = subprocess.Popen(
        [VIEWER, "--headless", "--bind", "127.0.0.1", "--port", str(port), recording],
        env=env,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        yield waited(lambda: connected(port))
    finally:
        process.kill()
        process.wait()


def connected(port: int) -> ViewerClient | None:
    try:
        client = ViewerClient.connect(f"rerun+http://127.0.0.1:{port}/proxy")
        client.get_state()
    except (RuntimeError, ConnectionError):
        return None
    return client


def loaded(client: ViewerClient) -> None:
    """Wait until the recording is there and has views."""

    def ready() -> bool | None:
        state = client.get_state()
        return True if state.views and not state.loading else None

    waited(ready)


def waited(attempt: Callable[[], Found | None]) -> Found:
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end:
        found = attempt()
        if found is not None:
            return found
        time.sleep(0.05)
    raise AssertionError("the viewer does not answer")
