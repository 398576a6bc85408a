"""Accounts follow the lists of a course: who is new, who is gone, who is called otherwise."""

import sqlite3
from collections.abc import Iterator
from pathlib import Path

import pytest

from vrts.course.people.class_list import read_class_list
from vrts.course.people.following import add_by_hand, follow
from vrts.course.people.listed import Listed
from vrts.live.store.accounts import ALL_ROOMS, account_of, add_account, log_in, who
from vrts.live.store.course.people import Person, people
from vrts.live.store.database import opened

ROOMS = {"Class": ("c1",), "Lab": ("l1", "l2")}
ANNA = Listed("moodle 7", "Anna Berg", "anna@example.org", {"moodle": "7"})
BEN = Listed("moodle 8", "Ben Otto", "ben@example.org", {"moodle": "8"})


@pytest.fixture
def connection(tmp_path: Path) -> Iterator[sqlite3.Connection]:
    found = opened(tmp_path / "live.sqlite")
    yield found
    found.close()


def of(connection: sqlite3.Connection, called: str) -> Person:
    return next(one for one in people(connection) if one.called == called)


def test_who_is_new_gets_an_account_and_who_is_gone_keeps_it_but_stays_outside(
    connection: sqlite3.Connection,
) -> None:
    first = follow(connection, (ANNA, BEN), ROOMS, 0.0)
    assert len(first.added) == 2
    assert follow(connection, (ANNA, BEN), ROOMS, 1.0) == ((), (), ())  # nothing is new
    ben = of(connection, "Ben Otto")
    cookie = log_in(connection, ben.account, 2.0)
    assert who(connection, cookie, 3.0) is not None
    assert follow(connection, (ANNA,), ROOMS, 4.0).gone == (ben.account,)
    assert who(connection, cookie, 5.0) is None
    assert not of(connection, "Ben Otto").listed
    assert follow(connection, (ANNA, BEN), ROOMS, 6.0).changed == (ben.account,)
    assert who(connection, cookie, 7.0) is not None  # the same account as before


def test_who_is_called_otherwise_keeps_the_account(connection: sqlite3.Connection) -> None:
    follow(connection, (ANNA,), ROOMS, 0.0)
    before = of(connection, "Anna Berg").account
    married = ANNA._replace(name="Anna Holm", email="holm@example.org")
    assert follow(connection, (married,), ROOMS, 1.0).changed == (before,)
    assert (of(connection, "Anna Holm").account, len(people(connection))) == (before, 1)
    assert account_of(connection, before) == (before, "Anna Holm", False, None, frozenset())


def test_a_list_with_ids_after_one_with_addresses_knows_everybody(
    connection: sqlite3.Connection,
) -> None:
    plain = ANNA._replace(key="anna@example.org", ids={})
    follow(connection, (plain,), ROOMS, 0.0)
    done = follow(connection, (ANNA,), ROOMS, 1.0)
    assert (done.added, done.gone, len(people(connection))) == ((), (), 1)
    # but an address that the platform has given to somebody else leads to no old account
    other = ANNA._replace(key="moodle 99", name="Other")
    done = follow(connection, (other,), ROOMS, 2.0)
    assert (len(done.added), len(done.gone)) == (1, 1)


def test_same_names_get_numbers_whoever_has_them(connection: sqlite3.Connection) -> None:
    add_account(connection, "Ben Otto", 0.0)  # a guest
    again = BEN._replace(key="moodle 9", email="otto@example.org", ids={})
    follow(connection, (BEN, again, BEN._replace(key="x 1", name="Admin", email="")), ROOMS, 0.0)
    assert sorted(one.name for one in people(connection)) == ["Admin 2", "Ben Otto 2", "Ben Otto 3"]


