"""`-` wherever a file may stand, and outputs that cannot be written told before anything is run."""

import os
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import click
import pytest

from tests.places import ROOT
from tests.support_commands import vrts, vrts_text
from tests.unit.cli.grammar.every import every_command, options_of
from vrts.cli.grammar.outputs import ALSO, EITHER, FILES, OWN, require_outputs
from vrts.cli.shared.console import write_file

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
            known = name in FILES or name == EITHER or (words, name) in (*OWN, *ALSO)
            assert known, f"`vrts {words} {name}`"


@pytest.mark.thorough
@pytest.mark.parametrize("words", ["run", "verify", "prove", "view"])
def test_what_cannot_be_written_is_told_before_a_program_is_read(
    words: str, tmp_path: Path
) -> None:
    (tmp_path / "file").write_text("")
    names = FILES & set(options_of(EVERY[words]))
    if EITHER in options_of(EVERY[words]):
        names |= {EITHER}
    assert names
    assert names - {EITHER} or words == "view"
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


def require(target: Path, option: str = "--html") -> int:
    """Return the exit status with which a file that cannot be written is told; 0: none is."""
    command = click.Command("verify", params=[click.Option([option, "target"])])
    try:
        require_outputs(command, {"target": target})
    except SystemExit as refused:
        return int(str(refused.code))
    return 0


def write(target: Path) -> int:
    try:
        write_file(target, b"later")
    except OSError:
        return 2
    return 0


@pytest.fixture
def seen() -> Iterator[Path]:
    """Return a folder that everybody may look into, unlike those of pytest."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)
        yield Path(folder)


def as_nobody(ask: Callable[[], int]) -> int:
    """Return an answer of a process that may not write everywhere, as root may."""
    child = os.fork()
    if child == 0:
        status = 99
        try:
            if os.geteuid() == 0:
                os.setgroups([])
                os.setgid(65534)
                os.setuid(65534)
            status = ask()
        finally:
            os._exit(status)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


@pytest.mark.skipif(sys.platform == "win32", reason="about modes")
def test_what_is_told_is_what_cannot_be_written(seen: Path) -> None:
    """A file is replaced: what counts is its folder, unless the file is somebody else's."""
    us = 65534 if os.geteuid() == 0 else os.geteuid()
    cases: list[tuple[str, int, int, int | None, int]] = [
        ("usual", 0o700, 0o600, us, 0),
        ("read-only file", 0o700, 0o400, us, 0),
        ("new file", 0o700, 0, None, 0),
        ("read-only folder", 0o500, 0o600, us, 2),
        ("new file, read-only folder", 0o500, 0, None, 2),
    ]
    if os.geteuid() == 0:
        cases += [
            ("somebody's file for all", 0o700, 0o666, 0, 0),
            ("somebody's file", 0o700, 0o644, 0, 2),
        ]
    for name, folder_mode, mode, owner, status in cases:
        folder = seen / name
        folder.mkdir()
        page = folder / "page.html"
        if owner is not None:
            page.write_bytes(b"earlier")
            page.chmod(mode)
            if os.geteuid() == 0:
                os.chown(page, owner, owner)
        if os.geteuid() == 0:
            os.chown(folder, us, us)
        folder.chmod(folder_mode)
        assert as_nobody(lambda page=page: require(page)) == status, name
        assert as_nobody(lambda page=page: write(page)) == status, name
        folder.chmod(0o700)


@pytest.mark.skipif(sys.platform == "win32", reason="about modes")
def test_what_is_written_in_pieces_is_not_replaced(seen: Path) -> None:
    file = seen / "run.rrd"
    file.write_bytes(b"earlier")
    file.chmod(0o444)
    assert as_nobody(lambda: require(file, "--record")) == 2


def test_a_link_is_written_where_it_leads(tmp_path: Path) -> None:
    (tmp_path / "page.html").symlink_to(tmp_path / "nowhere" / "page.html")
    assert require(tmp_path / "page.html") == 2


def test_a_dash_is_stdout_and_what_else_is_said_goes_aside() -> None:
    page = vrts("verify", SOLUTION, "--html", "-")
    assert page.stdout.startswith(b"<!doctype html>")
    assert page.stderr.startswith(b"10.0 / 10")
    saved = vrts("run", SOLUTION, "--save", "-")
    assert saved.stdout[:2] == b"PK"
    table = vrts("run", SOLUTION, "--csv", "-")
    assert table.stdout.startswith(b"time_s,")
    seen = vrts("view", SOLUTION, "-o", "-")  # nothing is opened
    assert (seen.returncode, seen.stdout[:15]) == (0, b"<!doctype html>")


def test_what_wants_a_name_says_so_before_a_program_is_read(tmp_path: Path) -> None:
    shown = vrts_text("view", "nowhere.v2", "--viewer", "rerun", "-o", "-")
    assert shown.returncode == 2
    assert shown.stderr.startswith("error: `--output` wants a name, not `-`\n")
    words = ("dispatch", "rehearse", tmp_path, "--log", "-", "--json")
    both = vrts_text(*words)
    assert both.returncode == 2
    assert both.stderr.startswith("error: `--log` and `--json` would both be written to stdout")


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


def test_a_dash_in_a_file_is_not(tmp_path: Path) -> None:
    (tmp_path / "p.v2").write_text(".PROGRAM p\n.END\n")
    task = (EXAMPLE / "task.toml").read_text().replace('scene = "cans-on-bases"', 'scene = "-"')
    (tmp_path / "task.toml").write_text(task)
    scene = (ROOT / "scenes" / "cans-on-bases" / "scene.toml").read_text()
    said = vrts_text("verify", "p.v2", cwd=tmp_path, stdin=scene)
    assert (said.returncode, said.stdout) == (2, "")
    assert said.stderr.startswith("error: there is no scene `-`\n")


def test_a_folder_is_looked_into_or_told(tmp_path: Path) -> None:
    (tmp_path / "b.v2").write_text(".PROGRAM p\n.END\n")
    assert vrts_text("compile", tmp_path).returncode == 0
    (tmp_path / "a.v2").write_text(".PROGRAM p\n.END\n")
    several = vrts_text("compile", tmp_path)
    assert several.stderr.startswith(
        f"error: there are several programs in `{tmp_path}`: `a.v2`, `b.v2`\n"
    )


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
