"""A location put elsewhere by hand: only its numbers change, and they look as they did."""

import pytest

from vrts.lsp.answers.placing import CannotMove, datum_of, moved
from vrts.lsp.documents.documents import Document

TEXT = """.PROGRAM main()
 MOVE a
.END
.LOCATIONS
a         800.00  -450.00  -225.00    90.00    90.00     0.00
b 9.5 -450 1 90 90 0
c=1,2,3
d[2] 1E2 3 4 0 0 0
m 1 0 0 0 1 0 0 0 1 100 200 300
#p 0 -90 90 0 45 0
.END
"""
DOCUMENT = Document("/lab/a.v2", TEXT)


def line(name: str, at: tuple[float, float, float], subscripts: tuple[int, ...] = ()) -> str:
    """Return the line of a location after it was put elsewhere, once the rest is as it was."""
    found = moved(datum_of(DOCUMENT, name, subscripts), at)
    text = TEXT
    for change in reversed(found.changes):
        text = text[: change.start] + change.text + text[change.end :]
    rows = list(zip(TEXT.splitlines(), text.splitlines(), strict=True))
    assert [k for k, (a, b) in enumerate(rows, 1) if a != b] in ([found.line], [])
    return rows[found.line - 1][1]


@pytest.mark.parametrize(
    ("name", "at", "written"),
    [
        (
            "a",
            (1800, -450, -0.001),
            "a        1800.00  -450.00     0.00    90.00    90.00     0.00",
        ),
        ("a", (800, -450, -225), "a         800.00  -450.00  -225.00    90.00    90.00     0.00"),
        ("b", (10.25, -1450.04, 1), "b 10.2 -1450.0 1 90 90 0"),
        ("c", (100, 2, 3.1), "c=100.0,2,3.1"),
        ("m", (100, 200, 299.9), "m 1 0 0 0 1 0 0 0 1 100 200 299.9"),
    ],
)
def test_only_numbers_that_change_are_written_with_the_decimals_of_their_line(
    name: str, at: tuple[float, float, float], written: str
) -> None:
    assert line(name, at) == written


@pytest.mark.parametrize(
    ("name", "subscripts", "x", "why"),
    [
        ("d", (2,), 1.0, "line 8 is not written in plain numbers"),
        ("#p", (), 1.0, "`#p` has no X, Y and Z"),
        ("gone", (), 1.0, "no line of `a.v2` gives `gone` a value any more"),
        ("a", (), 1e7, "that is too far away for any arm"),
    ],
)
def test_what_cannot_be_written_is_told(
    name: str, subscripts: tuple[int, ...], x: float, why: str
) -> None:
    with pytest.raises(CannotMove, match=f"^{why}$"):
        moved(datum_of(DOCUMENT, name, subscripts), (x, 0.0, 0.0))
