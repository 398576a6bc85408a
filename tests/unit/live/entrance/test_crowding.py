"""Whose connection ends when all are taken."""

from vrts.live.entrance.crowding import Connected, gives_way

HALL, HOME = "192.0.2.1", "198.51.100.7"


def row(place: str, account: int, address: str, heard: float, *, keeps: bool = False) -> Connected:
    return Connected(place, account, address, heard, keeps)


def test_who_has_many_gives_way_and_nobody_elsewhere() -> None:
    many = [row(f"m{n}", 1, HALL, 10.0 + n) for n in range(8)]
    others = [row(f"o{n}", 2 + n, HALL, 0.0) for n in range(4)]
    home = [row(f"h{n}", 20 + n, HOME, 0.0) for n in range(9)]
    assert gives_way([*home, *others, *many]) == "m0"


def test_among_single_connections_the_longest_silent_gives_way() -> None:
    rows = [row("boss", 1, HALL, 0.0, keeps=True), row("a", 2, HALL, 5.0), row("b", 3, HALL, 4.0)]
    assert gives_way(rows) == "b"


def test_where_no_address_has_more_than_half_nobody_gives_way() -> None:
    assert gives_way([row("a", 1, HALL, 0.0), row("b", 2, HOME, 0.0)]) is None
    assert gives_way([row("a", 1, HALL, 0.0, keeps=True)]) is None
    assert gives_way([]) is None
