"""`vrts debug` by commands: for scripts, without a terminal."""

import json
from pathlib import Path

from tests.support_commands import vrts
from tests.support_programs import ROOT

HITS = ROOT / "examples/01-cans-on-bases/submissions/hits-base.v2"


def test_commands_are_carried_out_and_told_as_json() -> None:
    words = ("--at", "2", "--break", "12", "--command", "continue; why; assert 1 == 1", "--json")
    result = vrts("debug", HITS, *words)
    assert result.returncode == 0, result.stderr
    first, why, last = map(json.loads, result.stdout.splitlines())
    assert (first["line"], first["stopped"]["why"]) == (12, "breakpoint")
    assert "SPEED 60 ALWAYS" in why["reasons"][-1]
    assert (last["number"], last["ok"], last["value"]["value"]) == (3, True, -1.0)


def test_what_does_not_hold_is_status_1_and_the_rest_is_still_done(tmp_path: Path) -> None:
    file = tmp_path / "checks.txt"
    file.write_text("# of the first can\nat end\nassert DX(can1_grip) == 1\nprint DX(can1_grip)\n")
    result = vrts("debug", HITS, "--commands", file)
    assert result.returncode == 1
    text = result.stdout.decode()
    assert "! assert DX(can1_grip) == 1\n  `DX(can1_grip) == 1` does not hold here" in text
    assert "> print DX(can1_grip)\n  800" in text
    assert vrts("debug", HITS, "--commands", "-", stdin=b"step\n").returncode == 0


def test_a_saved_run_is_debugged_as_a_program_is(tmp_path: Path) -> None:
    saved = tmp_path / "out.vrun"
    assert vrts("run", HITS, "--save", saved).returncode in (0, 1)
    words = ("--at", "4", "--command", "step back; set x = 5; continue; print x")
    asked, executed = vrts("debug", saved, *words), vrts("debug", HITS, *words)
    assert asked.stdout == executed.stdout != b""
    assert asked.returncode == 0


def test_wrong_calls_say_what_would_do(tmp_path: Path) -> None:
    for words, said in (
        ((), b"debugging needs a terminal"),
        (("--json",), b"`--format json` goes with commands"),
        (("--command", "x" * 1001), b"at most 1,000 characters"),
        (("--break", "12:nosuch > 1", "--command", "continue"), b"there is no `nosuch` here"),
        (("--command", "step", "--record", "x"), b"--record goes with a terminal"),
        (("--commands", tmp_path / "none.txt"), b"no such file"),
    ):
        result = vrts("debug", HITS, *words)
        assert (result.returncode, said in result.stderr) == (2, True), result.stderr
