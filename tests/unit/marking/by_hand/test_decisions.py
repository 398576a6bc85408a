"""What graders decide: a function of their files in whatever order, and all can be undone."""

import random

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.unit.marking.by_hand.support import AT, change, ledger, written
from vrts.marking.by_hand.decisions.counting import counted
from vrts.marking.by_hand.decisions.graders import grader_called
from vrts.marking.by_hand.decisions.ledger import ledger_of
from vrts.marking.by_hand.decisions.records import (
    Assign,
    ChangeMark,
    Comment,
    Decide,
    Decision,
    Excuse,
    Extend,
    Finish,
    Give,
    Item,
    Undo,
)
from vrts.marking.by_hand.decisions.state import NOTHING, State, state_of
from vrts.pipeline.refused import Refused

OLD, NEW = "a" * 64, "b" * 64


def decided(**files: tuple[Decision, ...]) -> State:
    """Return what is decided in files."""
    return state_of(ledger(**files))


def test_between_files_nothing_replaces_anything() -> None:
    state = decided(huber=(change("anna", delta="1"),), lang=(change("anna", delta="2"),))
    [conflict] = state.conflicts
    assert conflict.about == "mark"
    assert [one.name for one in conflict.sides] == ["huber:1", "lang:1"]
    assert state.of("anna").mark == ()
    assert state.of("anna").conflicts == (conflict,)
    assert "Huber (huber:1): +1 points" in conflict.sentence


def test_the_same_decision_of_two_graders_is_no_conflict() -> None:
    state = decided(huber=(change("anna", mark="14/2"),), lang=(change("anna", mark="7"),))
    assert not state.conflicts
    assert [one.name for one in state.of("anna").mark] == ["huber:1", "lang:1"]


def test_in_one_file_later_takes_the_place_of_earlier() -> None:
    state = decided(huber=(change("anna", "ben", delta="1"), Excuse(1, AT, ("anna",), "ill")))
    assert [one.name for one in state.of("anna").mark] == ["huber:2"]
    assert [one.name for one in state.of("ben").mark] == ["huber:1"]


def test_a_conflict_is_decided_and_the_decision_undone() -> None:
    two = {"huber": (change("anna", delta="1"),), "lang": (change("anna", delta="2"),)}
    settles = Decide(1, AT, "lang:1", ("huber:1",), "as agreed")
    assert [one.name for one in decided(**two, boss=(settles,)).of("anna").mark] == ["lang:1"]
    undone = decided(**two, boss=(settles, Undo(1, AT, ("boss:1",))))
    assert undone == decided(**two)
    other = Decide(1, AT, "huber:1", ("lang:1",), "no")
    assert decided(**two, boss=(settles,), dean=(other,)).of("anna").mark == ()
    again = {**two, "huber": (*two["huber"], change("anna", delta="3"))}  # what was decided is gone
    assert decided(**again, boss=(settles,)).of("anna").mark == ()


def test_marks_of_two_graders_that_differ_are_a_conflict() -> None:
    files = {"huber": (Finish(1, AT, "anna", "9"),), "lang": (Finish(1, AT, "anna", "17/2"),)}
    assert [one.about for one in decided(**files).of("anna").conflicts] == ["finish"]
    settles = Decide(1, AT, "huber:1", ("lang:1",), "both looked again")
    found = decided(**files, boss=(settles,)).of("anna")
    assert not found.conflicts
    assert found.preferred is not None
    assert [one.name for one in found.preferred] == ["huber:1", "boss:1"]
    agreed = {**files, "lang": (*files["lang"], Finish(1, AT, "anna", "9"))}
    assert not decided(**agreed).conflicts


def item(points: str, *after: str, title: str = "no comments") -> Item:
    """Return a version of a rubric item."""
    return Item(1, AT, "comments", title, points, after)


def test_an_item_changed_for_all_and_changed_apart() -> None:
    first = item("-1")
    changed = decided(huber=(first,), lang=(item("-2", "huber:1"),))
    assert changed.items["comments"].version == "lang:1"
    assert not changed.conflicts
    apart = {"huber": (first, item("-3")), "lang": (item("-2", "huber:1"),)}
    gives = (Give(1, AT, "comments", ("anna",)),)
    state = decided(**apart, rest=gives)
    assert state.items["comments"].differing
    assert state.items["comments"].points == 0
    assert [one.about for one in state.of("anna").conflicts] == ["item"]
    together = item("-2", "huber:2", "lang:1")
    assert decided(**apart, rest=(*gives, together)).items["comments"].version == "rest:2"
    undone = decided(huber=(first, item("-3"), Undo(1, AT, ("huber:2",))))
    assert undone.items["comments"].version == "huber:1"


def test_an_undone_version_still_tells_what_it_replaced() -> None:
    state = decided(
        huber=(item("-1"), Undo(1, AT, ("lang:1",))),
        lang=(item("-2", "huber:1"),),
        rest=(item("-3", "lang:1"),),
    )
    assert state.items["comments"].version == "rest:1"
    assert not state.conflicts


def test_what_is_about_another_program_lapses() -> None:
    about = {"anna": OLD}
    files = (
        Give(1, AT, "comments", ("anna",), programs=about),
        msgspec.structs.replace(change("anna", delta="1"), programs=about),
        Comment(1, AT, "anna", "why?", 3, program=OLD),
    )
    same = state_of(ledger(huber=(item("-1"), *files)), {"anna": OLD}).of("anna")
    assert not same.lapsed
    assert same.given
    assert same.mark
    assert same.comments
    other = state_of(ledger(huber=(item("-1"), *files)), {"anna": NEW}).of("anna")
    assert len(other.lapsed) == 3
    assert not (other.given)
    assert not (other.mark)
    assert not (other.comments)


