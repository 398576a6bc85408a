"""Whose connection ends when all are taken."""

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
) -> Connected:
    browsers = frozenset((browser,)) if browser else frozenset[bytes]()
    return Connected(place, account, address, heard, keeps, browsers)


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
