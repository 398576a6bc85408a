"""The unit for systemd: it runs the very command, whatever is in it, and is fenced in."""

import shlex
import shutil
import subprocess
from itertools import pairwise
from pathlib import Path

import pytest
from click.testing import CliRunner

from vrts.cli.main import vrts
from vrts.live.watching.service import Service, unit


def values(text: str) -> dict[str, list[str]]:
    """Return what a unit says, by its keys."""
    found: dict[str, list[str]] = {}
    for line in text.splitlines():
        if "=" in line and not line.startswith("#"):
            key, _, value = line.partition("=")
            found.setdefault(key, []).append(value)
    return found


def printed(*words: str) -> str:
    said = CliRunner().invoke(vrts, ["serve", *words, "--service"])
    assert said.exit_code == 0, said.output
    return said.stdout


def test_it_prints_this_very_command_with_absolute_paths(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "my scene.toml").write_text("")
    (tmp_path / "rooms.txt").write_text("One\n")
    words = ("cans-on-bases", "my scene.toml", "--rooms", "rooms.txt", "--name", "a.example")
    more = ("--name", "b.example", "--port", "8443", "--students-reset", "--turn", "90")
    said = values(printed(*words, *more))
    (command,) = said["ExecStart"]
    run = shlex.split(command)
    assert Path(run[0]).is_absolute()
    run = run[run.index("serve") + 1 :]
    assert run[:2] == ["cans-on-bases", str(tmp_path / "my scene.toml")]
    pairs = list(pairwise(run))
    assert ("--folder", str(tmp_path / "vrts-live")) in pairs
    assert ("--rooms", str(tmp_path / "rooms.txt")) in pairs
    for pair in (("--name", "a.example"), ("--name", "b.example"), ("--port", "8443")):
        assert pair in pairs
    assert ("--turn", "90") in pairs
    assert "--students-reset" in run
    assert not {"--service", "--host", "--idle", "--no-code"} & set(run), "what was not said"
    assert said["ReadWritePaths"] == [str(tmp_path / "vrts-live")]
    for key, value in (
        ("User", "vrts"),
        ("NoNewPrivileges", "yes"),
        ("ProtectSystem", "strict"),
        ("Restart", "on-failure"),
        ("MemoryMax", "75%"),
        ("CapabilityBoundingSet", ""),
    ):
        assert said[key] == [value]


def test_a_port_that_changes_is_no_service() -> None:
    said = CliRunner().invoke(vrts, ["serve", "cans-on-bases", "--port", "0", "--service"])
    assert said.exit_code == 2
    assert "needs a port that stays" in said.stderr


def test_a_key_of_a_service_has_a_folder_of_its_own(tmp_path: Path) -> None:
    own, shared = tmp_path / "own", tmp_path / "shared"
    for folder in (own, shared):
        folder.mkdir()
        for name in ("log-key", "log-key.0123.seen"):
            (folder / name).write_text("")
    (shared / "passwd").write_text("")
    for key in (own / "log-key", tmp_path / "new" / "log-key"):
        said = values(printed("cans-on-bases", "--folder", "/srv/live", "--log-key", str(key)))
        assert said["ReadWritePaths"] == ["/srv/live", str(key.parent)]
    for key, folder in ((shared / "log-key", "/srv/live"), (own / "log-key", str(own / "live"))):
        words = ["serve", "cans-on-bases", "--folder", folder, "--log-key", str(key), "--service"]
        refused = CliRunner().invoke(vrts, words)
        assert refused.exit_code == 2
        assert f"needs a folder for its key alone, and `{key.parent}` holds more" in refused.stderr


def test_characters_of_systemd_mean_nothing() -> None:
    said = unit(Service(("/x/vrts", "serve", "100% $HOME", 'a"b;c\\'), (Path("/srv/a b"),), (), 80))
    (command,) = values(said)["ExecStart"]
    assert command == '/x/vrts serve "100%% $$HOME" "a\\"b;c\\\\"'
    assert values(said)["ReadWritePaths"] == ['"/srv/a b"']
    assert values(said)["AmbientCapabilities"] == ["CAP_NET_BIND_SERVICE"]


@pytest.mark.skipif(shutil.which("systemd-analyze") is None, reason="needs systemd-analyze")
def test_systemd_finds_no_fault_with_it(tmp_path: Path) -> None:
    file = tmp_path / "vrts-live.service"
    file.write_text(printed("cans-on-bases", "--folder", "/srv/100% vrts live", "--port", "80"))
    for words in (("verify", "--man=no"), ("security", "--offline=true", "--threshold=30")):
        command = ["systemd-analyze", *words, str(file)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr + done.stdout
