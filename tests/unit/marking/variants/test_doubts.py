"""Whose variant a program is made for, as far as it tells."""

import pytest

from vrts.marking.intake.row import Platform, Row, Student
from vrts.marking.intake.tables.roster import Member as Listed
from vrts.marking.intake.tables.roster import Roster, read_roster
from vrts.marking.variants.class_list import class_list
from vrts.marking.variants.doubts import Other, other_variant
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

PLACES = {
    "bbbb-cccc": {"grip": (1.0, 0, 0, 0, 0, 0), "put": (2.0, 0, 0, 0, 0, 0)},
    "dddd-ffff": {"grip": (3.0, 0, 0, 0, 0, 0), "put": (2.0, 0, 0, 0, 0, 0)},
}


THEIRS = "its places are those of"


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
    assert other_variant(data, "bbbb-cccc", PLACES) == other


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
