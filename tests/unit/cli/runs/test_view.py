"""`vrts view` shows programs, saved runs and recordings, and says what it cannot show."""

import os
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a program, its run, and a recording of it."""
    found = tmp_path_factory.mktemp("view")
    (found / "hits.v2").write_bytes((EXAMPLE / "submissions" / "hits-base.v2").read_bytes())
    vrts(found, "run", "hits.v2", "--scene", "cans-on-bases", "--save", "out.vrun")
    vrts(found, "view", "out.vrun", "--no-open", "--with", "rerun")
    return found


def vrts(folder: Path, *words: str) -> tuple[int, str]:
    """Run vrts in a folder, without a screen; return its status and what it writes."""
    env = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    env |= {"HOME": str(folder), "XDG_CONFIG_HOME": str(folder), "PYTHONPATH": str(ROOT)}
    done = vrts_text(*words, cwd=folder, env=env)
    return done.returncode, done.stdout + done.stderr


@pytest.mark.thorough
def test_a_saved_run_becomes_a_page(folder: Path) -> None:
    assert vrts(folder, "view", "out.vrun", "--no-open") == (0, "wrote out.html\n")
    page = (folder / "out.html").read_text()
    assert "touches base1" in page
    assert "APPROS base2_put" in page
    assert str(folder) not in page


def test_a_saved_run_becomes_a_recording(folder: Path) -> None:
    assert (folder / "out.rrd").read_bytes()[:3] == b"RRF"


def test_a_saved_run_becomes_a_picture(folder: Path) -> None:
    words = ("view", "out.vrun", "--still", "4", "-o", "moment.png")
    assert vrts(folder, *words) == (0, "wrote moment.png\n")
    assert (folder / "moment.png").read_bytes()[:4] == b"\x89PNG"
    assert vrts(folder, "view", "out.vrun", "--still", "400") == (
        2,
        "error: the run ends at 12.264 s\n",
    )


def test_a_recording_goes_to_the_viewer_which_needs_a_display(folder: Path) -> None:
    assert vrts(folder, "view", "out.rrd", "--no-open") == (0, "")
    status, said = vrts(folder, "view", "out.rrd")
    assert status == 1
    assert said.startswith("error: the Rerun viewer could not show it; it needs a display\n")
    assert str(folder) not in said


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("gone.rrd",), "cannot read `gone.rrd`: no such file or directory"),
        (("gone.vrun",), "cannot read `gone.vrun`"),
        (("fake.rrd",), "`fake.rrd` is no Rerun recording"),
        (("out.vrun", "--scene", "cans-on-bases"), "the scene of `out.vrun` is in it"),
        (("out.rrd", "--still", "1"), "`out.rrd` is a recording already"),
    ],
)
def test_what_cannot_be_shown_is_said(folder: Path, words: tuple[str, ...], said: str) -> None:
    (folder / "fake.rrd").write_text("text")
    status, text = vrts(folder, "view", *words)
    assert status == 2
    assert text.startswith(f"error: {said}")