def test_rights_follow_the_rank(connection: sqlite3.Connection) -> None:
    lab = Listed("bo@example.org", "Bo", "bo@example.org", {}, "assistant", rooms=("Lab",))
    everywhere = Listed("cy@example.org", "Cy", "cy@example.org", {}, "assistant")
    teacher = Listed("ada@example.org", "Ada", "ada@example.org", {}, "teacher")
    follow(connection, (lab, everywhere, teacher, BEN), ROOMS, 0.0)

    def leads(called: str) -> str:
        account = account_of(connection, of(connection, called).account)
        assert account is not None
        asked = ("c1", "l1", "l2", "own")
        return "".join("+" if account.leads_in(room) else "-" for room in asked)

    assert [leads(name) for name in ("Bo", "Cy", "Ada", "Ben Otto")] == [
        "-++-",
        "++++",
        "++++",
        "----",
    ]
    follow(
        connection, (lab._replace(rank="student"), teacher._replace(rank="assistant")), ROOMS, 1.0
    )
    assert [leads(name) for name in ("Bo", "Ada")] == ["----", "++++"]
    ada = of(connection, "Ada").account
    assert account_of(connection, ada) == (ada, "Ada", False, None, frozenset({ALL_ROOMS}))


def test_who_was_added_in_the_page_stays_until_a_file_names_them(
    connection: sqlite3.Connection,
) -> None:
    guest = Listed("di@example.org", "Di", "di@example.org", {}, "teacher")
    follow(connection, (ANNA,), ROOMS, 0.0)
    di = add_by_hand(connection, guest, ROOMS, 0.0)
    with pytest.raises(ValueError, match="`Di` has this e-mail address already"):
        add_by_hand(connection, guest, ROOMS, 0.0)
    assert follow(connection, (ANNA,), ROOMS, 1.0).gone == ()
    assert follow(connection, (ANNA, guest), ROOMS, 2.0).added == ()
    assert follow(connection, (ANNA,), ROOMS, 3.0).gone == (di,)


MOODLE = """Identifier,Full name,Email address,Status,Grade
Participant 7,Anna Berg,anna@example.org,,
Participant 8,Ben Otto,Ben@example.org,,
"""
CANVAS = """Student,ID,SIS User ID,SIS Login ID,Section
"    Points Possible",,,,
"Berg, Anna",71,s71,anna@example.org,A
"""
PLAIN = "\ufeffName;E-Mail;Team\nAnna Berg;Anna@example.org;Red\nBen Otto;ben@example.org;\n"


def test_lists_of_moodle_and_canvas_and_plain_ones_are_read() -> None:
    found, faults = read_class_list(MOODLE.encode(), "m.csv")
    assert faults == ()
    assert [(one.key, one.name, one.email) for one in found] == [
        ("moodle 7", "Anna Berg", "anna@example.org"),
        ("moodle 8", "Ben Otto", "ben@example.org"),
    ]
    found, faults = read_class_list(CANVAS.encode(), "c.csv")
    assert faults == ()
    assert [(one.key, one.name, one.email) for one in found] == [
        ("canvas 71", "Anna Berg", "anna@example.org")
    ]
    found, faults = read_class_list(PLAIN.encode(), "p.csv")
    assert faults == ()
    assert [(one.key, one.name, one.team) for one in found] == [
        ("anna@example.org", "Anna Berg", "Red"),
        ("ben@example.org", "Ben Otto", ""),
    ]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "there is nobody in `p.csv`|`p.csv` is no list of a class"),
        ("name,email\n", "there is nobody in `p.csv`"),
        ("name,email\n,a@example.org\n", "this line has no name"),
        ("name,email\nAnna,nobody\n", "`nobody` is no e-mail address"),
        ("name,email\nAnna,\n", "`Anna` has neither e-mail address nor id"),
        ("name,mark\nAnna,3\n", "no column `name`, or neither"),
        ("\x00\x01\x02", "`p.csv` is no list of a class|there is nobody"),
    ],
)
def test_a_faulty_list_says_why(text: str, says: str) -> None:
    found, faults = read_class_list(text.encode(), "p.csv")
    words = "; ".join(one.headline for one in faults)
    assert any(part in words for part in says.split("|")), (found, words)


def test_a_long_list_is_followed_a_few_at_a_time(connection: sqlite3.Connection) -> None:
    everybody = [
        Listed(f"s{k}@example.org", "Anna Berg", f"s{k}@example.org", {}) for k in range(5)
    ]
    counts = [len(follow(connection, everybody, ROOMS, 0.0, 2).added) for _ in range(4)]
    assert counts == [2, 2, 1, 0]
    names = {one.name for one in people(connection)}
    assert names == {"Anna Berg", *(f"Anna Berg {k}" for k in range(2, 6))}
    assert follow(connection, everybody[:1], ROOMS, 0.0, 2).gone != ()
