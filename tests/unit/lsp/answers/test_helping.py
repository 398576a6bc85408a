"""Hover, completion and signature help."""

import shutil
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_lsp import Client, where
from tests.unit.lsp.cursor import at
from vrts.lang.vocabulary.function_forms import argument_names
from vrts.lang.vocabulary.functions import FUNCTIONS
from vrts.lsp.answers.completing import What, complete
from vrts.lsp.answers.hovering import Hover, hover
from vrts.lsp.answers.signatures import signature
from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.words import named_usage

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
DATA = """.LOCATIONS
part            450 -120 -50 90 90 0
part2           450 -120 -50 90 90 0
#ready          0 -90 90 0 0 0
.END
.REALS
count           12
.END
"""
HEAD = """.PROGRAM place(n, $how)
        ; puts one can
        ; on its base
        READY
.END
.PROGRAM main(mine)
        MOVE mine
        count = 3
        $text = $MID($text, 1)
        out = 3
        SIGNAL out
        MOVE part
        SIGNAL 5
10      GOTO 10
"""


def shown(line: str) -> Hover | None:
    document, offset = at(f"{HEAD}        {line}\n.END\n{DATA}")
    return hover(document, offset, [document])


def test_an_instruction_is_explained() -> None:
    found = shown("APP|RO part, 50")
    assert found is not None
    assert found.code == "APPRO location, distance"
    assert found.about.startswith("move to a distance before a location")


def test_a_location_shows_its_values() -> None:
    found = shown("MOVE pa|rt")
    assert found is not None
    assert found.code.split() == [
        *("X/JT1", "Y/JT2", "Z/JT3", "O/JT4", "A/JT5", "T/JT6"),
        *("part", "450.00", "-120.00", "-50.00", "90.000", "90.000", "0.000"),
    ]
    assert found.place is not None
    assert found.place.translation == pytest.approx((0.45, -0.12, -0.05))


@pytest.mark.parametrize(
    ("line", "code", "about"),
    [
        ("MOVE #rea|dy", "#ready", "precision point"),
        ("x = SQ|RT(2)", "SQRT(number)", "square root; a number"),
        ("x = PI|", "PI = 3.14159", "a constant"),
        ("CALL pla|ce(1)", ".PROGRAM place(n, $how)", "puts one can on its base"),
        ("x = co|unt", "count = 12", "variable"),
        ("SIGNAL |5", "signal 5", "an output; used 2 times"),
        ("GOTO 1|0", "label 10", "in line 14"),
        ("MOVE nowhe|re", "nowhere", "location; never given a value"),
        ("SPEED 10 ALW|AYS", "ALWAYS", "the setting holds"),
        ("MOVE mi|ne", "mine", "its own in `main`"),
    ],
)
def test_what_names_mean(line: str, code: str, about: str) -> None:
    found = shown(line)
    assert found is not None
    assert code in found.code
    assert about in found.about


@pytest.mark.parametrize("line", ["; MOVE pa|rt", "|", 'TYPE "pa|rt"', "MOVE part,| 3"])
def test_nothing_is_known_elsewhere(line: str) -> None:
    assert shown(line) is None


def proposed(line: str, beside: list[Document] | None = None) -> dict[str, What]:
    document, offset = at(f"{HEAD}        {line}\n.END\n{DATA}")
    found = complete(document, offset, [document], beside or [])
    return {p.text: p.what for p in found.proposals}


@pytest.mark.parametrize(
    ("line", "wanted", "not_wanted"),
    [
        ("MO|", {"MOVE", "MOVES", "MOVET"}, {"part", "MOD"}),
        ("MOVE p|", {"part", "part2"}, {"place", "MOVE", "PI"}),
        ("MOVE |", {"part", "#ready", "mine", "TRANS"}, {"count", "$text", "PI", "SQRT", "$MID"}),
        ("MOVE part:|", {"part", "TRANS"}, {"#ready", "count", "PI"}),
        ("APPRO part, |", {"count", "SQRT"}, {"part", "$text", "#ready", "TRANS"}),
        ("SPEED |", {"count", "PI", "SQRT"}, {"$text", "part", "$MID", "TRANS", "place"}),
        ("SIGNAL |", {"5", "out", "count"}, {"part", "$text"}),
        ("SIGNAL 5, -|", {"5", "out"}, {"part", "$text"}),
        ("SPEED ou|", {"out"}, {"part"}),
        ("REACT |", {"5", "out"}, {"part", "place"}),
        ("BITS |", {"5"}, {"part"}),
        ("TYPE |", {"$text", "count", "$MID"}, {"part", "TRANS"}),
        ("x = |", {"count", "SQRT"}, {"part", "$text", "place", "$MID"}),
        ("$text = |", {"$text", "$MID"}, {"part", "count", "SQRT"}),
        ("SET part = |", {"part2", "TRANS"}, {"count", "$text", "SQRT"}),
        ("x = DX(|", {"part", "TRANS"}, {"count", "$text", "#ready"}),
        ("MOVE SHIFT(|", {"part"}, {"count", "$text"}),
        ("MOVE SHIFT(part BY 1, |", {"count"}, {"part", "$text"}),
        ("x = LEN(|", {"$text"}, {"part", "count"}),
        ("IF |", {"count", "$text", "SIG"}, {"part"}),
        ("MOVE part[|", {"count"}, {"part2", "$text"}),
        ("MOVE #|", {"#ready"}, {"part"}),
        ("CALL |", {"place", "main"}, {"part", "SQRT"}),
        ("GOTO |", {"10"}, {"part"}),
        ("IF x == 1 GOTO |", {"10"}, {"part"}),
        ("x = SIG(|", {"5"}, set[str]()),
        ("ENABLE C|", {"CP"}, {"count"}),
        ("x = cou|", {"count"}, {"COUNT"}),
        ("SPEED 10 ALW|", {"ALWAYS"}, set[str]()),
        (".P|", {".PROGRAM"}, {"part"}),
        ("mi|", {"mine"}, set[str]()),
        ("; MO|", set[str](), {"MOVE"}),
        ('TYPE "pa|', set[str](), {"part"}),
    ],
)
def test_what_a_word_may_become(line: str, wanted: set[str], not_wanted: set[str]) -> None:
    found = proposed(line)
    assert wanted <= found.keys()
    assert not not_wanted & found.keys()


