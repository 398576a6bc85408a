"""Folders, databases and ports that a server cannot use: one sentence, and nothing is touched."""

import errno
import fcntl
import os
import resource
import signal
import socket
import sqlite3
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner

from tests.places import ROOT
from tests.support_commands import Begun, vrts_text
from tests.support_live import PATIENCE, LiveServer
from vrts.cli.main import vrts
from vrts.live.lasting.folder_lock import FILE, held, holder
from vrts.live.settings import DATABASE
from vrts.live.store.database import opened
from vrts.live.store.migrations import STEPS
from vrts.pipeline.files import CannotRead


def refused(folder: Path, *options: str, port: int = 0) -> str:
    """Try to serve; return what is said, which has two lines and no traceback."""
    begun = Begun("serve", "cans-on-bases", "--folder", folder, "--port", port, *options)
    assert begun.stderr is not None
    try:
        status = begun.wait(PATIENCE)
    finally:
        begun.kill()  # one that serves after all
        with begun.stderr:
            said = begun.stderr.read()
    assert status == 2, said
    error, *help_ = said.splitlines()
    assert error.startswith("error: ")
    assert all(line.startswith("help: ") for line in help_)
    assert len(help_) <= 1
    return said


def test_a_second_server_in_a_folder_is_refused(tmp_path: Path) -> None:
    folder = tmp_path / "live"
    server = LiveServer(folder)
    before = (folder / DATABASE).read_bytes()
    said = refused(folder)
    assert f"another server (process {server.process.pid}) works in the folder" in said
    said = refused(folder, port=server.port)
    assert f"(process {server.process.pid}) listens at port {server.port}" in said
    assert (folder / DATABASE).read_bytes() == before
    assert server.request("GET", "/").status == 200, "the first one goes on"
    server.kill()
    assert (folder / FILE).read_text().strip() == str(server.process.pid), "a stale file is left"
    assert holder(folder) is None
    server.start("0")
    assert holder(folder) == server.process.pid
    with server:
        server.process.send_signal(signal.SIGTERM)


def test_a_file_system_without_locks_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def no_locks(descriptor: int, operation: int) -> None:
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    monkeypatch.setattr(fcntl, "flock", no_locks)
    with pytest.raises(CannotRead, match="knows no locks"), held(tmp_path):
        pass


def foreign(path: Path) -> None:
    connection = sqlite3.connect(path)
    connection.execute("CREATE TABLE recipes (name)")
    connection.commit()
    connection.close()


def foreign_with_version(path: Path) -> None:
    foreign(path)
    connection = sqlite3.connect(path)
    connection.execute("PRAGMA user_version=2")
    connection.close()


def newer(path: Path) -> None:
    connection = opened(path)
    connection.execute(f"PRAGMA user_version={len(STEPS) + 1}")
    connection.close()


def truncated(path: Path) -> None:
    connection = opened(path)
    for number in range(200):
        connection.execute("INSERT INTO counter VALUES (?, 1)", (f"{number:0300}",))
    connection.close()
    with path.open("r+b") as file:
        file.truncate(path.stat().st_size // 2)


def overwritten(path: Path) -> None:
    """Put something else into a page in the middle, as a failing disk does: the head is right."""
    sql = ROOT / "tests" / "data" / "live-databases" / "version-8.sql"
    connection = sqlite3.connect(path, isolation_level=None)
    connection.executescript(sql.read_text("utf-8"))
    (size,) = connection.execute("PRAGMA page_size").fetchone()
    connection.close()
    with path.open("r+b") as file:
        file.seek(2 * size)
        file.write(b"\xff" * 600)


def no_database(path: Path) -> None:
    path.write_text("Dear diary, " * 2000)


def emptied(path: Path) -> None:
    path.touch()
    (path.parent / "sessions" / "r-1").mkdir(parents=True)


ASKED = (
    *(("--verify-logs",), ("--accept-logs",), ("--backup", "copy.sqlite"), ("--add-user", "Eva")),
    *(("--export-user", "Anna"), ("--purge-user", "Anna")),
    *(("--ways-in",), ("--renew-code",), ("--end-way", "3f2a90bc"), ("--supervisor-link",)),
)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (foreign, "is a database of another program"),
        (foreign_with_version, "is a database of another program"),
        (newer, "was written by a later vrts"),
        (truncated, "damaged"),
        (overwritten, "is damaged"),
        (no_database, "it is no SQLite database"),
        (emptied, "is empty, but sessions were kept"),
    ],
)
def test_a_database_of_no_use_is_named_and_stays(
    tmp_path: Path, make: Callable[[Path], None], words: str
) -> None:
    path = tmp_path / DATABASE
    make(path)
    before = path.read_bytes()
    assert words in refused(tmp_path)
    assert path.read_bytes() == before, "nothing was written"
    for option in ASKED:
        said = CliRunner().invoke(vrts, ["serve", "--folder", str(tmp_path), *option])
        assert said.exit_code == 2, option
        assert words in said.stderr, option
        assert path.read_bytes() == before, f"{option}: nothing was written"
    assert [file.name for file in tmp_path.glob("*.sqlite")] == [DATABASE], "and nothing was made"


def test_a_copy_does_not_take_the_place_of_the_database(tmp_path: Path) -> None:
    opened(tmp_path / DATABASE).close()
    said = vrts_text("serve", "--folder", tmp_path, "--backup", tmp_path / DATABASE)
    assert (said.returncode, "is the database itself" in said.stderr) == (2, True)


def test_a_folder_that_may_not_be_written_is_named(tmp_path: Path) -> None:
    assert "/sys/vrts" in refused(Path("/sys/vrts"))  # not even by root
    (tmp_path / "file").touch()
    assert "file" in refused(tmp_path / "file")


def test_a_port_that_cannot_be_had_is_named(tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        said = refused(tmp_path / "live", port=port)
        assert f"another program listens at port {port} already" in said
        assert "--port 0" in said
    assert not (tmp_path / "live").exists(), "nothing was made"
    assert "cannot listen at 192.0.2.1" in refused(tmp_path / "live", "--host", "192.0.2.1")


def test_a_disk_that_is_full_from_the_start_is_named(tmp_path: Path) -> None:
    """Files cannot grow beyond a page, as on a full disk."""
    command = "ulimit -f 4; exec $0 -m vrts.cli.main serve cans-on-bases --port 0 --folder $1"
    said = subprocess.run(
        ["bash", "-c", command, sys.executable, str(tmp_path / "live")],
        capture_output=True,
        text=True,
        check=False,
        timeout=60.0,
    )
    assert said.returncode == 2, said
    assert "the disk is full" in said.stderr
    assert "Traceback" not in said.stderr
    opened(tmp_path / "live" / DATABASE).close()  # later, with room
    assert resource.getrlimit(resource.RLIMIT_FSIZE)[0] == resource.RLIM_INFINITY
