"""Rows that lost the same points in the same way are one cause; names tell causes apart."""

from msgspec.structs import replace

from tests.support_desk import HITS, MISSES
from tests.support_rows import plain_row
from vrts.desk.rows.causes import cause_key, causes_of, keys_of
from vrts.marking.result import Loss


def drop(height: str, where: str, points: str = "1") -> Loss:
    sentence = f"at 3.4 s, line 11 `OPEN`, `can1` is let go {height} mm above `{where}`"
    return Loss(float(points), points, "drop", sentence, None, 11, 3.4)


def test_when_where_and_how_much_do_not_tell_causes_apart() -> None:
    later = replace(drop("21", "base2"), sentence="line 9, `can1` is let go 4.5 mm above `base2`")
    assert cause_key(drop("19", "base2")) == cause_key(later)


def test_names_points_and_kinds_do() -> None:
    one = drop("19", "base2")
    others = (drop("19", "base1"), drop("19", "base2", "2"), replace(one, kind="contact"))
    assert cause_key(one) not in {cause_key(other) for other in others}


def test_causes_name_whom_they_cost_points_the_commonest_first() -> None:
    rows = [
        plain_row("a", losses=(HITS, MISSES)),
        plain_row("b", losses=(replace(HITS, time_s=1.0, line=3), HITS)),
        plain_row("c"),
    ]
    first, second = causes_of(rows)
    assert (first.students, first.count, first.points) == (("a", "b"), 2, 1.5)
    assert first.sentence == "the held `can1` hits `base1`"
    assert second.sentence == "`can2` is … mm from its goal"
    assert keys_of(rows[1].result) == (first.key,)
