"""Groups: who is in them, how strong they are said to be, and who is never compared."""

import random
from typing import Any

import numpy as np
import pytest

from vrts.marking.similarity.features.extract import Program
from vrts.marking.similarity.groups import Evidence
from vrts.marking.similarity.likeness import Likeness, likeness
from vrts.marking.similarity.weighing.grouping import groups_of

SAFE = ("home", "mitte", "park", "wait")


def program(seed: int) -> str:
    """Return a program of somebody who has their own ideas of heights, speeds and order."""
    draw = random.Random(seed)
    lines = [f"SPEED {draw.randrange(20, 100, 5)} ALWAYS", "OPENI"]
    for k in draw.sample(range(1, 7), 6):
        high, deep = draw.randrange(60, 220, 5), draw.randrange(60, 220, 5)
        lines += [
            f"{draw.choice(('APPRO', 'APPROS'))} p{k}, {high}",
            *draw.choice((["BREAK"], [f"SPEED {draw.randrange(5, 60)}"], [])),
            f"{draw.choice(('MOVES', 'MOVE'))} p{k}",
            draw.choice(("CLOSEI", "OPENI", f"DELAY 0.{draw.randrange(1, 9)}", "SIGNAL 2")),
            f"{draw.choice(('DEPART', 'DEPARTS'))} {deep}",
        ]
    places = [
        f"p{k} {draw.uniform(500, 900):.2f} {draw.uniform(-400, 400):.2f} -200 90 90 0"
        for k in range(1, 7)
    ]
    body = "\n".join(f"  {line}" for line in lines)
    data = "\n".join(places)
    return f".PROGRAM main()\n{body}\n.END\n.LOCATIONS\n{data}\n.END\n"


def copy_of(seed: int) -> str:
    """Return the same in disguise: other names, two programs, filler, values moved."""
    text = program(seed)
    for k in range(1, 7):
        text = text.replace(f"p{k}", f"spot.{k * 7}")
    head, _, data = text.partition(".LOCATIONS")
    lines = head.strip().split("\n")[1:-1]
    first, second = lines[:9], lines[9:]
    filled = [more for line in first for more in (line, "  count = 3")]
    moved = data.replace(" -200 90", " -198.5 90")
    parts = [".PROGRAM rest()", *second, ".END", ".PROGRAM main()", *filled, "  CALL rest", ".END"]
    return "\n".join(parts) + f"\n.LOCATIONS{moved}"


def of_class(count: int = 40, copies: int = 0) -> dict[str, Program]:
    """Return a class, with copies of the first."""
    found = {f"s{k:02d}": Program(program(k).encode()) for k in range(count)}
    copied = {f"copy{k:02d}": Program(copy_of(k).encode()) for k in range(copies)}
    return {**found, **copied}


@pytest.fixture(scope="module")
def found() -> Likeness:
    return likeness(of_class(28, 2), jobs=1)


def test_copies_in_disguise_are_the_first_groups_and_strong(found: Likeness) -> None:
    first = [(group.members, group.strength) for group in found.groups[:2]]
    assert sorted(first) == [(("copy00", "s00"), "strong"), (("copy01", "s01"), "strong")]


def test_the_evidence_says_where_it_stands_the_rarest_first(found: Likeness) -> None:
    evidence = found.groups[0].evidence
    assert evidence
    assert [one.weight for one in evidence] == sorted((e.weight for e in evidence), reverse=True)
    assert any(one.first_line and one.second_line and one.others == 0 for one in evidence)


def test_a_class_without_copies_has_no_strong_group() -> None:
    assert [
        g.members for g in likeness(of_class(28), jobs=1).groups if g.strength == "strong"
    ] == []


def test_programs_of_another_folder_are_named_by_it() -> None:
    corpus = {"2025": {"zoe": Program(copy_of(3).encode()), "max": Program(program(90).encode())}}
    found = likeness(of_class(20), corpora=corpus, jobs=1)
    assert found.groups[0].members == ("s03", "2025/zoe")
    assert found.groups[0].links[0].second == "2025/zoe"


