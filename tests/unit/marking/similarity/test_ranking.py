"""What ranks first, what ranks low, and what counts nothing."""

import json

import jsonschema
import pytest

from tests.unit.marking.similarity.support import EXAMPLES, ORIGINAL, disguised, independent
from vrts.marking.schemas import schema
from vrts.marking.similarity.ranking import LEAST_SCORE, Pair, Ranking, similarity, to_bytes


def the_class(**more: str) -> dict[str, bytes]:
    """Return independent programs, the original, and more."""
    texts = {name: text.encode() for name, text in more.items()}
    return {**independent(), "anna": ORIGINAL.encode(), **texts}


def between(ranking: Ranking, *names: str) -> Pair | None:
    """Return the pair of two programs."""
    return next((p for p in ranking.pairs if {p.first, p.second} == set(names)), None)


def test_a_copy_in_disguise_ranks_first_and_far_above_the_rest() -> None:
    found = similarity(the_class(ben=disguised()))
    first, *rest = found.pairs
    assert {first.first, first.second} == {"anna", "ben"}
    assert first.code > 0.9
    assert all(pair.score < 0.4 for pair in rest)
    lines = sum(r.first_end - r.first_start + 1 for r in first.regions)
    assert lines >= 34


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("height", "h"),
        ("120", "97"),
        ("\n", "\n; a remark\n\n"),
        ("MOVES", "moves"),
        ("\n        ", "\n   10   "),
    ],
    ids=["names", "numbers", "comments", "case", "labels"],
)
def test_each_disguise_alone_changes_nothing(old: str, new: str) -> None:
    changed = ORIGINAL.replace(old, new)
    assert changed != ORIGINAL
    pair = between(similarity(the_class(ben=changed)), "anna", "ben")
    same = between(similarity(the_class(ben=ORIGINAL)), "anna", "ben")
    assert pair is not None
    assert same is not None
    assert pair.code == same.code


def test_solutions_of_different_tasks_are_hardly_alike() -> None:
    solutions = similarity(independent())
    assert all(pair.score < 0.4 for pair in solutions.pairs)
    alone = similarity(the_class())
    assert not [p for p in alone.pairs if "anna" in (p.first, p.second) and p.score > 0.15]


def test_what_everybody_was_given_counts_nothing() -> None:
    programs = {name: ORIGINAL.encode() for name in ("anna", "ben", "cara")}
    assert similarity(programs).pairs
    assert similarity(programs, [ORIGINAL.encode()]).pairs == ()
    renamed = ORIGINAL.replace("height", "h").encode()
    assert similarity(programs, [renamed]).pairs == ()


def test_what_the_whole_class_has_counts_nothing() -> None:
    programs = {f"s{k:02d}": ORIGINAL.encode() for k in range(40)}
    assert similarity(programs).pairs == ()


def test_those_who_handed_in_together_are_not_compared() -> None:
    programs = the_class(ben=ORIGINAL, cara=ORIGINAL)
    groups = {"anna": "group 4", "ben": "group 4", "cara": ""}
    found = similarity(programs, groups=groups)
    assert between(found, "anna", "ben") is None
    assert between(found, "anna", "cara") is not None
    assert between(similarity(programs, groups={"anna": "", "ben": ""}), "anna", "ben") is not None


def test_identical_taught_values_are_found_under_any_name() -> None:
    place = "corner 612.34 -71.15 -203.4 90 90 0\n.END\n"
    joints = "  MOVE #PPOINT(10.5,-91.25,88,0,12,3)\n"
    one = f".PROGRAM a\n  MOVE corner\n{joints}.END\n.LOCATIONS\n{place}"
    two = f".PROGRAM b\n{joints}  CALL x\n.END\n.LOCATIONS\n{place.replace('corner', 'q')}"
    found = similarity({**independent(), "anna": one.encode(), "ben": two.encode()})
    pair = between(found, "anna", "ben")
    assert pair is not None
    assert pair is found.pairs[0]
    assert [value.numbers for value in pair.values] == [
        (10.5, -91.25, 88.0, 0.0, 12.0, 3.0),
        (612.34, -71.15, -203.4, 90.0, 90.0, 0.0),
    ]
    assert (pair.values[1].first, pair.values[1].first_line) == ("corner", 6)
    assert (pair.values[1].second, pair.values[1].others) == ("q", 0)
    given = [f".LOCATIONS\n{place}".encode()]
    left = between(similarity({"anna": one.encode(), "ben": two.encode()}, given), "anna", "ben")
    assert left is not None
    assert len(left.values) == 1


def test_regions_are_lines_that_are_the_same() -> None:
    late = "\n".join(["; moved down"] * 10) + "\n" + ORIGINAL
    pair = between(similarity(the_class(ben=late)), "anna", "ben")
    assert pair is not None
    assert {(r.second_start - r.first_start, r.second_end - r.first_end) for r in pair.regions} == {
        (10, 10)
    }


def test_odd_files_are_left_out_or_compared_as_text() -> None:
    broken = b"\n".join(b"}{ %s IF ( MOVE MOVE, %% [" % word for word in (b"a", b"b", b"c", b"d"))
    programs = {"a": b"\x00\x01\x02", "b": b"", "c": broken, "d": broken, "e": b"%PDF-1.4"}
    found = similarity(programs)
    assert found.compared == 2
    assert [(p.first, p.second) for p in found.pairs] == [("c", "d")]
    assert similarity({}).pairs == ()


@pytest.mark.thorough
def test_a_long_program_that_repeats_itself_ends_soon() -> None:
    text = ".PROGRAM a\n" + " MOVE b\n APPRO c, 10\n DELAY 1\n" * 20_000 + ".END\n"
    found = similarity({"a": text.encode(), "b": text.encode()})
    assert found.pairs[0].regions


def test_no_pair_is_below_the_least_score_and_order_says_most_first() -> None:
    folder = EXAMPLES / "01-cans-on-bases" / "submissions"
    found = similarity({path.stem: path.read_bytes() for path in folder.iterdir()})
    scores = [pair.score for pair in found.pairs]
    assert scores == sorted(scores, reverse=True)
    assert min(scores) >= round(LEAST_SCORE, 3)


def test_the_json_says_that_it_is_no_verdict() -> None:
    data = json.loads(to_bytes(similarity(the_class(ben=ORIGINAL))))
    jsonschema.validate(data, schema("similarity"))
    jsonschema.Draft202012Validator.check_schema(schema("similarity"))
    assert "no verdict" in data["note"]
    assert data["schema"] == "vrts.similarity/2"
    assert data["pairs"][0]["first"] == "anna"


def test_programs_that_are_the_same_are_said_to_be_the_same() -> None:
    for number in (2, 11):
        same = {f"copy{n}": ORIGINAL for n in range(number)}
        ranking = similarity(the_class(**same))
        found = between(ranking, "copy0", "copy1")
        assert found is not None
        assert found.score == found.code == 1.0
