"""Every command that README and its pages show: each is one, and from a wheel each works."""

import shutil
import signal
import subprocess
from pathlib import Path

import pytest
from click.testing import CliRunner

from tests.places import ROOT
from tests.support_typed import Typed, commands
from tests.support_wheel import alone, installed
from vrts.cli.main import vrts

LEARN = ROOT / "vrts" / "manual" / "learn"
README = ROOT / "README.md"
PAGES = [README, *sorted(LEARN.glob("*.md")), ROOT / ".github" / "CONTRIBUTING.md"]
SHOWN = [typed for page in PAGES for typed in commands(page, ROOT)]
TABLES = [one for one in commands(LEARN / "what-to-type.md", ROOT) if one.in_table]
HEADINGS = list(dict.fromkeys(one.heading for one in TABLES if one.folder != "none"))

TERMINAL = ("debug", "monitor", "teach")  # want keys: typed by tests of terminals
SERVES: dict[tuple[str, ...], str] = {  # until Ctrl-C, and how it begins
    ("serve", "cans-on-bases"): "serving cans-on-bases at ",
    ("grade", "desk"): "the desk of R. Huber for ",
}
FAILS = {"fix": (0, 1), "why": (0, 1)}  # 1 is the right answer where points are lost


@pytest.mark.parametrize("typed", SHOWN, ids=lambda one: f"{one.page}:{one.line}")
def test_there_is_such_a_command_with_such_options(typed: Typed) -> None:
    said = CliRunner().invoke(vrts, [*typed.words, "--help"])
    assert said.exit_code == 0, f"{typed.text}\n{said.output}"
    assert said.output.startswith("Usage: vrts")


def test_commands_are_found_and_the_rows_are_many() -> None:
    assert len([one for one in SHOWN if one.page == "README.md"]) >= 8
    assert len(TABLES) >= 60
    assert len(HEADINGS) == 6
    assert "verify solution.v2" in {" ".join(one.words) for one in TABLES}


@pytest.mark.thorough
@pytest.mark.parametrize("heading", HEADINGS)
def test_every_row_works_from_a_wheel_outside_the_checkout(heading: str, tmp_path: Path) -> None:
    here = installed()
    rows = [one for one in TABLES if one.heading == heading]
    assert here.run(["learn", rows[0].folder], tmp_path).returncode == 0
    folder = next(tmp_path.iterdir())
    if heading == "To a real robot":  # its last rows are about the marks of a class
        assert here.run(["grade", ".", "-o", "out"], folder).returncode == 0
    for row in rows:
        if row.words[0] in TERMINAL:
            continue
        if row.words[:2] in SERVES:
            serves_until_ctrl_c(row, folder)
            continue
        said = here.run(row.words, folder)
        allowed = FAILS.get(row.words[0], (0,))
        assert said.returncode in allowed, f"{row.line}: {row.text}\n{said.stdout}{said.stderr}"


def serves_until_ctrl_c(row: Typed, folder: Path) -> None:
    server = subprocess.Popen(
        [installed().vrts, *row.words],
        cwd=folder,
        env=alone(),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    assert server.stdout is not None
    first = server.stdout.readline()
    server.send_signal(signal.SIGINT)
    rest = server.communicate(timeout=60)[0]
    assert first.startswith(SERVES[row.words[:2]]), first + rest
    assert server.returncode in (0, 130, -signal.SIGINT)


@pytest.mark.thorough
def test_every_command_of_the_front_page_works_from_a_wheel(tmp_path: Path) -> None:
    """In a folder with what a clone has at its top, but for the code."""
    shutil.copytree(ROOT / "examples", tmp_path / "examples")

    for row in [one for one in SHOWN if one.page == "README.md"]:
        said = installed().run(row.words, tmp_path)
        lost = "hits-base" in row.text and row.words[0] == "verify"
        assert said.returncode == int(lost), f"{row.text}\n{said.stdout}{said.stderr}"
