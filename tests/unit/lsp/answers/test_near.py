"""What would mend a long text is the same whether all of it is checked or what is near alone."""

import asyncio
from collections.abc import Sequence
from functools import cache
from typing import Any

import pytest

from tests.unit.lsp.heard import URI, Heard, begun
from vrts.base.diagnostic import Diagnostic
from vrts.lsp.answers import near as room
from vrts.lsp.answers.checking import check
from vrts.lsp.answers.fixing import remedies
from vrts.lsp.answers.near import LONG, near
from vrts.lsp.documents.documents import Document

STEPS = """        MOVE part
        IF count > 2 THEN
            CALL put(count)
        END
        MOVEE part
        count = 3
"""
END = """.PROGRAM put(n)
        FOR k = 1 TO n
            DELAY 1
        END
.END
.LOCATIONS
part            450 -120 -50 90 90 0
.END
"""
MANY = "".join(f".PROGRAM p{n}\n{STEPS}.END\n" for n in range(52)) + END
ONE = f".PROGRAM p0\n{STEPS * 70}.END\n{END}"
IN_THE_MIDDLE = 25  # the step that is another


@cache
def wrong(text: str) -> tuple[Diagnostic, ...]:
    return check(Document("/c/a.v2", text))


def offered(document: Document, found: Sequence[Diagnostic], lines: range) -> set[object]:
    """Return what would mend some lines."""
    return {
        (remedy.title, remedy.edits)
        for one in found
        if one.primary is not None and one.primary.span.line - 1 in lines
        for remedy in remedies(document, one)
    }


def edited(text: str, old: str, new: str) -> tuple[str, range]:
    """Return a text with one of its pieces changed, and the lines around it."""
    at = -1
    for _ in range(IN_THE_MIDDLE):
        at = text.index(old, at + 1)
    line = text.count("\n", 0, at)
    return text[:at] + new + text[at + len(old) :], range(line - 3, line + 6)


@pytest.mark.parametrize("text", [MANY, ONE], ids=["many", "one"])
@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("MOVE part", "MOVES part"),
        ("MOVE part", "MOVESS part"),
        ("MOVE part", "APROS part, 5"),
        ("MOVE part", "MOVEE part\n        DEPARTTS 50\n"),
        ("        count = 3\n", ""),
        ("        MOVEE part\n", ""),
    ],
)
def test_what_mends_a_place_is_what_the_whole_check_says(text: str, old: str, new: str) -> None:
    before = Document("/c/a.v2", text)
    assert text.count("\n") > LONG
    changed, lines = edited(text, old, new)
    after = Document("/c/a.v2", changed)
    found = near(after, lines, before, wrong(text), lambda: [after])
    assert found is not None
    wanted = offered(after, check(after), lines)
    assert offered(after, found, lines) == wanted
    assert wanted or not new


@pytest.mark.parametrize(
    ("old", "new", "title"),
    [
        ("            CALL put(count)\n        END\n", "", "Write the missing END"),
        ("CALL put(count)", "CALL putt(count)", "Write a program `putt`"),
    ],
)
def test_a_short_program_is_compiled_and_knows_the_others(old: str, new: str, title: str) -> None:
    before = Document("/c/a.v2", MANY)
    text, lines = edited(MANY, old, new)
    after = Document("/c/a.v2", text)
    found = near(after, lines, before, wrong(MANY), lambda: [after])
    assert found is not None
    titles = {remedy.title for one in found for remedy in remedies(after, one)}
    assert title in titles
    assert "Write a program `put`" not in titles
    other = Document("/c/b.v2", ".PROGRAM putt(n)\n        DELAY n\n.END\n")
    found = near(after, lines, before, wrong(MANY), lambda: [after, other])
    assert found is not None
    titles = {remedy.title for one in found for remedy in remedies(after, one)}
    assert "Write a program `putt`" not in titles


def test_where_too_much_is_new_all_is_checked() -> None:
    after = Document("/c/a.v2", ONE.replace("MOVE part", "MOVEX part"))
    before = Document("/c/a.v2", ONE)
    assert near(after, range(400), before, wrong(ONE), lambda: [after]) is None
    assert near(after, range(5), before, wrong(ONE), lambda: [after]) is not None


def test_an_action_waits_for_no_check_of_a_long_text(monkeypatch: pytest.MonkeyPatch) -> None:
    async def titles() -> tuple[list[str], int]:
        heard = await begun(MANY)
        session = heard.session
        document = session.document(URI)
        await session.diagnostics_of(document)
        checks = 0

        async def counted(_: Document) -> tuple[Diagnostic, ...]:
            nonlocal checks
            checks += 1
            return ()

        monkeypatch.setattr(session, "_checked", counted)
        heard.change(URI, edited(MANY, "MOVE part", "APROS part, 5")[0])
        found = await asked(heard, edited(MANY, "MOVE part", "")[1])
        session.leave()
        return found, checks

    async def asked(heard: Heard, lines: range) -> list[str]:
        start = {"line": lines.start, "character": 0}
        wanted = {"start": start, "end": {"line": lines.stop, "character": 0}}
        asked: dict[str, Any] = {
            "textDocument": {"uri": URI},
            "range": wanted,
            "context": {"diagnostics": []},
        }
        found = await heard.ask("textDocument/codeAction", asked)
        return [action["title"] for action in found["result"]]

    assert room.MOST < LONG
    found, checks = asyncio.run(titles())
    assert "Write `APPROS` instead of `APROS`" in found
    assert checks == 0
