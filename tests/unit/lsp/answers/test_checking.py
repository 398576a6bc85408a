"""Diagnostics of buffers, by a real client of a real server."""

import json
from pathlib import Path

import pytest

from tests.support_lsp import Client, where

GOOD = """.PROGRAM main
        MOVE part
.END
.LOCATIONS
part            450 -120 -50 90 90 0
.END
"""
BAD = GOOD.replace("MOVE part", "MOVEE part")


@pytest.mark.thorough
@pytest.mark.parametrize("editor", ["neovim@v0.11", "visual-studio-code", "emacs"])
def test_a_mistake_is_underlined_with_a_link_to_its_explanation(
    tmp_path: Path, editor: str
) -> None:
    with Client(tmp_path, editor=editor) as client:
        client.open("a.v2", BAD)
        (found,) = client.diagnostics("a.v2")
        assert found["code"] == "V120"
        assert found["severity"] == 1
        assert found["source"] == "vrts"
        assert found["range"] == {
            "start": {"line": 1, "character": 8},
            "end": {"line": 1, "character": 13},
        }
        assert "`MOVEE` is not an instruction" in found["message"]
        assert "help: did you mean `MOVE`?" in found["message"]
        page = Path(found["codeDescription"]["href"].removeprefix("file://"))
        assert page.read_text("utf-8").startswith("# V120")


@pytest.mark.thorough
def test_edits_in_the_middle_of_a_line_are_followed(tmp_path: Path) -> None:
    with Client(tmp_path) as client:
        client.open("a.v2", BAD)
        assert client.diagnostics("a.v2")
        client.change("a.v2", "", (1, 12), (1, 13))
        assert client.diagnostics("a.v2") == []


def test_related_places_are_told(tmp_path: Path) -> None:
    text = ".PROGRAM main\n10      READY\n10      READY\n.END\n"
    with Client(tmp_path) as client:
        client.open("a.v2", text)
        (found,) = [d for d in client.diagnostics("a.v2") if d["code"] == "V134"]
        (related,) = found["relatedInformation"]
        assert related["location"]["uri"] == client.uri("a.v2")
        assert related["location"]["range"]["start"]["line"] == 1


def test_closing_takes_the_diagnostics_away(tmp_path: Path) -> None:
    with Client(tmp_path) as client:
        client.open("a.v2", BAD)
        assert client.diagnostics("a.v2")
        client.close("a.v2")
        assert client.said_next("textDocument/publishDiagnostics")["diagnostics"] == []


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16", "utf-32"])
def test_columns_count_as_the_client_counts(tmp_path: Path, encoding: str) -> None:
    line = '        TYPE "🤖é", nothing'
    with Client(tmp_path, [encoding]) as client:
        assert client.able["positionEncoding"] == encoding
        client.open("a.v2", f".PROGRAM main\n{line}\n.END\n")
        (found,) = [d for d in client.diagnostics("a.v2") if d["code"] == "V205"]
        before = line[: line.index("nothing")]
        units = {
            "utf-8": len(before.encode()),
            "utf-16": len(before.encode("utf-16-le")) // 2,
            "utf-32": len(before),
        }
        assert found["range"]["start"]["character"] == units[encoding]


def test_what_another_file_defines_is_only_noted(tmp_path: Path) -> None:
    text = ".PROGRAM main\n        CALL place\n        MOVE part\n.END\n"
    with Client(tmp_path) as client:
        client.open("a.v2", text)
        assert {d["code"]: d["severity"] for d in client.diagnostics("a.v2")} == {
            "V206": 2,
            "V204": 3,
        }
        (tmp_path / "cell.lc").write_text(".LOCATIONS\npart 450 0 0 90 90 0\n.END\n", "utf-8")
        client.open("b.v2", ".PROGRAM place\n        READY\n.END\n")
        found = {d["code"]: d for d in client.diagnostics("a.v2")}
        assert {code: d["severity"] for code, d in found.items()} == {"V206": 3, "V204": 3}
        assert "note: `b.v2` has it" in found["V206"]["message"]
        assert "`--with cell.lc`" in found["V204"]["message"]


def test_a_file_of_somebody_else_does_not_count(tmp_path: Path) -> None:
    (tmp_path / "other.v2").write_text(GOOD, "utf-8")  # has programs: `part` is its own
    with Client(tmp_path) as client:
        client.open("a.v2", ".PROGRAM mine\n        MOVE part\n.END\n")
        (found,) = client.diagnostics("a.v2")
        assert (found["code"], "has it" in found["message"]) == ("V204", False)


def test_every_half_typed_text_is_answered(tmp_path: Path) -> None:
    with Client(tmp_path) as client:
        client.open("a.v2", "")
        assert client.diagnostics("a.v2") == []
        for end in range(1, len(GOOD), 9):
            client.change("a.v2", GOOD[:end])
        client.diagnostics("a.v2")
        for odd in (
            ".PROGRAM",
            ".PROGRAM (",
            '"',
            "\x00\x1a",
            "MOVE part:",
            "a" * 20_000,
            "\ud800",
        ):
            client.change("a.v2", odd)
            client.diagnostics("a.v2")
        client.change("a.v2", GOOD)
        assert client.diagnostics("a.v2") == []


def test_malformed_messages_are_survived(tmp_path: Path) -> None:
    with Client(tmp_path) as client:
        client.raw(b"Content-Length: 9\r\n\r\n{nonsense")
        client.raw(b"Content-Length: words\r\n\r\n")
        client.raw(b"Content-Length: 2\r\n\r\n[]")
        client.send({"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {"a": 1}})
        client.send({"jsonrpc": "2.0", "method": "textDocument/didChange", "params": None})
        assert client.ask("no/such", a=1)["error"]["code"] == -32601
        client.open("a.v2", BAD)
        assert len(client.diagnostics("a.v2")) == 1


def test_a_huge_message_takes_no_memory_and_the_session_goes_on(tmp_path: Path) -> None:
    client = Client(tmp_path)
    client.raw(b"Content-Length: 999999999999\r\n\r\n" + json.dumps({}).encode())
    client.open("a.v2", BAD)
    assert len(client.diagnostics("a.v2")) == 1
    assert client.leave() == 0
    assert client.errors == []


def test_a_client_that_disconnects_leaves_no_process(tmp_path: Path) -> None:
    client = Client(tmp_path)
    client.open("a.v2", BAD * 50)  # gone while it is checked
    assert client.gone() == 0


def test_a_client_that_leaves_politely(tmp_path: Path) -> None:
    assert Client(tmp_path).leave() == 0


def test_where_counts_from_zero() -> None:
    assert where(GOOD, "part") == (1, 13)
    assert where(GOOD, "part", 2) == (4, 0)
