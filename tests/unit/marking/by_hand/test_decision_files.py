"""Files of graders: whatever is in them is told by file and line, and adding is all or nothing."""

import os
from datetime import UTC, datetime
from fractions import Fraction
from pathlib import Path

import msgspec
import pytest

from vrts.marking.by_hand.decisions import files as decision_files
from vrts.marking.by_hand.decisions.files import add_decisions, read_decisions
from vrts.marking.by_hand.decisions.ledger import LARGEST_LINE
from vrts.marking.by_hand.decisions.records import (
    ChangeMark,
    Comment,
    Decision,
    Excuse,
    Item,
    Undo,
)
from vrts.pipeline.refused import Refused

NOW = datetime(2026, 11, 26, 20, tzinfo=UTC)


def comment(text: str = "why?") -> Comment:
    """Return a comment, without a time."""
    return Comment(0, "", "anna", text)


def add(folder: Path, *said: Decision, who: str = "R. Huber") -> tuple[str, ...]:
    """Add records; return their names."""
    return tuple(one.name for one in add_decisions(folder, who, said, NOW).records)


def test_records_get_numbers_in_order_and_are_read_back(tmp_path: Path) -> None:
    assert add(tmp_path / "decisions", comment("a"), comment("b")) == ("r-huber:1", "r-huber:2")
    assert add(tmp_path / "decisions", Undo(0, "", ("r-huber:1",))) == ("r-huber:3",)
    found = read_decisions(tmp_path / "decisions")
    assert [one.name for one in found.records] == ["r-huber:1", "r-huber:2", "r-huber:3"]
    assert found.records[0].said.at == "2026-11-26T20:00:00+00:00"
    assert not found.diagnostics
    assert found.revision != read_decisions(tmp_path / "nothing").revision


def test_all_or_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    add(tmp_path, comment())
    before = read_decisions(tmp_path)
    with pytest.raises(Refused):
        add(tmp_path, comment(), ChangeMark(0, "", ("anna",), "x", "1/0"))
    assert read_decisions(tmp_path) == before

    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(decision_files.os, "fsync", full)
    with pytest.raises(Refused) as problem:
        add(tmp_path, comment())
    assert "no space left" in problem.value.diagnostics[0].headline
    assert read_decisions(tmp_path) == before
    assert sorted(os.listdir(tmp_path)) == [".lock", "r-huber.jsonl"]


def test_what_a_crash_left_is_told_and_loses_nothing(tmp_path: Path) -> None:
    add(tmp_path, comment("a"), comment("b"))
    path = tmp_path / "r-huber.jsonl"
    whole = path.read_bytes()
    path.write_bytes(whole + b'{"does":"comment","num')
    found = read_decisions(tmp_path)
    assert len(found.records) == 2
    assert not found.wrong
    assert [one.rule.code for one in found.diagnostics] == ["V766"]
    assert add(tmp_path, comment("c")) == ("r-huber:3",)
    assert path.read_bytes().startswith(whole)
    assert not read_decisions(tmp_path).diagnostics
    path.write_bytes(path.read_bytes().rstrip(b"\n"))  # as some editors leave it
    assert len(read_decisions(tmp_path).records) == 3
    assert add(tmp_path, comment("d")) == ("r-huber:4",)


GOOD = (
    b'{"does":"excuse","number":1,"at":"2026-11-26T20:00:00+00:00","students":["a"],"reason":"ill"}'
)
HEAD = b'{"schema":"vrts.decisions/1","id":"huber","grader":"R. Huber"}'


@pytest.mark.parametrize(
    ("line", "told"),
    [
        (b"\xff\xfe", "line 2 is no decision"),
        (b"<<<<<<< HEAD", "line 2 is no decision"),
        (b"[" * 100_000, "line 2 is no decision"),
        (b'{"does":"steal","number":1}', "line 2 is no decision: invalid value 'steal'"),
        (GOOD.replace(b'"reason":"ill"', b'"reason":"ill","x":1'), "unknown field `x`"),
        (GOOD.replace(b"26T", b"99T"), "`at` is no time with an offset"),
        (GOOD.replace(b"+00:00", b""), "`at` is no time with an offset"),
        (GOOD.replace(b":1,", b":2,"), "line 2 has the number 2, and 1 is missing"),
        (GOOD + b"\n" + GOOD, "line 3 has the number 1, which was there before"),
        (GOOD.replace(b'["a"]', b"[]"), "`$.students`"),
        (GOOD.replace(b"ill", b"i" * LARGEST_LINE), "more than 1,000,000 bytes"),
        (
            GOOD.replace(b"excuse", b"change").replace(b'"reason"', b'"delta":"1/0","reason"'),
            "`1/0` is no number of points",
        ),
    ],
)
def test_hostile_lines_are_told(tmp_path: Path, line: bytes, told: str) -> None:
    (tmp_path / "huber.jsonl").write_bytes(HEAD + b"\n" + line + b"\n")
    add(tmp_path, Excuse(0, "", ("ben",), "ill"), who="Lang")
    found = read_decisions(tmp_path)
    assert found.wrong
    assert [one.rule.code for one in found.diagnostics] == ["V759"]
    assert told in found.diagnostics[0].headline
    assert "huber.jsonl" in found.diagnostics[0].headline
    assert "lang:1" in [one.name for one in found.records]  # the rest is there
    with pytest.raises(Refused):
        add(tmp_path, comment())  # nothing is added to a damaged file


