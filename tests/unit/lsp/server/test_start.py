"""The server loads nothing heavy: what runs programs or knows arms is a process beside it."""

import signal
from pathlib import Path

import pytest

from tests.support_lsp import Client, where
from tests.unit.lsp.in_a_cell import setting

HEAVY = {"numpy", "pinocchio", "coal", "fcl", "trimesh", "rerun"}
SAYS_WHAT_IT_LOADED = """
import atexit, sys
from vrts.cli.main import vrts
atexit.register(lambda: print("loaded:", *sys.modules, file=sys.stderr))
vrts(["lsp"])
"""
TEXT = """.PROGRAM main
        MOVEE part
.END
.LOCATIONS
part            900 0 0 90 90 0
.END
"""


@pytest.mark.thorough
def test_a_server_that_has_answered_everything_has_loaded_nothing_heavy(tmp_path: Path) -> None:
    setting(tmp_path)
    client = Client(tmp_path, server=("-c", SAYS_WHAT_IT_LOADED))
    client.open("a.v2", TEXT)
    assert [found["code"] for found in client.diagnostics("a.v2")] == ["V120"]
    found = client.about("hover", "a.v2", where(TEXT, "part"))
    assert "reachable" in found["contents"]["value"]  # as another process says
    client.change("a.v2", TEXT.replace("MOVEE", "MOVE"))
    goals = client.diagnostics("a.v2", lambda found: any(d["code"] == "V660" for d in found))
    assert {finding["source"] for finding in goals} == {"vrts verify"}
    assert client.leave() == 0
    (loaded,) = [line.split()[1:] for line in client.errors if line.startswith("loaded:")]
    assert "vrts.lsp.server.serving" in loaded
    assert HEAVY & set(loaded) == set()
    assert not any(name.startswith("vrts.lsp.runs") for name in loaded)


def test_ctrl_c_ends_it_as_every_command(tmp_path: Path) -> None:
    client = Client(tmp_path)
    client.open("a.v2", TEXT)
    assert [found["code"] for found in client.diagnostics("a.v2")] == ["V120"]
    client.process.send_signal(signal.SIGINT)
    assert client.gone() == 130
    assert client.errors[-1].strip() == "interrupted"
