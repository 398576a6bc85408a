"""Likeness of every version of marking is shown; what is none of them is told."""

import json

import pytest

from vrts.desk.book.likeness import read_likeness
from vrts.marking.result import Damaged


def test_pairs_of_an_earlier_vrts_hang_together() -> None:
    pairs = [
        {"first": "a", "second": "b", "score": 0.9},
        {"first": "c", "second": "b", "score": 0.4},
        {"first": "d", "second": "e", "score": 0.2},
    ]
    found = read_likeness(json.dumps({"pairs": pairs}).encode())
    assert found["a"].group == found["b"].group == found["c"].group != found["d"].group
    assert (found["b"].with_, found["b"].score, found["b"].strength) == (("a", "c"), 0.9, "strong")
    assert (found["c"].strength, found["d"].strength) == ("clear", "weak")


def test_groups_say_how_strong_they_are() -> None:
    groups = [
        {"members": ["a", "b", "2025/x"], "score": 7.5, "strength": "strong", "links": []},
        {"members": ["c", "a"], "score": 2.0, "strength": "weak", "links": []},
    ]
    pair = {"first": "p", "second": "q", "score": 0.9}
    found = read_likeness(json.dumps({"pairs": [pair], "groups": groups}).encode())
    assert sorted(found) == ["2025/x", "a", "b", "c"]
    assert (found["a"].with_, found["a"].strength) == (("b", "2025/x"), "strong")
    assert found["c"].group != found["a"].group


def test_a_member_is_as_strong_as_its_own_best_link() -> None:
    links = [
        {"first": "a", "second": "b", "score": 0.99, "strength": "strong"},
        {"first": "a", "second": "c", "score": 0.4, "strength": "worth a look"},
        {"first": "b", "second": "c", "score": 0.1, "strength": "weak"},
    ]
    group = {"members": ["a", "b", "c"], "score": 0.99, "strength": "strong", "links": links}
    found = read_likeness(json.dumps({"groups": [group]}).encode())
    assert [found[k].strength for k in "abc"] == ["strong", "strong", "worth a look"]
    assert (found["c"].score, found["c"].with_) == (0.4, ("a", "b"))


@pytest.mark.parametrize(
    "text", ["[]", "{", "{}", '{"pairs": [1]}', '{"groups": [{"members": 3}]}']
)
def test_anything_else_is_told(text: str) -> None:
    with pytest.raises(Damaged):
        read_likeness(text.encode())
