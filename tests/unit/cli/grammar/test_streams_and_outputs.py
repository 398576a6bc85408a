"""`-` wherever a file may stand, and outputs that cannot be written told before anything is run."""

from pathlib import Path

import click
import pytest

from tests.places import ROOT
from tests.support_commands import vrts, vrts_text
from tests.unit.cli.grammar.every import every_command, options_of
from vrts.cli.grammar.outputs import EITHER, FILES, OWN

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SOLUTION = EXAMPLE / "solution.v2"
EVERY = every_command()


@pytest.mark.parametrize("words", EVERY)
def test_every_option_that_writes_a_file_is_looked_at_first(words: str) -> None:
    for name, option in options_of(EVERY[words]).items():
        says = (option.help or "").lower()
        writes = says.startswith(
            ("write a", "write the", "file to write", "write what", "file for")
        )
        takes_file = isinstance(option.type, click.Path) or option.type is click.STRING
        if writes and takes_file and not option.is_flag and name.startswith("--"):
            if option.multiple or (words, name) == ("validate log", "--log"):
                continue
            known = name in FILES or name == EITHER or (words, name) in OWN
            assert known, f"`vrts {words} {name}`"


@pytest.mark.parametrize("words", ["run", "verify", "prove", "view", "why"])
def test_what_cannot_be_written_is_told_before_a_program_is_read(
    words: str, tmp_path: Path
) -> None:
    (tmp_path / "file").write_text("")
    names = FILES & set(options_of(EVERY[words]))
    if EITHER in options_of(EVERY[words]):
        names |= {EITHER}
    for option in names:
        inside = vrts_text(words, "nowhere.v2", option, "file/page.html", cwd=tmp_path)
        assert inside.returncode == 2
        assert "nowhere.v2" not in inside.stderr, "it has begun"
        assert "`file`" in inside.stderr
    for option in names - {EITHER}:
        missing = vrts_text(words, "nowhere.v2", option, "none/page.html", cwd=tmp_path)
        assert missing.stderr.startswith("error: there is no folder `none` for `page.html`")
        folder = vrts_text(words, "nowhere.v2", option, ".", cwd=tmp_path)
        assert folder.stderr == f"error: `.` is a folder, and `{option}` writes a file\n"


def test_a_dash_is_stdout_and_what_else_is_said_goes_aside() -> None:
    page = vrts("verify", SOLUTION, "--html", "-")
    assert page.stdout.startswith(b"<!doctype html>")
    assert page.stderr.startswith(b"10.0 / 10")
    saved = vrts("run", SOLUTION, "--save", "-")
    assert saved.stdout[:2] == b"PK"
    table = vrts("run", SOLUTION, "--csv", "-")
    assert table.stdout.startswith(b"time_s,")


def test_stdout_is_for_one_thing() -> None:
    both = vrts_text("verify", SOLUTION, "--html", "-", "--json")
    assert both.returncode == 2
    assert both.stderr.startswith("error: `--html` and `--json` would both be written to stdout")
    two = vrts_text("run", SOLUTION, "--csv", "-", "--save", "-")
    assert (two.returncode, two.stdout) == (2, "")
    folder = vrts_text("grade", EXAMPLE, "-o", "-")
    assert folder.stderr == "error: `--output` wants a name, not `-`\n"


def test_a_dash_is_stdin_for_whatever_is_read() -> None:
    task = (EXAMPLE / "task.toml").read_bytes()
    assert vrts("verify", SOLUTION, "--task", "-", stdin=task).stdout.startswith(b"10.0 / 10")
    slips = (EXAMPLE / "gripper-slips.toml").read_bytes()
    assert vrts("verify", SOLUTION, "--scenario", "-", stdin=slips).stdout.startswith(b"4.0 / 10")
    scene = (ROOT / "scenes" / "cans-on-bases" / "scene.toml").read_bytes()
    shown = vrts("scene", "check", "-", stdin=b"nonsense = 1\n" + scene)
    assert b"--> stdin:" in shown.stderr


def test_near_misses_are_told() -> None:
    for words, near in (
        (("verfy",), "`vrts verify`"),
        (("scene", "shw"), "`vrts scene show`"),
        (("dispatch", "pln"), "`vrts dispatch plan`"),
        (("grade", "evidnce", "anna"), "`vrts grade evidence`"),
        (("grade", "cans-on-bases"), "`01-cans-on-bases`"),
        (("scene", "show", "cans-on-base"), "`cans-on-bases`"),
        (("explain", "V301", "contct"), "`contact`"),
    ):
        said = vrts_text(*words)
        assert said.returncode == 2
        assert near in said.stderr, said.stderr


def test_help_is_a_command_and_several_codes_are_explained() -> None:
    assert vrts_text("help", "new", "lab").stdout == vrts_text("new", "lab", "--help").stdout
    assert vrts_text("help").stdout == vrts_text("--help").stdout
    assert vrts_text("-V").stdout == vrts_text("--version").stdout
    both = vrts_text("explain", "V301", "contact").stdout
    assert "# V301 " in both
    assert "\n# V400 contact" in both
    for heading in ("Write programs", "Run and verify them", "Mark a class", "Share a robot"):
        assert f"\n{heading}" in vrts_text("--help").stdout
