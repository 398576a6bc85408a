"""Whose variant a program is made for, as far as it tells."""

import pytest

from vrts.marking.intake.row import Platform, Row, Student
from vrts.marking.intake.tables.roster import Member as Listed
from vrts.marking.intake.tables.roster import Roster, read_roster
from vrts.marking.variants.class_list import class_list
from vrts.marking.variants.doubts import THEIRS, Other, known, other_variant
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

PLACES = {
    "bbbb-cccc": {"grip": (1.0, 0, 0, 0, 0, 0), "put": (2.0, 0, 0, 0, 0, 0)},
    "dddd-ffff": {"grip": (3.0, 0, 0, 0, 0, 0), "put": (2.0, 0, 0, 0, 0, 0)},
}


def program(grip: float, put: float, comment: str = "") -> bytes:
    places = f"grip {grip} 0 0 0 0 0\nput {put} 0 0 0 0 0\nmine 7 0 0 0 0 0\n"
    return f"{comment}\n.PROGRAM main()\n.END\n.LOCATIONS\n{places}.END\n".encode()


@pytest.mark.parametrize(
    ("data", "other"),
    [
        (program(1, 2), None),
        (program(1, 2, "; variant bbbb-cccc"), None),
        (program(3, 2), Other("dddd-ffff", "its places are those of")),
        (program(3, 2.5), None),  # nobody's: taught by hand
        (program(1, 2, "; Variant DDDD-FFFF of mine"), Other("dddd-ffff", "it names")),
        (program(1, 2, "x = 1 ; variant gggg-hhhh"), Other("gggg-hhhh", "it names")),
        (program(1, 2, 'TYPE "variant dddd-ffff"'), None),  # no comment
        (program(3, 2.5).replace(b"grip", b"my_own"), None),  # it has a place of its own
        (program(3, 2).replace(b"grip", b"a").replace(b"put", b"b"), None),  # one is the own, too
        (program(3, 4).replace(b"grip", b"a").replace(b"put", b"b"), Other("dddd-ffff", THEIRS)),
        (b"", None),
        (b"\xff\x00;variant", None),
    ],
)
def test_a_program_tells_whose_variant_it_is(data: bytes, other: Other | None) -> None:
    assert other_variant(data, "bbbb-cccc", known(PLACES)) == other


MANY = {  # of each: two cans, a base that may be the same, and what all have
    f"bbbb-{tag}": {
        "can1": (x, 1.0, 0, 0, 0, 0),
        "can2": (x, 2.0, 0, 0, 0, 0),
        "base": (base, 3.0, 0, 0, 0, 0),
        "safe": (0.0, 0, 9, 0, 0, 0),
    }
    for tag, x, base in (("bbbb", 1.0, 1.0), ("cccc", 2.0, 2.0), ("dddd", 3.0, 2.0))
}


def with_places(names: tuple[str, ...], values: tuple[tuple[float, float], ...]) -> bytes:
    lines = (f"{name} {x} {y} 0 0 0 0\n" for name, (x, y) in zip(names, values, strict=False))
    return f".PROGRAM m()\n.END\n.LOCATIONS\n{''.join(lines)}safe 0 0 8 0 0 0\n.END\n".encode()


@pytest.mark.parametrize(
    ("values", "other"),
    [
        (((2, 1), (2, 2), (2, 3)), Other("bbbb-cccc", "3 of its places are those of")),
        (((1, 1), (3, 2), (2, 3)), Other("bbbb-dddd", "2 of its places are those of")),
        (((2, 1), (2, 2), (7, 7)), Other("bbbb-cccc", "2 of its places are those of")),
        (((1, 1), (1, 2), (2, 3)), None),  # most are its own
        (((1, 1), (1, 2), (2, 1), (2, 2)), None),  # as many
        (((7, 1), (7, 2)), None),
    ],
)
def test_another_place_of_ones_own_hides_no_copy(
    values: tuple[tuple[float, float], ...], other: Other | None
) -> None:
    """`safe` is the student's own everywhere: a single such place hid all the others."""
    for names in (("a", "b", "c", "d"), ("can1", "can2", "base", "d")):
        program = with_places(names, values)
        assert other_variant(program, "bbbb-bbbb", known(MANY)) == other


def listed(number: str, email: str = "", login: str = "") -> Listed:
    return Listed(Student(f"N {number}", email, login), None)


def row(identifier: str, email: str = "", **ids: str) -> Row:
    return Row(identifier, Student("", email, ids=ids), "a.v2", "")


def test_a_hand_in_is_matched_by_the_platforms_id_else_by_what_only_one_has() -> None:
    members = {
        "1": listed("1", "A@b.c"),
        "2": listed("2", "two@b.c", "x"),
        "3": listed("3", "", "x"),
    }
    found = class_list(Roster(Platform.MOODLE, members, ()), "grades.csv")
    first, second, third = found.members
    assert [m.drawn_by for m in found.members] == ["a@b.c", "two@b.c", "moodle 3"]
    assert found.member_of(row("any", moodle="2")) == second
    assert found.member_of(row("1", moodle="9")) is None  # the id decides
    assert found.member_of(row("3")) == third
    assert found.member_of(row("mailed", "a@B.C")) == first
    assert found.member_of(row("x")) is None  # two of them
    assert found.member_of(row("nobody")) is None


def test_two_with_one_address_are_refused() -> None:
    members = {"1": listed("1", "a@b.c"), "2": listed("2", "A@b.c ")}
    with pytest.raises(Refused) as refused:
        class_list(Roster(Platform.MOODLE, members, ()), "grades.csv")
    assert "`a@b.c` more than once" in refused.value.diagnostics[0].headline
    with pytest.raises(CannotRead, match="nobody is in"):
        class_list(Roster(Platform.CANVAS, {}, ()), "grades.csv")


def test_a_variant_is_drawn_by_the_same_whether_work_came_or_not() -> None:
    head = "Identifier,Full name,Email address,Status\n"
    before = read_roster(f"{head}Participant 7,Ada,ada@b.c,No submission\n".encode(), "g", None)
    after = read_roster(f"{head}Participant 7,Ada B.,Ada@b.c,Submitted\n".encode(), "g", None)
    drawn_by = [class_list(one, "g").members[0].drawn_by for one in (before, after)]
    assert drawn_by == ["ada@b.c", "ada@b.c"]
