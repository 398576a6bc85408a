"""What can be taken for what: the examples of Unicode Technical Standard 39, and its table."""

import hashlib
import tomllib
import unicodedata
from importlib.resources import files

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from vrts.live.people.skeleton import TABLE, look, skeleton

FOLDER = files("vrts.live.people")
VENDORED = tomllib.loads(FOLDER.joinpath("vendored.toml").read_text("utf-8"))["confusables"]
ROWS = [
    (chr(int(code, 16)), "".join(chr(int(one, 16)) for one in prototype.split()))
    for line in FOLDER.joinpath(TABLE).read_text("ascii").splitlines()
    if not line.startswith("#")
    for prototype, _, alike in (line.partition(":"),)
    for code in alike.split()
]
# the standard takes a character apart before it looks it up: rows of others are never looked at
WHOLE = [row for row in ROWS if unicodedata.is_normalized("NFD", row[0])]


@pytest.mark.parametrize(("name", "digest"), sorted(VENDORED["files"].items()))
def test_the_table_and_its_licence_are_as_they_came(name: str, digest: str) -> None:
    assert hashlib.sha256(FOLDER.joinpath(name).read_bytes()).hexdigest() == digest


def test_every_row_of_the_table_holds() -> None:
    assert len(ROWS) == len(dict(ROWS)) == VENDORED["rows"]
    wrong = [source for source, target in WHOLE if skeleton(source) != skeleton(target)]
    assert wrong == [], "each character has the skeleton of its prototype"


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("paypal", "p\u0430yp\u0430l"),  # section 1 and 4: Cyrillic a
        ("paypal", "ρ⍺у𝓅𝒂ן"),
        ("𝔭𝒶ỿ𝕡𝕒ℓ", "ρ⍺у𝓅𝒂ן"),
        ("scope", "ѕсоре"),  # all of it Cyrillic
        ("toys", "tоуѕ"),
        ("ljeto", "ǉeto"),
        ("so̷s", "søs"),
        ("paypal", "paypa1"),
        ("paypal", "paypaI"),
        ("PAYPAL", "paypal"),
        ("Inna", "lnna"),
        ("Inna", "inna"),
        ("o'neil", "O’Neil"),
        ("modern", "modem"),
        ("Jose\u0301", "José"),
        ("1ש", "ש1"),  # they are displayed alike, or may be
    ],
)
def test_what_can_be_taken_for_one_another(one: str, other: str) -> None:
    assert look(one).alike(look(other))
    assert look(other).alike(look(one))


@pytest.mark.parametrize(
    ("one", "other"),
    [("Anna", "Hanna"), ("Anna", "Nana"), ("李雷", "韩梅"), ("שרה", "הרש"), ("José", "Jose")],
)
def test_what_is_told_apart(one: str, other: str) -> None:
    assert not look(one).alike(look(other))
    assert not look(other).alike(look(one))


@given(st.text(max_size=8))
@example("\u0345\u0323")
def test_a_skeleton_stays_as_it_is(text: str) -> None:
    once = skeleton(text)
    assert skeleton(once) == once


@given(st.lists(st.sampled_from(WHOLE), min_size=1, max_size=6))
def test_one_character_for_another_that_looks_the_same_changes_no_look(
    rows: list[tuple[str, str]],
) -> None:
    given_, changed = "".join(row[0] for row in rows), "".join(row[1] for row in rows)
    assert skeleton(given_) == skeleton(changed)
