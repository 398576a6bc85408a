"""Whatever is typed, every question has an answer: programs with pieces cut out and thrown in."""

import random
from contextlib import suppress

import pytest

from tests.places import ROOT
from vrts.lsp.answers.checking import check
from vrts.lsp.answers.colouring import coloured
from vrts.lsp.answers.completing import complete
from vrts.lsp.answers.finding import references
from vrts.lsp.answers.fixing import remedies
from vrts.lsp.answers.folding import folds
from vrts.lsp.answers.formatting import layout_edits
from vrts.lsp.answers.hovering import hover
from vrts.lsp.answers.lenses import lenses
from vrts.lsp.answers.renaming import CannotRename, rename
from vrts.lsp.answers.signatures import signature
from vrts.lsp.answers.symbols import Symbol, symbols
from vrts.lsp.documents.documents import Document

SOURCES = sorted((ROOT / "examples").glob("*/solution.v2"))
PIECES = (
    *(".PROGRAM", ".PROGRAM a(", ".END", ".LOCATIONS\n", "CALL ", "GOTO", "IF ", "END\n", "DO\n"),
    *('"', "(", ")", "[", ":", ",", ";", "$", "#", "-", "=", "\n", "\r\n", "\t", "10 ", "²", "🤖"),
    *("x = ", "SIG(", "TRANS(", "VALUE", "CASE x OF", "..", "\x00", "'", "^H", "/", "99999 "),
)
ROUNDS = 300


def typed(chosen: random.Random) -> tuple[str, int]:
    """Return a program with a few slips, and where the cursor stands."""
    text = chosen.choice(SOURCES).read_text("utf-8")
    at = 0
    for _ in range(chosen.randrange(1, 6)):
        at = chosen.randrange(len(text) + 1)
        cut = chosen.choice([0, 0, 1, 5, 40])
        piece = chosen.choice(PIECES)
        text = text[:at] + piece + text[at + cut :]
        at = min(at + len(piece), len(text))
    return text, at


@pytest.mark.thorough
def test_every_question_is_answered() -> None:
    chosen = random.Random(8)
    for _ in range(ROUNDS):
        text, at = typed(chosen)
        document = Document("/c/a.v2", text)
        source = document.source
        at = min(at, len(source.text))
        group = [document]
        hover(document, at, group)
        signature(document, at, group)
        found = complete(document, at, group)
        assert found.start <= found.end == at
        references(document, at, group)
        with suppress(CannotRename):
            rename(document, at, "other", group)
        for word in coloured(document):
            assert 0 <= word.start < word.end <= len(source.text)
            assert "\n" not in source.text[word.start : word.end]
        for symbol in symbols(document):
            _inside(symbol, len(source.text))
        assert all(0 <= f.first < f.last < len(source.line_starts) for f in folds(document))
        lenses(document)
        for edit in layout_edits(document):
            assert 0 <= edit.start <= edit.end <= len(source.text)
        for diagnostic in check(document):
            for remedy in remedies(document, diagnostic):
                for edit in remedy.edits:
                    assert 0 <= edit.start <= edit.end <= len(source.text)


def _inside(symbol: Symbol, size: int) -> None:
    assert 0 <= symbol.start <= symbol.name_start <= symbol.name_end <= symbol.end <= size, symbol
    for part in symbol.parts:
        _inside(part, size)
