"""The debug adapter and a client of others: Microsoft's, with which VS Code's debuggers are tested.

`.ci/run` installs it beside the packages of Python; nothing is fetched here.
"""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.unit.debug.dap.test_dap import FIRST_AND_OTHERS, HITS
from tests.unit.debug.test_debugger import TEXT

FOLDER = Path(sys.prefix) / "node"
PACKAGE = FOLDER / "node_modules" / "@vscode" / "debugadapter-testsupport"
SCRIPT = Path(__file__).with_name("microsoft_client.cjs")
VRTS = Path(sys.executable).with_name("vrts")
SECONDS = 240

pytestmark = [
    pytest.mark.skipif(shutil.which("node") is None, reason="needs Node"),
    pytest.mark.skipif(
        not PACKAGE.is_dir(), reason=f"needs Microsoft's client in {FOLDER}; .ci/run installs it"
    ),
]


def play(scene: str, program: Path) -> None:
    done = subprocess.run(
        ["node", str(SCRIPT), str(FOLDER), str(VRTS), scene, str(program)],
        capture_output=True,
        text=True,
        timeout=SECONDS,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.thorough
@pytest.mark.parametrize("example", FIRST_AND_OTHERS)  # the others are thorough
def test_every_example_goes_forward_and_back(example: Path) -> None:
    play("forward and back", example)


def test_a_contact_stops_with_the_line_that_caused_it() -> None:
    play("contact", HITS)


@pytest.mark.thorough
@pytest.mark.parametrize(
    "scene", ["forward and back", "breakpoint", "another future", "changes", "without debugging"]
)
def test_a_program_with_two_threads(scene: str, tmp_path: Path) -> None:
    program = tmp_path / "loop.v2"
    program.write_text(TEXT)
    play(scene, program)
