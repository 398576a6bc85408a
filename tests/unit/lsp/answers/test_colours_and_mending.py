"""Colours of words, and edits that mend a text."""

from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support_lsp import Client, where
from vrts.base.source import SourceFile
from vrts.lang.compiler import compile_source
from vrts.lsp.answers.checking import check
from vrts.lsp.answers.colouring import Colour, coloured
from vrts.lsp.answers.fixing import remedies
from vrts.lsp.documents.documents import Document
from vrts.lsp.server.colours import changed

TEXT = """.PROGRAM main(n)
        ; 🤖 go
10      MOVE part
        count = SQRT(n)+1 ; "é"
        CALL place("🤖", count)
.END
"""


def test_words_and_what_they_are() -> None:
    document = Document("/c/a.v2", TEXT)
    found = [(document.source.text[c.start : c.end], c.colour) for c in coloured(document)]
    assert found == [
        (".PROGRAM", Colour.MACRO),
        ("main", Colour.FUNCTION),
        ("n", Colour.PARAMETER),
        ("; 🤖 go", Colour.COMMENT),
        ("10", Colour.LABEL),
        ("MOVE", Colour.KEYWORD),
        ("part", Colour.LOCATION),
        ("count", Colour.VARIABLE),
        ("=", Colour.OPERATOR),
        ("SQRT", Colour.FUNCTION),
        ("n", Colour.PARAMETER),
        ("+", Colour.OPERATOR),
        ("1", Colour.NUMBER),
        ('; "é"', Colour.COMMENT),
        ("CALL", Colour.KEYWORD),
        ("place", Colour.FUNCTION),
        ('"🤖"', Colour.STRING),
        ("count", Colour.VARIABLE),
        (".END", Colour.MACRO),
    ]
    roles = {(c.start, c.is_definition) for c in coloured(document)}
    assert (TEXT.index("count ="), True) in roles
    assert (TEXT.index("count)"), False) in roles


def mended(text: str, title: str) -> str:
    document = Document("/c/a.v2", text)
    offered = [r for d in check(document) for r in remedies(document, d)]
    ((edit,),) = [r.edits for r in offered if r.title == title]
    return text[: edit.start] + edit.text + text[edit.end :]


@pytest.mark.parametrize(
    ("before", "title", "after"),
    [
        ("MOVEE part", "Write `MOVE` instead of `MOVEE`", "        MOVE part\n"),
        ("x = here", "Insert `SET`", "        SET x = here\n"),
        ("FOR k = 1 TO 2\n            READY", "Write the missing END", "READY\n        END\n.END"),
        ("CALL put", "Write a program `put`", ".END\n\n.PROGRAM put\n.END\n"),
    ],
)
def test_mending(before: str, title: str, after: str) -> None:
    text = f".PROGRAM main\n        SET part = HERE\n        {before}\n.END\n"
    result = mended(text, title)
    assert after in result
    diagnostics = compile_source(SourceFile("a.v2", result)).diagnostics
    assert not [d for d in diagnostics if d.is_error]
    assert "V206" not in {d.rule.code for d in diagnostics}


def test_a_missing_end_line() -> None:
    open_ended = ".PROGRAM a\n        READY\n"
    assert mended(open_ended, "Write the missing .END") == open_ended + ".END\n"
    two = open_ended + ".PROGRAM b\n        READY\n.END\n"
    assert mended(two, "Write the missing .END") == (
        open_ended + ".END\n.PROGRAM b\n        READY\n.END\n"
    )


def test_a_do_is_not_closed_by_end() -> None:
    document = Document("/c/a.v2", ".PROGRAM a\n        DO\n            READY\n.END\n")
    (found,) = [d for d in check(document) if d.rule.code == "V137"]
    assert list(remedies(document, found)) == []


def decoded(text: str, data: list[int], types: list[str]) -> list[tuple[str, str]]:
    """Return words and their types; columns in UTF-16."""
    lines = [line.encode("utf-16-le") for line in text.split("\n")]
    line = column = 0
    found: list[tuple[str, str]] = []
    for at in range(0, len(data), 5):
        down, right, length, number, _ = data[at : at + 5]
        column = right if down else column + right
        line += down
        word = lines[line][2 * column : 2 * (column + length)].decode("utf-16-le")
        found.append((word, types[number]))
    return found


@given(st.lists(st.integers(0, 3), max_size=12), st.lists(st.integers(0, 3), max_size=12))
def test_a_change_of_numbers_makes_the_others(before: list[int], after: list[int]) -> None:
    data = list(before)
    for edit in changed(before, after):
        data[edit.start : edit.start + edit.delete_count] = edit.data or []
    assert data == after


def test_over_the_protocol(tmp_path: Path) -> None:
    with Client(tmp_path, ["utf-16"]) as client:
        client.open("a.v2", TEXT)
        types = client.able["semanticTokensProvider"]["legend"]["tokenTypes"]
        whole = client.about("semanticTokens/full", "a.v2")
        data = whole["data"]
        words = decoded(TEXT, data, types)
        assert ("; 🤖 go", "comment") in words
        assert words[-4:] == [
            ("place", "function"),
            ('"🤖"', "string"),
            ("count", "variable"),
            (".END", "macro"),
        ]
        assert client.able["semanticTokensProvider"]["full"] == {"delta": True}
        line, column = where(TEXT, "part")
        client.change("a.v2", "other", (line, column), (line, column + 4))
        again = client.about(
            "semanticTokens/full/delta", "a.v2", previousResultId=whole["resultId"]
        )
        (edit,) = again["edits"]
        start, end = edit["start"], edit["start"] + edit["deleteCount"]
        assert edit["deleteCount"] <= 2  # the length of one word
        data[start:end] = edit["data"]
        fresh = client.about("semanticTokens/full", "a.v2")
        assert fresh["data"] == data
        same = {"previousResultId": fresh["resultId"]}
        assert client.about("semanticTokens/full/delta", "a.v2", **same)["edits"] == []
        lost = client.about("semanticTokens/full/delta", "a.v2", previousResultId="nonsense")
        assert lost["data"] == data
        client.change("a.v2", TEXT)

        some = {"start": {"line": 2, "character": 0}, "end": {"line": 2, "character": 9}}
        data = client.about("semanticTokens/range", "a.v2", range=some)["data"]
        assert decoded(TEXT, data, types) == [
            ("10", "enumMember"),
            ("MOVE", "keyword"),
            ("part", "property"),
        ]

        client.change("a.v2", TEXT.replace("MOVE", "MOVEE"))
        line, column = where(TEXT, "MOVE")
        spot = {"line": line, "character": column}
        found: list[dict[str, Any]] = client.about(
            "codeAction", "a.v2", range={"start": spot, "end": spot}, context={"diagnostics": []}
        )
        (action,) = found
        assert action["kind"] == "quickfix"
        assert action["diagnostics"][0]["code"] == "V120"
        (edit,) = action["edit"]["changes"][client.uri("a.v2")]
        assert edit["newText"] == "MOVE"
        assert edit["range"]["start"] == spot