def test_who_is_not_in_the_class_is_told() -> None:
    found = state_of(ledger(huber=(Give(1, AT, "x", ("anna", "zoe")),)), {"anna": "none"})
    assert [student for _, student in found.unknown] == ["zoe"]
    assert [one.name for one in found.without_item] == ["huber:1"]
    assert found.of("anna") == NOTHING


def test_undos_in_a_circle_have_no_effect() -> None:
    found = counted(
        ledger(
            huber=(Undo(1, AT, ("lang:1", "huber:2")), change("anna", delta="1")),
            lang=(Undo(1, AT, ("huber:1",)),),
        ).records
    )
    assert [one.name for one in found.counting] == ["huber:2"]
    assert found.circular == ("huber:1", "lang:1")


STUDENT = st.sampled_from("abc")
STUDENTS = st.lists(STUDENT, min_size=1, max_size=2, unique=True).map(tuple)
POINTS = st.sampled_from(["1", "-1/2", "2"])
NAMES = st.tuples(st.sampled_from(["huber", "lang", "mey"]), st.sampled_from("12345")).map(":".join)
SAME = {"number": st.just(1), "at": st.just(AT)}
WHY = st.just("ill")
DECISIONS: st.SearchStrategy[Decision] = st.one_of(
    st.builds(ChangeMark, **SAME, students=STUDENTS, reason=WHY, delta=POINTS),
    st.builds(Excuse, **SAME, students=STUDENTS, reason=WHY),
    st.builds(Extend, **SAME, students=STUDENTS, due=st.just(AT), reason=WHY),
    st.builds(Assign, **SAME, students=STUDENTS, graders=st.sampled_from([("huber",), ("lang",)])),
    st.builds(Finish, **SAME, student=STUDENT, mark=st.sampled_from(["7", "8"])),
    st.builds(Comment, **SAME, student=STUDENT, text=WHY),
    st.builds(
        Item,
        **SAME,
        id=st.just("x"),
        title=WHY,
        points=POINTS,
        after=st.lists(NAMES, max_size=2).map(tuple),
    ),
    st.builds(Give, **SAME, item=st.just("x"), students=STUDENTS),
    st.builds(
        Decide, **SAME, keep=NAMES, over=st.just(("huber:1", "lang:2", "mey:3")), reason=WHY
    ).filter(lambda one: one.keep not in one.over),
    st.builds(Undo, **SAME, records=st.lists(NAMES, min_size=1, max_size=3).map(tuple)),
)
FILES = st.fixed_dictionaries(
    {name: st.lists(DECISIONS, max_size=5).map(tuple) for name in ("huber", "lang", "mey")}
)


@given(FILES, st.randoms())
def test_the_state_does_not_depend_on_the_order_of_files(
    files: dict[str, tuple[Decision, ...]], order: random.Random
) -> None:
    data = [(f"{name}.jsonl", written(name, *said)) for name, said in files.items()]
    mixed = list(data)
    order.shuffle(mixed)
    assert ledger_of(dict(data)) == ledger_of(dict(mixed))
    renamed = {"huber": "zoe", "lang": "lang", "mey": "ann"}  # sorted otherwise
    other = decided(**_renamed(files, renamed))
    assert sorted(one.id for one in other.conflicts) == sorted(
        one.id for one in decided(**files).conflicts
    )


def _renamed(
    files: dict[str, tuple[Decision, ...]], names: dict[str, str]
) -> dict[str, tuple[Decision, ...]]:
    """Return files under other names of graders, with all that they name."""
    found: dict[str, tuple[Decision, ...]] = {}
    for grader, said in files.items():
        text = msgspec.json.encode(said).decode()
        for old, new in names.items():
            text = text.replace(f'"{old}:', f'"{new}:').replace(f'"{old}"', f'"{new}"')
        found[names[grader]] = msgspec.json.decode(text, type=tuple[Decision, ...])
    return found


@given(FILES)
def test_undoing_everything_is_to_decide_nothing(files: dict[str, tuple[Decision, ...]]) -> None:
    every = tuple(one.name for one in ledger(**files).records if not isinstance(one.said, Undo))
    last = (Undo(1, AT, every),) if every else ()
    assert state_of(ledger(**files, undoer=last)) == State()


@given(FILES)
def test_undoing_an_undo_brings_back_what_was(files: dict[str, tuple[Decision, ...]]) -> None:
    names = tuple(one.name for one in ledger(**files).records)
    if names:
        undone = (Undo(1, AT, names), Undo(1, AT, ("undoer:1",)))
        assert state_of(ledger(**files, undoer=undone)) == state_of(ledger(**files))


@pytest.mark.parametrize(
    ("name", "identifier"),
    [("R. Huber", "r-huber"), ("Åse Müller", "ase-muller"), ("王芳", "grader-"), ("CON", "con-")],
)
def test_ids_of_graders_are_safe(name: str, identifier: str) -> None:
    assert grader_called(name, {}).id.startswith(identifier)


def test_names_that_look_alike_have_ids_of_their_own() -> None:
    known = {"r-huber": "R. Huber"}
    assert grader_called("R. Huber", known).id == "r-huber"
    assert grader_called("R Huber", known).id == "r-huber-2"
    with pytest.raises(Refused):
        grader_called(" \n", known)
