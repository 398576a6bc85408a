"""Whose connection ends when all are taken."""

import pytest

from vrts.live.entrance.crowding import Connected, gives_way

HALL, HOME = "192.0.2.1", "198.51.100.7"


def row(
    place: str,
    account: int,
    address: str,
    heard: float,
    *,
    keeps: bool = False,
    browser: bytes = b"",
    since: float = 0.0,
) -> Connected:
    browsers = frozenset((browser,)) if browser else frozenset[bytes]()
    return Connected(place, account, address, heard, keeps, browsers, since)


def people(name: str, count: int, address: str, first: int, since: float) -> list[Connected]:
    """Return single connections of people who came one after another; `{}`: an address each."""
    return [
        row(f"{name}{n}", first + n, address.format(n), since, since=since + n)
        for n in range(count)
    ]


def test_who_has_many_gives_way_and_nobody_elsewhere() -> None:
    many = [row(f"m{n}", 1, HALL, 10.0 + n) for n in range(8)]
    others = [row(f"o{n}", 2 + n, HALL, 0.0) for n in range(4)]
    home = [row(f"h{n}", 20 + n, HOME, 0.0) for n in range(9)]
    assert gives_way([*home, *others, *many]) == "m0"


def test_among_single_connections_the_longest_silent_gives_way() -> None:
    rows = [row("boss", 1, HALL, 0.0, keeps=True), row("a", 2, HALL, 5.0), row("b", 3, HALL, 4.0)]
    assert gives_way(rows) == "b"


def test_many_accounts_of_one_browser_give_way_first() -> None:
    many = [row(f"m{n}", n, f"198.51.100.{n}", 10.0 + n, browser=b"one") for n in range(3)]
    others = [row(f"o{n}", 20 + n, HALL, 0.0, browser=bytes([n + 1])) for n in range(3)]
    assert gives_way([*others, *many], HOME) == "m0"


def test_who_comes_from_where_few_are_takes_a_place_from_where_most_are() -> None:
    flood = [row(f"a{n}", n, "203.0.113.1", 5.0 + n) for n in range(4)]
    other = [row(f"b{n}", 10 + n, "203.0.113.2", 5.0 + n) for n in range(4)]
    hall = [row("h", 20, HALL, 0.0)]
    assert gives_way([*flood, *other, *hall], HALL) == "a0"
    assert gives_way([*flood, *other, *hall], HOME) == "a0"
    assert gives_way([*flood[:1], *other[:1], *hall], HOME) is None, "all have one"


def test_where_no_address_has_more_than_half_nobody_gives_way() -> None:
    assert gives_way([row("a", 1, HALL, 0.0), row("b", 2, HOME, 0.0)]) is None
    assert gives_way([row("a", 1, HALL, 0.0, keeps=True)]) is None
    assert gives_way([]) is None


def test_a_hall_behind_one_address_stays_when_many_come_from_everywhere() -> None:
    hall = people("h", 300, HALL, 0, 0.0)
    flood = people("f", 700, "2001:db8:{}::/64", 1000, 1000.0)
    assert gives_way([*hall, *flood], "2001:db8:ffff::/64") is None
    seconds = [one._replace(place=f"{one.place}'") for one in hall[:30]]
    went = gives_way([*hall, *seconds, *flood[:670]], "2001:db8:ffff::/64")
    assert went is not None
    assert went.startswith("h"), "a second page is the last that goes, and nobody's only one"
    assert gives_way([*hall, *flood[:670]], "2001:db8:ffff::/64") is None


@pytest.mark.parametrize("comes_from", [HALL, HOME])
@pytest.mark.parametrize("first", ["hall", "flood"])
def test_a_flood_from_one_address_gives_way_before_second_pages(
    comes_from: str, first: str
) -> None:
    early, late = 0.0, 1000.0
    hall = people("h", 300, HALL, 0, early if first == "hall" else late)
    seconds = [one._replace(place=f"{one.place}'") for one in hall[:60]]
    flood = people("f", 400, "203.0.113.1", 1000, late if first == "hall" else early)
    others = people("o", 200, "198.51.100.{}", 2000, early)
    for rows in ([*hall, *flood], [*hall, *seconds, *flood, *others]):
        assert gives_way(rows, comes_from) == "f399", "the one that came last"


def test_a_hall_comes_in_though_two_addresses_have_all_places() -> None:
    here = [*people("a", 500, "203.0.113.1", 0, 0.0), *people("b", 500, "203.0.113.2", 600, 0.0)]
    for number in range(300):
        went = gives_way(here, HALL)
        assert went is not None
        assert went[0] in "ab"
        here = [one for one in here if one.place != went]
        here.append(row(f"h{number}", 2000 + number, HALL, 9.0, since=9.0 + number))
    assert len(here) == 1000


def test_who_came_first_stays_where_a_flood_comes_from_behind_the_same_address() -> None:
    here = [*people("h", 300, HALL, 0, 0.0), *people("f", 300, HALL, 1000, 1000.0)]
    assert gives_way(here, HALL) == "f299"
