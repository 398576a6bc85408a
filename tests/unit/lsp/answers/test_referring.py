"""Definition, references and rename, in one file and across a folder."""

import re
from pathlib import Path
from typing import Any

import pytest

from tests.support_lsp import Client, where
from tests.unit.lsp.cursor import at
from vrts.base.source import SourceFile
from vrts.ir.dump import dump
from vrts.lang.compiler import Options, compile_source
from vrts.lsp.answers.finding import Found, definition, references
from vrts.lsp.answers.renaming import CannotRename, renamable, rename
from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.linking import group

TEXT = """.PROGRAM main(n)
        count = n
        CALL place(count)
        MOVE part
10      IF count > 2 GOTO 10
        SIGNAL 5
.END
.PROGRAM place(n)
10      count = n+SQRT(4)
        MOVES part:TRANS(n)
        GOTO 10
.END
.LOCATIONS
part            450 -120 -50 90 90 0
.END
"""


def lines(found: list[Found]) -> list[tuple[str, int]]:
    return [(f.document.source.name, f.document.source.line_of(f.occurrence.start)) for f in found]


def marked(before: str) -> tuple[Document, int]:
    """Return the text with the cursor where a piece of it holds `|`."""
    piece = before.replace("|", "")
    assert piece in TEXT
    return at(TEXT.replace(piece, before, 1))


@pytest.mark.parametrize(
    ("piece", "defined", "used"),
    [
        ("CALL pla|ce", [8], [3, 8]),
        ("MOVES pa|rt", [14], [4, 10, 14]),
        ("GOTO 1|0\n        SIGNAL", [5], [5, 5]),
        ("MOVES part:TRANS(|n)", [8], [8, 9, 10]),
        ("count = |n\n", [1], [1, 2]),
        ("IF cou|nt", [2, 9], [2, 3, 5, 9]),
        ("SIGNAL |5", [], [6]),
    ],
)
def test_where_names_are(piece: str, defined: list[int], used: list[int]) -> None:
    document, offset = marked(piece)
    assert [line for _, line in lines(definition(document, offset, [document]))] == defined
    assert [line for _, line in lines(references(document, offset, [document]))] == used


def test_files_that_belong_together() -> None:
    main = Document("/c/a.v2", ".PROGRAM main\n CALL place\n MOVE shelf\n.END\n")
    place = Document("/c/b.v2", ".PROGRAM place\n MOVE shelf\n.END\n")
    data = Document("/c/c.lc", ".LOCATIONS\nshelf 1 2 3 90 90 0\n.END\n")
    stranger = Document("/c/d.v2", ".PROGRAM main\n MOVE shelf\n.END\n")
    beside = [place, data]
    assert group(main, beside) == [main, place, data]
    assert [d.path for d in group(place, [main, data])] == ["/c/b.v2", "/c/a.v2", "/c/c.lc"]
    apart = Document("/c/e.v2", ".PROGRAM other\n SET shelf = HERE\n MOVE shelf\n.END\n")
    assert group(apart, [main, place]) == [apart]
    assert group(stranger, [apart]) == [stranger]  # its program gives `shelf` another value


@pytest.mark.parametrize(
    ("piece", "new", "places"),
    [
        ("CALL pla|ce", "put", 2),
        ("MOVES pa|rt", "can", 3),
        ("GOTO 1|0\n.END", "20", 2),
        ("count = |n\n", "number", 2),
        ("CALL place(co|unt", "Total", 4),
    ],
)
def test_a_renamed_program_means_the_same(piece: str, new: str, places: int) -> None:
    document, offset = marked(piece)
    found = rename(document, offset, new, [document])
    assert len(found) == places
    text = TEXT
    for _, o in sorted(found, key=lambda f: -f.occurrence.start):
        text = text[: o.start] + new + text[o.end :]
    before, after = (compile_source(SourceFile("a.v2", t)) for t in (TEXT, text))
    assert [d.rule.code for d in after.diagnostics] == [d.rule.code for d in before.diagnostics]
    assert new in text


LOCALS = """.PROGRAM main(n, $how, part)
        AUTO i, j, p, $s
        FOR i = 1 TO n
            j = i+ABS(j)
            SET p = part:TRANS(j, i)
            MOVE SHIFT(p BY i, j, n)
            TYPE $how, i, $s
        END
        CALL other(i, $s, p)
        count = j
.END
.PROGRAM other(i, $s, p)
        AUTO n
        n = i+count
        TYPE $s, n
        MOVE p
.END
"""


def renamed(text: str, offset: int, new: str) -> str:
    document = Document("/c/a.v2", text)
    for _, o in sorted(
        rename(document, offset, new, [document]), key=lambda f: -f.occurrence.start
    ):
        text = text[: o.start] + new + text[o.end :]
    return text


