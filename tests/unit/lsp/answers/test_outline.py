"""Symbols, folding and formatting, by a real client of a real server."""

from pathlib import Path
from typing import Any

from tests.support_lsp import Client
from vrts.base.source import SourceFile
from vrts.lang.dialect import VAL2
from vrts.lang.writing.layout import layout

TEXT = """; pick and
; place
.PROGRAM main(n, $how)
        FOR k = 1 TO n
            IF k > 2 THEN
                MOVE part
            ELSE
10              READY
            END
        END
.END
.PROGRAM
        ready
.END
.LOCATIONS
part            450 -120 -50 90 90 0
.END
"""


def tree(found: list[dict[str, Any]]) -> list[Any]:
    return [(s["name"], s.get("detail"), tree(s.get("children") or [])) for s in found]


def test_shape_of_a_file(tmp_path: Path) -> None:
    (tmp_path / "other.v2").write_text(".PROGRAM palletise\n.END\n", "utf-8")
    with Client(tmp_path) as client:
        client.open("a.v2", TEXT)
        found = client.about("documentSymbol", "a.v2")
        assert tree(found) == [
            ("main", "(n, $how)", [("10", "label", [])]),
            ("(no name)", None, []),
            (".LOCATIONS", None, [("part", "450 -120 -50 90 90 0", [])]),
        ]
        assert found[0]["range"]["end"] == {"line": 10, "character": 4}
        assert found[0]["selectionRange"]["start"] == {"line": 2, "character": 9}

        folds = client.about("foldingRange", "a.v2")
        assert [(f["startLine"], f["endLine"], f.get("kind")) for f in folds] == [
            (0, 1, "comment"),
            (2, 10, None),
            (3, 8, None),
            (4, 5, None),
            (6, 7, None),
            (11, 13, None),
            (14, 16, None),
        ]

        everywhere = client.do("workspace/symbol", query="pa")
        assert [(s["name"], s["containerName"]) for s in everywhere] == [
            ("part", "a.v2"),
            ("palletise", "other.v2"),
        ]

        options = {"tabSize": 4, "insertSpaces": True}
        edits = client.about("formatting", "a.v2", options=options)
        assert edits == [
            {
                "range": {
                    "start": {"line": 12, "character": 0},
                    "end": {"line": 12, "character": 13},
                },
                "newText": "        READY",
            }
        ]
        assert layout(SourceFile("a.v2", TEXT), VAL2) == TEXT.replace("ready", "READY")

        above = {"start": {"line": 0, "character": 0}, "end": {"line": 12, "character": 0}}
        assert client.about("rangeFormatting", "a.v2", range=above, options=options) == []

        client.change("a.v2", ".PROGRAM a\n")
        assert tree(client.about("documentSymbol", "a.v2")) == [("a", None, [])]
        client.change("a.v2", "")
        assert client.about("documentSymbol", "a.v2") == []
        assert client.about("foldingRange", "a.v2") == []
        assert client.about("formatting", "a.v2", options=options) == []
