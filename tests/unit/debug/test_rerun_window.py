"""The Rerun viewer stands at the moment that the debugger looks at; here without a screen."""

import subprocess
import sys
from pathlib import Path

import psutil
import pytest
from rerun.experimental import ViewerClient

from tests.support_programs import cans, compiled
from tests.unit.debug.dap.test_dap import HITS
from vrts.cli.shared.rerun_window import RerunWindow
from vrts.cli.shared.run_page import assessed
from vrts.engine.controller import execute
from vrts.report.recording import write_recording
from vrts.report.recording.viewer import stand_at, viewer_program

DRIVERS = list(Path("/usr/share/vulkan/icd.d").glob("lvp_icd.*.json"))

pytestmark = pytest.mark.skipif(
    sys.platform != "linux" or not DRIVERS, reason="needs Debian's mesa-vulkan-drivers"
)


def test_it_stands_where_it_is_told_and_ends(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("HOME", "XDG_CONFIG_HOME", "XDG_RUNTIME_DIR"):
        monkeypatch.setenv(name, str(tmp_path))
    monkeypatch.setenv("VK_DRIVER_FILES", ":".join(map(str, DRIVERS)))
    subprocess.run([viewer_program(), "analytics", "disable"], check=True, capture_output=True)
    recording = tmp_path / "run.rrd"
    write_recording(assessed("run", "run", execute(compiled(HITS.read_text()), cans())), recording)
    window = RerunWindow(["--headless"])
    try:
        assert window.show(recording, 4.87)
        port = window.port
        client = ViewerClient.connect(f"rerun+http://127.0.0.1:{port}/proxy")
        shown = client.get_state().recordings[0]
        assert (shown.current_timeline, shown.current_time) == ("t", 4_870_000_000)
        assert window.stand_at(1.25)
        assert client.get_state().recordings[0].current_time == 1_250_000_000
        mine = psutil.Process().children(recursive=True)
        assert any("rerun" in process.name() for process in mine)
    finally:
        window.close()
    assert not window.is_open
    assert not any("rerun" in process.name() for process in psutil.Process().children())
    assert not stand_at(port, 1.0)


def test_a_viewer_that_cannot_open_says_so(tmp_path: Path) -> None:
    window = RerunWindow(["--no-such-option"])
    assert not window.show(tmp_path / "none.rrd", 1.0)
    assert not window.is_open