def test_a_local_has_another_name_and_back_and_nothing_else_changes() -> None:
    names = Document("/c/a.v2", LOCALS).names
    before = compile_source(SourceFile("a.v2", LOCALS), Options())
    assert before.module is not None, before.diagnostics
    locals_ = [t for t in names.by_target if t.family == "variable" and t.program]
    assert len(locals_) == 11
    for target in locals_:
        offset = names.by_target[target][0].start
        sign = target.name[0] if target.name[0] in "$#" else ""
        new = f"{sign}zebra"
        text = renamed(LOCALS, offset, new)
        assert text.count("zebra") == len(names.by_target[target])
        after = compile_source(SourceFile("a.v2", text), Options())
        assert after.module is not None
        plain = [named(dump(one.module), target.name) for one in (before, after) if one.module]
        assert plain[0] == plain[1], target
        assert renamed(text, text.index("zebra") - len(sign), target.name) == LOCALS


def named(text: str, name: str) -> str:
    """Return a program with one name for two."""
    bare = re.escape(name.lstrip("$#"))
    return re.sub(rf"\b({bare}|zebra)\b", "one", text)


@pytest.mark.parametrize(
    ("piece", "new", "why"),
    [
        ("MOVES pa|rt", "2fast", "is not a name"),
        ("MOVES pa|rt", "$text", "has no `$` or `#`"),
        ("MOVES pa|rt", "count", "there is a variable `count` already"),
        ("MOVES pa|rt", "n", "`main` uses it, and has a variable `n` of its own already"),
        ("count = |n\n", "part", "`main` uses the shared `part`, which it could not reach then"),
        ("count = |n\n", "count", "`main` uses the shared `count`"),
        ("MOVES pa|rt", "MOVE", "a word of the language"),
        ("MOVES pa|rt", "a_name_that_is_far_too_long", "15 characters"),
        ("CALL pla|ce", "main", "there is a program `main` already"),
        ("GOTO 1|0\n.END", "ten", "is not a label"),
        ("GOTO 1|0\n.END", "99999", "is not a label"),
        ("SQ|RT", "root", "a function of the language"),
        ("SIGNAL |5", "6", "the number of a signal"),
        ("MOV|ES", "go", "only programs, labels"),
    ],
)
def test_a_refusal_says_why(piece: str, new: str, why: str) -> None:
    document, offset = marked(piece)
    with pytest.raises(CannotRename, match=why.replace("$", r"\$")):
        rename(document, offset, new, [document])


def test_two_labels_of_one_program_stay_two() -> None:
    document, offset = at(".PROGRAM a\n1|0 READY\n20 GOTO 10\n.END\n")
    with pytest.raises(CannotRename, match="a label `20` in `a` already"):
        rename(document, offset, "20", [document])
    assert renamable(document, offset).target.program == "a"


def test_over_the_protocol_across_a_folder(tmp_path: Path) -> None:
    (tmp_path / "b.v2").write_text(".PROGRAM place\n MOVE shelf\n.END\n", "utf-8")
    (tmp_path / "c.lc").write_text(".LOCATIONS\nshelf 1 2 3 90 90 0\n.END\n", "utf-8")
    text = ".PROGRAM main\n        CALL place\n        MOVE shelf\n.END\n"
    with Client(tmp_path) as client:
        client.open("a.v2", text)
        called, shelf = where(text, "place"), where(text, "shelf")
        (found,) = client.about("definition", "a.v2", called)
        assert found["uri"] == client.uri("b.v2")
        assert found["range"]["start"] == {"line": 0, "character": 9}

        context = {"includeDeclaration": False}
        found = client.about("references", "a.v2", shelf, context=context)
        assert [f["uri"] for f in found] == [client.uri("a.v2"), client.uri("b.v2")]

        begun = client.about("prepareRename", "a.v2", shelf)
        assert begun["placeholder"] == "shelf"
        changes: dict[str, Any] = client.about("rename", "a.v2", shelf, newName="rack")["changes"]
        assert changes.keys() == {client.uri(name) for name in ("a.v2", "b.v2", "c.lc")}
        (edit,) = changes[client.uri("c.lc")]
        assert edit == {
            "range": {"start": {"line": 1, "character": 0}, "end": {"line": 1, "character": 5}},
            "newText": "rack",
        }

        document = {"uri": client.uri("a.v2")}
        position = {"line": 1, "character": 14}
        asked = {"textDocument": document, "position": position, "newName": "no name"}
        error = client.ask("textDocument/rename", **asked)["error"]
        assert error["code"] == -32803
        assert error["message"].startswith("`no name` is not a name")

        marks = client.about("documentHighlight", "a.v2", shelf)
        assert [m["range"]["start"]["line"] for m in marks] == [2]

        (tmp_path / "b.v2").unlink()  # a file that goes while it is looked at
        assert client.about("definition", "a.v2", called) == []