def test_locations_come_first_where_one_is_wanted() -> None:
    document, offset = at(f"{HEAD}        MOVE |\n.END\n{DATA}")
    texts = [p.text for p in complete(document, offset, [document]).proposals]
    assert texts[:4] == ["#ready", "mine", "part", "part2"]
    document, offset = at(f"{HEAD}        x = |\n.END\n{DATA}")
    assert complete(document, offset, [document]).proposals[0].text == "count"


def test_names_of_other_files() -> None:
    other = Document("/cell/b.v2", ".PROGRAM stack\n        MOVE hidden\n.END\n")
    data = Document("/cell/c.lc", ".LOCATIONS\nshelf 1 2 3 90 90 0\n.END\n")
    assert "stack" in proposed("CALL s|", [other, data])
    assert "shelf" in proposed("MOVE s|", [other, data])
    assert "hidden" not in proposed("MOVE h|", [other, data])


def test_a_name_typed_for_the_first_time_does_not_propose_itself() -> None:
    assert "brandne" not in proposed("MOVE brandne|")


@pytest.mark.parametrize(
    ("line", "text", "parameter"),
    [
        ("APPRO |", "APPRO location, distance", "location"),
        ("APPRO part, |", "APPRO location, distance", "distance"),
        ("x = ATAN2(1, |", "ATAN2(y, x)", "x"),
        ("CALL place(1, |", "place(n, $how)", "$how"),
        ("x = MAX(1, 2, 3, |", "MAX(a, b...)", "b..."),
        ("MOVE TRANS(1, (2|", "TRANS(x, y, z, o, a, t)", "y"),
        ("MOVE SHIFT(part BY 1, |", "SHIFT(location BY dx, dy, dz)", "dy"),
    ],
)
def test_what_comes_next(line: str, text: str, parameter: str) -> None:
    document, offset = at(f"{HEAD}        {line}\n.END\n")
    found = signature(document, offset, [document])
    assert found is not None
    assert found.text.startswith(text)
    assert found.parameters[found.active] == parameter
    assert parameter in found.text


def test_each_argument_is_found_in_its_signature() -> None:
    for function in FUNCTIONS.values():
        text, at = named_usage(function), 0
        for name in argument_names(function):
            assert text.find(name) >= 0
            at = text.index(name, at) + len(name)
            assert at <= len(text), text


def test_no_signature_in_a_comment() -> None:
    document, offset = at(f"{HEAD}        ; APPRO |\n.END\n")
    assert signature(document, offset, [document]) is None


def test_help_over_the_protocol(tmp_path: Path) -> None:
    shutil.copytree(EXAMPLE, tmp_path / "lab")
    text = HEAD + ".END\n" + DATA
    with Client(tmp_path / "lab") as client:
        client.open("mine.v2", text)
        found = client.about("hover", "mine.v2", where(text, "part\n"))
        value = found["contents"]["value"]
        assert "450.00   -120.00    -50.00" in value
        assert "reachable, lefty, above, noflip" in value.lower() or "not reachable" in value
        assert found["range"]["start"] == {"line": 11, "character": 13}

        client.change("mine.v2", "        AP", (12, 0), (12, 16))
        found = client.about("completion", "mine.v2", (12, 10))
        item = next(i for i in found["items"] if i["label"] == "APPROS")
        assert item["textEdit"]["range"]["start"] == {"line": 12, "character": 8}
        assert item["textEdit"]["newText"] == "APPROS"

        client.change("mine.v2", "        APPRO part, ", (12, 0), (12, 10))
        found = client.about("signatureHelp", "mine.v2", (12, 20))
        assert found["signatures"][0]["label"] == "APPRO location, distance"
        assert found["activeParameter"] == 1
        assert client.about("hover", "mine.v2", (900, 3)) is None
