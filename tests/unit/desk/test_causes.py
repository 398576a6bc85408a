"""Rows that lost the same points in the same way are one cause; names tell causes apart."""

from msgspec.structs import replace

from tests.support_desk import HITS, MISSES, SLOW
from tests.support_rows import plain_row
from vrts.desk.rows.causes import cause_key, causes_of, keys_of, weighed
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


def test_points_for_speed_that_others_took_along_come_last() -> None:
    """Whoever has any fault loses them: of all rows, and of no use to tell them apart."""
    for_speed = replace(SLOW, sentence="points for speed are given only when nothing else is wrong")
    along = (replace(for_speed, points=2.0), HITS)
    rows = [plain_row(name, losses=along) for name in "abc"]
    rows += [plain_row("d", losses=(MISSES,)), plain_row("e", losses=(SLOW,))]
    kinds = [(cause.kind, cause.count) for cause in causes_of(rows)]
    assert kinds == [("contact", 3), ("target", 1), ("time", 1), ("time", 3)]
    assert [loss.kind for loss in weighed(rows[0].result)] == ["contact", "time"]
