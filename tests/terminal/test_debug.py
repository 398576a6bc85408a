"""`vrts debug` in a real terminal."""

import re
import shutil
from pathlib import Path

import pytest

from tests.support_programs import ROOT
from tests.support_tmux import Terminal

pytestmark = pytest.mark.skipif(shutil.which("tmux") is None, reason="needs tmux")
HITS = ROOT / "examples/01-cans-on-bases/submissions/hits-base.v2"
SIZE = (120, 36)


def time_of(screen: str) -> float:
    found = re.search(r"(\d+\.\d{3}) s of", screen)
    assert found is not None, screen
    return float(found[1])


def test_a_contact_is_found_and_undone(tmp_path: Path) -> None:
    with Terminal(["debug", str(HITS)], tmp_path, SIZE) as terminal:
        first = terminal.expect("▶ SPEED 60 ALWAYS", "0.000 s of")
        bar = next(line for line in first.splitlines() if " s of " in line)
        assert "!" in bar, "the time bar shows where something touches"
        terminal.send("n")
        terminal.expect("▶ OPENI")
        terminal.send("N")
        terminal.expect("▶ SPEED 60 ALWAYS")
        terminal.send("c")
        there = terminal.expect("ALARM: can1 touches base1", "holds can1")
        terminal.send("T")
        back = terminal.expect("line 12  step")
        assert time_of(back) < time_of(there)
        terminal.send("c")
        terminal.expect("ALARM")
        terminal.send("C")
        terminal.expect("at the beginning", "0.000 s of")


@pytest.mark.thorough
def test_breakpoints_values_and_commands(tmp_path: Path) -> None:
    with Terminal(["debug", str(HITS)], tmp_path, SIZE) as terminal:
        terminal.expect("▶ SPEED 60 ALWAYS")
        terminal.send("Down", "Down", "Down", "Down", "b")
        terminal.expect("●   7   APPRO can1_grip, 100")
        terminal.send("c")
        terminal.expect("▶ APPRO can1_grip, 100", "breakpoint")
        terminal.send(":")
        terminal.send("-l", "offset = DX(can1_grip)+1")
        terminal.send("Enter")
        terminal.expect("offset", "801")
        terminal.send(":")
        terminal.send("-l", "WHERE")
        terminal.send("Enter")
        terminal.expect("JT1")
        terminal.send("?")
        terminal.expect("Forward", "Backward")
        terminal.send("?")
        terminal.send("q")
        assert "left at" in terminal.said()


@pytest.mark.thorough
def test_what_changes_on_disk_is_told_and_taken_on_restart(tmp_path: Path) -> None:
    program = tmp_path / "count.v2"
    text = ".PROGRAM main()\n n = 1\n n = n+1\n TYPE n\n.END\n"
    program.write_text(text)
    with Terminal(["debug", str(program)], tmp_path, SIZE) as terminal:
        terminal.expect("▶  n = 1")
        program.write_text(text.replace("n+1", "n+"))
        terminal.expect("`count.v2` has changed on disk: type `reload`")  # no key was pressed
        terminal.send("n")
        terminal.expect("▶  n = n+1")
        terminal.send("r")
        terminal.expect("still as it was: line 3:", "▶  n = n+1")
        program.write_text(text.replace("n+1", "n+41"))
        terminal.send("r")
        terminal.expect("begun again", "▶  n = 1")
        terminal.send("c")
        terminal.expect("at the end", "n            42")


@pytest.mark.thorough
def test_the_rerun_viewer_is_asked_for(tmp_path: Path) -> None:
    no_display = {"DISPLAY": "", "WAYLAND_DISPLAY": "", "XDG_RUNTIME_DIR": str(tmp_path)}
    with Terminal(["debug", str(HITS)], tmp_path, SIZE, no_display) as terminal:
        terminal.expect("▶ SPEED 60 ALWAYS")
        terminal.send("V")
        terminal.expect("could not show", "it needs a display")
        terminal.send("q")
        assert "left at" in terminal.said()


@pytest.mark.thorough
def test_without_a_browser_and_at_any_size_the_session_goes_on(tmp_path: Path) -> None:
    none = {"PATH": "/usr/bin:/bin", "DISPLAY": "", "WAYLAND_DISPLAY": "", "TMPDIR": str(tmp_path)}
    record = tmp_path / "kept.txt"
    words = ["debug", str(HITS), "--at", "2", "--break", "12", "--record", str(record)]
    with Terminal(words, tmp_path, (80, 24), none) as terminal:
        terminal.expect("2.000 s of")
        terminal.send("v")
        terminal.expect("no browser with a window was found here")
        terminal.resize(1, 1)
        terminal.resize(80, 24)
        terminal.send("c")
        terminal.expect("line 12  breakpoint")
        terminal.send("w")
        terminal.send("-l", "can1_grp")
        terminal.send("Enter")
        terminal.expect("there is no `can1_grp` here: `can1_grip`")
        terminal.send("?")
        terminal.expect("Forward", "1 to 22 of")
        terminal.send("PageDown")
        terminal.expect("stop when a variable or a signal changes")
        terminal.send("q")
        terminal.send("q")
        assert "left at 4.256 s" in terminal.said()
    kept = [line for line in record.read_text().splitlines() if not line.startswith("#")]
    assert kept == ["break 12", "at 2.0", "continue"]


@pytest.mark.thorough
def test_a_small_terminal_is_told(tmp_path: Path) -> None:
    with Terminal(["debug", str(HITS)], tmp_path, (60, 15)) as terminal:
        terminal.expect("at least 72 x 20")
        terminal.send("q")
        assert "left at" in terminal.said()
