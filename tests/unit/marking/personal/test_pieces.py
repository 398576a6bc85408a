"""Pieces that are cut out of files: what is about one goes, and other bytes stay."""

import pytest

from tests.unit.marking.by_hand.support import AT, change, written
from vrts.marking.by_hand.decisions.ledger import ledger_of
from vrts.marking.by_hand.decisions.records import (
    Assign,
    Comment,
    Decide,
    Forgotten,
    Give,
    Item,
    Undo,
)
from vrts.marking.by_hand.decisions.state import prepared
from vrts.marking.personal.decided import without_student
from vrts.marking.personal.named import Names
from vrts.marking.personal.overrides import without_changes
from vrts.marking.personal.tables import without_lines

ONE = {"zoe"}


def test_lines_of_graders_lose_one_student_and_keep_their_numbers() -> None:
    huber = written(
        "huber",
        Comment(1, AT, "zoe", "look"),
        Item(2, AT, "late", "late", "-1"),
        Give(3, AT, "late", ("ben", "zoe"), programs={"zoe": "", "ben": ""}),
        change("zoe", mark="3"),
        Undo(5, AT, ("huber:1", "huber:3"), "both"),
        Undo(6, AT, ("huber:4",)),
        change("ben", delta="1"),
        Assign(8, AT, ("zoe",), ("huber",)),
    )
    lang = written(
        "lang",
        Undo(1, AT, ("huber:6",)),
        change("zoe", mark="4"),
        Decide(3, AT, "lang:2", ("huber:4",), "agreed"),
        Decide(4, AT, "huber:7", ("lang:2", "huber:3"), "ben", students=("ben", "zoe")),
    )
    other = written("other", change("ben", delta="2"))
    files = {"huber.jsonl": huber, "lang.jsonl": lang, "other.jsonl": other}
    after = {**files, **without_student(files, ONE)}
    assert b"zoe" not in b"".join(after.values())
    assert after["other.jsonl"] is other
    lines, before = after["huber.jsonl"].splitlines(), huber.splitlines()
    same = [k for k, line in enumerate(before) if lines[k] == line]
    assert same == [0, 2, 7]
    ledger = ledger_of(after)
    assert not ledger.diagnostics
    assert ledger.last == {"huber": 8, "lang": 4, "other": 1}
    assert [one.name for one in ledger.records] == [
        *("huber:2", "huber:3", "huber:5", "huber:7", "lang:4", "other:1")
    ]
    ready = prepared(ledger)
    assert not ready.dangling
    assert set(ready.about) == {"ben"}
    assert without_student(after, ONE) == {}


def test_half_a_line_goes_and_a_whole_one_without_its_end_stays() -> None:
    data = written("huber", change("ben", delta="1"))
    half = {"huber.jsonl": data + b'{"does":"comment","number":2,"student":"zo'}
    assert without_student(half, ONE) == {"huber.jsonl": data}
    assert without_student({"huber.jsonl": data[:-1]}, ONE) == {}


def test_forgotten_is_a_line_of_its_own() -> None:
    assert ledger_of({"huber.jsonl": written("huber", Forgotten(1, AT))}).records == ()  # type: ignore[arg-type]


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_changes_of_others_keep_their_bytes(end: str) -> None:
    change = '[[change]]\nstudent = "{}"\ndelta = 1\nreason = "r"\nwho = "w"\ndate = "2026-11-01"\n'
    first = "# all\n\n# ours\n" + change.format("anna")
    mine = "\n# zoe was ill\n" + change.format("zoe")
    last = "# and ben\n" + change.format("ben")
    text, left = first + mine + last, first + "\n" + last
    data = text.replace("\n", end).encode()
    assert without_changes(data, "overrides.toml", ONE) == left.replace("\n", end).encode()
    assert without_changes(data, "overrides.toml", {"nobody"}) is data


@pytest.mark.parametrize("codec", ["utf-8", "utf-8-sig", "utf-16", "cp1252"])
@pytest.mark.parametrize("sign", [",", ";"])
def test_lines_of_others_keep_their_bytes(codec: str, sign: str) -> None:
    head = f"id{sign}name{sign}attempts\r\n"
    anna = f'anna{sign}"Änne ""A"""{sign}"1\n2"\r\n'
    zoe = f'zoe{sign}Zoé{sign}"a\r\nb"\r\n'
    ben = f"ben{sign}Bén{sign}"
    data = (head + anna + zoe + ben).encode(codec)
    assert without_lines(data, "intake.csv", ONE) == (head + anna + ben).encode(codec)
    assert without_lines(data, "intake.csv", {"nobody"}) == data


def test_names_are_found_as_files_write_them() -> None:
    names = Names(("anna", "Jörg O'Neil", "xy"))
    for text in ("anna.v2", "(Anna)", "a_anna_1", "J\\u00f6rg O'Neil", "Jörg O&#x27;Neil"):
        assert names.are_in(text.encode()), text
    for text in ("anna-berger", "hanna", "annas", "xy"):
        assert not names.are_in(text.encode()), text
