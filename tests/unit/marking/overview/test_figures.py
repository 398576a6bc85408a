"""What a class is like in numbers."""

from fractions import Fraction

from msgspec.structs import replace

from tests.support_rows import failed, plain_result, plain_row
from vrts.marking.overview.figures import failing, spread


def test_marks_are_counted_in_ten_bins_and_ten_counts_in_the_last() -> None:
    rows = [plain_row(mark=m) for m in (0.0, 0.9, 1.0, 9.0, 10.0)] + [plain_row(mark=None)]
    found = spread(rows)
    assert found is not None
    assert found.counts == (2, 1, 0, 0, 0, 0, 0, 0, 0, 2)
    assert (found.mean, found.median) == (Fraction(209, 50), 1)
    assert spread([plain_row(mark=None)]) is None


def test_the_check_that_fails_most_comes_first_with_what_it_costs_in_the_mean() -> None:
    result = plain_result()
    unreached = tuple(replace(c, answer="not reached", points=0.0) for c in result.checks)
    doubtful = tuple(
        replace(c, answer="undetermined") if c.id == "collision" else c for c in result.checks
    )
    rows = [
        plain_row("a"),
        plain_row("b", checks=failed(result, "target can1", "demand gentle")),
        plain_row("c", checks=failed(result, "target can1")),
        plain_row("d", checks=unreached),
        plain_row("e", checks=doubtful),
        plain_row("f", checks=()),
    ]
    by_title = {f.title: f for f in failing(rows)}
    assert list(by_title) == ["can1 on base2", "gentle", "can2 on base1", "no contact"]
    first = by_title["can1 on base2"]
    assert (first.asked, first.violated, first.not_reached) == (5, 2, 1)
    assert first.mean_lost == Fraction(9, 5)
    assert by_title["gentle"].hidden
    assert by_title["gentle"].mean_lost == Fraction(3, 10)
    assert by_title["no contact"].undetermined == 1
    assert failing([plain_row()]) == ()