def test_files_that_are_not_what_they_say(tmp_path: Path) -> None:
    add(tmp_path, comment())
    data = (tmp_path / "r-huber.jsonl").read_bytes()
    (tmp_path / "r-huber-2.jsonl").write_bytes(data)
    (tmp_path / "r-huber (1).jsonl").write_bytes(data)
    (tmp_path / "lang.jsonl").symlink_to(tmp_path / "r-huber.jsonl")
    found = read_decisions(tmp_path)
    assert [one.rule.code for one in found.diagnostics] == ["V759", "V845", "V845"]
    assert "`r-huber-2.jsonl` says that it is `r-huber.jsonl`" in found.diagnostics[0].headline


def test_another_grader_whose_id_would_be_the_same(tmp_path: Path) -> None:
    add(tmp_path, comment())
    assert add(tmp_path, comment(), who="R-Huber") == ("r-huber-2:1",)
    assert add(tmp_path, comment(), who="R. Huber") == ("r-huber:2",)
    assert msgspec.json.decode((tmp_path / "r-huber-2.jsonl").read_bytes().splitlines()[0]) == {
        "schema": "vrts.decisions/1",
        "id": "r-huber-2",
        "grader": "R-Huber",
    }


def test_files_that_lists_rest_on_may_only_grow(tmp_path: Path) -> None:
    add(tmp_path, comment("a"), comment("b"))
    add(tmp_path, comment("c"), who="A. Lang")
    path = tmp_path / "r-huber.jsonl"
    whole, before = path.read_bytes(), read_decisions(tmp_path).counts
    assert [(one.grader, one.lines) for one in before] == [("a-lang", 2), ("r-huber", 3)]
    add(tmp_path, comment("more"))
    assert not read_decisions(tmp_path, before).diagnostics
    path.write_bytes(whole.replace(b"\n", b"\r\n"))
    assert not read_decisions(tmp_path, before).diagnostics
    for data, told in (
        (whole.replace(b'"b"', b'"x"'), "has other ones"),
        (whole[: whole.index(b"\n", whole.index(b"\n") + 1) + 1], "has only 2 of them"),
        (None, "is not there"),
    ):
        path.unlink()
        if data is not None:
            path.write_bytes(data)
        assert not read_decisions(tmp_path).wrong
        [said] = read_decisions(tmp_path, before).diagnostics
        assert said.is_error
        assert f"rest on 3 lines of `r-huber.jsonl`, which {told}" in said.headline
        path.touch()
    assert read_decisions(tmp_path / "gone", before).wrong


def test_a_copy_beside_the_file_of_a_grader_is_an_error(tmp_path: Path) -> None:
    add(tmp_path, comment())
    (tmp_path / "r-huber (1).jsonl").write_bytes((tmp_path / "r-huber.jsonl").read_bytes())
    assert read_decisions(tmp_path).wrong
    (tmp_path / "r-huber (1).jsonl").rename(tmp_path / "notes.txt")
    assert not read_decisions(tmp_path).wrong


def test_nothing_above_the_total_is_written(tmp_path: Path) -> None:
    for said in (ChangeMark(0, "", ("anna",), "x", mark="75"), Item(0, "", "i", "x", "-11")):
        with pytest.raises(Refused) as problem:
            add_decisions(tmp_path, "R. Huber", (comment(), said), NOW, Fraction(10))
        assert "where marks are out of 10" in problem.value.diagnostics[0].headline
    assert not read_decisions(tmp_path).records
    add_decisions(tmp_path, "R. Huber", (ChangeMark(0, "", ("a",), "x", mark="75"),), NOW)
