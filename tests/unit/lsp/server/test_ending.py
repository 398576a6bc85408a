"""A server ends with its editor, however that ends, and so does all that it began."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.support_framing import framed, read_framed
from tests.support_lsp import PATIENCE, SERVER, Client
from tests.unit.lsp.begun import Begun

ENDLESS = """.PROGRAM main
10      DRIVE 1, 10, 100
        DRIVE 1, -10, 100
        GOTO 10
.END
"""
EDITOR = (sys.executable, "-c", "input()")
EXIT = {"jsonrpc": "2.0", "method": "exit"}


def begin(server: tuple[str, ...], editor: int) -> "subprocess.Popen[bytes]":
    """Return a server that has begun and watches a process."""
    pipe = subprocess.PIPE
    process = subprocess.Popen((sys.executable, *server), stdin=pipe, stdout=pipe, stderr=pipe)
    assert process.stdin is not None
    assert process.stdout is not None
    params: dict[str, Any] = {"processId": editor, "rootUri": None, "capabilities": {}}
    asked = {"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": params}
    process.stdin.write(framed(asked))
    process.stdin.flush()
    found = read_framed(process.stdout)
    assert found is not None
    assert "result" in found
    return process


def test_it_ends_with_the_process_of_its_editor_and_ends_what_it_began(tmp_path: Path) -> None:
    editor = subprocess.Popen(EDITOR, stdin=subprocess.PIPE)
    with Begun(tmp_path / "begun") as begun:
        server = begin(begun.server, editor.pid)
        assert server.stdin is not None
        assert server.stderr is not None
        uri = (tmp_path / "a.v2").as_uri()
        document = {"uri": uri, "languageId": "val2", "version": 1, "text": ENDLESS}
        params = {"textDocument": document}
        opened = {"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": params}
        server.stdin.write(framed(opened))
        server.stdin.flush()
        run = begun.next()
        editor.kill()  # stdin of the server stays open
        editor.communicate()
        assert server.wait(PATIENCE) == 1
        run.wait(PATIENCE)
        told = server.stderr.read().decode()
        server.communicate()
    assert told == f"the editor, process {editor.pid}, is gone: so is its server\n"


@pytest.mark.thorough
def test_a_server_that_is_killed_leaves_no_run(tmp_path: Path) -> None:
    with Begun(tmp_path / "begun") as begun:
        client = Client(tmp_path, server=begun.server)
        client.open("a.v2", ENDLESS)
        run = begun.next()
        client.process.kill()
        run.wait(PATIENCE)
        client.gone()


@pytest.mark.parametrize("shut_down", [False, True])
def test_the_status_tells_whether_the_client_said_goodbye(tmp_path: Path, shut_down: bool) -> None:
    client = Client(tmp_path, server=(*SERVER, "--no-runs"))
    client.open("a.v2", ENDLESS)
    if shut_down:
        client.do("shutdown")
    client.send(EXIT)
    assert client.gone() == (0 if shut_down else 1)
    assert client.errors == []


def test_an_editor_that_is_gone_from_the_beginning_needs_no_server() -> None:
    editor = subprocess.Popen(EDITOR, stdin=subprocess.PIPE)
    editor.communicate()
    server = begin((*SERVER, "--no-runs"), editor.pid)
    assert server.wait(PATIENCE) == 1
    server.communicate()