def test_those_who_handed_in_together_are_not_compared() -> None:
    alone = likeness(of_class(10, 1), jobs=1)
    assert any({"s00", "copy00"} <= {*group.members} for group in alone.groups)
    found = likeness(of_class(10, 1), (), {"s00": "g1", "copy00": "g1", "s01": ""}, jobs=1)
    assert not any({"s00", "copy00"} <= {*group.members} for group in found.groups)


def test_files_that_are_the_same_are_told_however_many_copied() -> None:
    same = {f"t{k}": Program(program(37).encode()) for k in range(5)}
    found = likeness({**of_class(24), **same}, jobs=1)
    assert found.groups[0].strength == "strong"
    assert {*same} <= {*found.groups[0].members}


def test_what_everybody_was_given_is_no_evidence() -> None:
    text = program(5).encode()
    programs = {name: Program(text) for name in ("a", "b", "c")}
    assert likeness(programs, jobs=1).groups[0].strength == "strong"
    given = likeness(programs, [text], jobs=1)
    assert not any(group.strength == "strong" for group in given.groups)


def test_nothing_to_compare_is_no_group() -> None:
    assert likeness({}, jobs=1).groups == ()
    assert likeness({"a": Program(b"")}, jobs=1).groups == ()
    assert likeness({"a": Program(b"\0"), "b": Program(b"\0")}, jobs=1).groups == ()


def test_a_chain_is_no_group() -> None:
    surprise = np.zeros((4, 4))
    surprise[0, 1] = surprise[1, 2] = surprise[2, 3] = 20.0  # nothing between 0 and 2, 1 and 3
    expected = np.where(surprise > 0, 0.001, 1e9)
    groups = groups_of(surprise, expected, np.triu(np.ones((4, 4), dtype=np.bool_), 1), 20.0)
    assert sorted(group.members for group in groups) == [(0, 1), (2, 3)]
    surprise[:] = np.triu(np.full((4, 4), 20.0), 1)
    expected = np.where(surprise > 0, 0.001, 1e9)
    groups = groups_of(surprise, expected, np.triu(np.ones((4, 4), dtype=np.bool_), 1), 20.0)
    assert [group.members for group in groups] == [(0, 1, 2, 3)]


def test_a_large_group_tells_the_best_link_of_each_and_evidence_when_asked(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    asked: list[object] = []

    def counted(*words: object) -> tuple[Evidence, ...]:
        asked.append(words)
        return ()

    monkeypatch.setattr("vrts.marking.similarity.likeness.evidence_of", counted)
    monkeypatch.setattr("vrts.marking.similarity.likeness.MOST_LINKS", 2)
    same = {f"t{k}": Program(program(37).encode()) for k in range(5)}
    found = likeness({**of_class(24), **same}, jobs=1)
    group = found.groups[0]
    assert {*group.members} == {name for one in group.links for name in (one.first, one.second)}
    assert len(asked) == len(found.groups)
    found.evidence(group.links[1].first, group.links[1].second)
    assert len(asked) == len(found.groups) + 1


def test_two_clusters_that_do_not_hang_together_are_tried_once() -> None:
    asked = 0

    class Counted(np.ndarray[Any, Any]):
        def __getitem__(self, place: Any) -> Any:
            nonlocal asked
            asked += 1
            return super().__getitem__(place)

    surprise = np.triu(np.full((60, 60), 1.0), 1)  # two sets of 30, hardly linked to each other
    surprise[:30, :30] = surprise[30:, 30:] = np.triu(np.full((30, 30), 20.0), 1)
    compared = np.triu(np.ones((60, 60), dtype=np.bool_), 1)
    expected = np.where(surprise > 0, 0.001, 1e9)
    groups = groups_of(surprise.view(Counted), expected, compared, 20.0)
    assert [len(group.members) for group in groups] == [30, 30]
    assert asked < 10_000
