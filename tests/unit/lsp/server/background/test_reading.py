"""Folders with many long files: the open buffer is answered for at once, the rest comes later."""

import shutil
from pathlib import Path

import pytest

from tests.support_lsp import CONVERTER, Client, where
from vrts.lsp.answers.completing import MOST, complete
from vrts.lsp.documents.documents import MOST_BYTES, Document, Documents

FILES, STEPS = 40, 1000
TEXT = """.PROGRAM main
        CALL p{}
        MOVES part
.END
"""


def program(number: int) -> str:
    steps = "".join(f"        MOVES p{number}.{step}:TRANS({step})\n" for step in range(STEPS))
    return f".PROGRAM p{number}\n{steps}.END\n"


@pytest.mark.thorough
def test_the_open_buffer_comes_first(tmp_path: Path) -> None:
    folder = tmp_path / "lab"
    folder.mkdir()
    for number in range(FILES):
        (folder / f"f{number:02}.v2").write_text(program(number), "utf-8")
    text = TEXT.format(FILES - 1)
    with Client(folder) as client:
        client.open("a.v2", text)
        called = where(text, "p39")
        at_once = client.about("hover", "a.v2", called)["contents"]["value"]
        assert "not in this folder" in at_once
        found = client.diagnostics("a.v2", lambda _: True)
        (call,) = [d for d in found if d["code"] == "V206"]
        assert call["severity"] == 3  # nobody knows yet
        assert "note: the other files of the folder are still being read" in call["message"]

        (place,) = client.about("definition", "a.v2", called)  # waits for all
        assert place["uri"] == client.uri("f39.v2")
        found = client.diagnostics("a.v2")
        (call,) = [d for d in found if d["code"] == "V206"]
        assert "note: `f39.v2` has it" in call["message"]
        assert "in `f39.v2`" in client.about("hover", "a.v2", called)["contents"]["value"]
        (told,) = client.client.progress_reports.values()
        begun, *reports, _ = CONVERTER.unstructure(told)
        assert begun["title"] == "Reading the programs of lab"
        assert reports[-1] == {"kind": "report", "message": "40 of 40 files", "percentage": 100}

        shutil.rmtree(folder)  # all gone while it is open
        assert client.about("definition", "a.v2", called) == []


def test_only_what_has_been_read_counts(tmp_path: Path) -> None:
    for name in ("a.v2", "b.v2"):
        (tmp_path / name).write_text(f".PROGRAM {name[0]}\n.END\n", "utf-8")
    (tmp_path / "c.v2").write_bytes(b"%PDF-1.7\n")
    (tmp_path / "d.v2").write_bytes(b"; " * MOST_BYTES)
    documents = Documents()
    folder = str(tmp_path)
    documents.put(str(tmp_path / "a.v2"), ".PROGRAM mine\n.END\n")
    names = [Path(path).name for path in documents.unread(folder)]
    assert names == ["b.v2", "c.v2", "d.v2"]
    assert [d.source.name for d in documents.in_folder(folder)] == ["a.v2"]
    for path in documents.unread(folder):
        documents.read(path)
    assert documents.unread(folder) == []
    first, second = documents.in_folder(folder)
    assert first.names.defined_programs == {"mine"}
    (tmp_path / "b.v2").write_text(".PROGRAM other\n.END\n", "utf-8")
    assert [Path(path).name for path in documents.unread(folder)] == ["b.v2"]
    assert documents.in_folder(folder) == [first]
    documents.read(str(tmp_path / "b.v2"))
    assert documents.in_folder(folder)[1] is not second


def test_more_proposals_than_anybody_reads() -> None:
    names = "".join(f"part{number} 1 2 3 90 90 0\n" for number in range(2 * MOST))
    text = ".PROGRAM a\n MOVE part\n.END\n.LOCATIONS\n" + names + ".END\n"
    document = Document("/c/a.v2", text)
    found = complete(document, text.index("part") + 4, [document])
    assert len(found.proposals) == MOST
    assert not found.is_all
    some = Document("/c/a.v2", text.replace("part\n", "part77\n", 1))
    found = complete(some, text.index("part") + 6, [some])
    assert found.is_all
    assert {"part770", "part779"} <= {p.text for p in found.proposals}
