"""Where a released object comes to rest, past what it touches at its side."""

import pytest

from vrts.base.pose import IDENTITY, translation
from vrts.engine.hand import settle as settling
from vrts.engine.hand.resting import Standing
from vrts.engine.hand.settle import settle
from vrts.geometry.proving.scalar import Proven, nearest
from vrts.geometry.shapes import Box, Cylinder, Piece

CAN = (Piece(Cylinder(0.03, 0.05), IDENTITY),)
TABLE = Standing("table", (Piece(Box((0.5, 0.5, 0.02)), IDENTITY),), translation(0, 0, -0.02))
EDGE = Standing("edge", (Piece(Box((0.05, 0.05, 0.01)), IDENTITY),), translation(0.05, 0, 0.09))


def wall(gap: float) -> Standing:
    """A wall beside the can, higher than where it is let go."""
    return Standing(
        "wall", (Piece(Box((0.05, 0.05, 0.2)), IDENTITY),), translation(0.08 + gap, 0, 0.2)
    )


@pytest.mark.parametrize("gap", [1e-3, 1e-6, 0.0, -1e-6, -1e-4, -1e-2])
def test_it_falls_past_a_wall_in_a_few_steps(gap: float, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[Proven] = []

    def counted(*question: object) -> Proven:
        asked.append(nearest(*question))  # type: ignore[arg-type]
        return asked[-1]

    monkeypatch.setattr(settling, "nearest", counted)
    rest = settle(CAN, translation(0, 0, 0.25), (0, 0, 0), [TABLE, wall(gap)])
    assert rest is not None
    assert (rest.support, rest.stands) == ("table", True)
    assert rest.height_m == pytest.approx(0.2, abs=1e-6)
    assert len(asked) < 10


def test_it_is_caught_by_an_edge_on_its_way() -> None:
    rest = settle(CAN, translation(0, 0, 0.25), (0, 0, 0), [TABLE, EDGE])
    assert rest is not None
    assert rest.support == "edge"
    assert rest.height_m == pytest.approx(0.1, abs=1e-6)


def test_nothing_below_carries_it() -> None:
    assert settle(CAN, translation(0, 0, 0.25), (0, 0, 0), [wall(-1e-4)]) is None


def test_what_overlaps_as_deep_to_the_side_as_upward_falls_past() -> None:
    block = Standing("block", (Piece(Box((0.05, 0.05, 0.06)), IDENTITY),), translation(0, 0, 0.06))
    rest = settle(CAN, translation(0, 0, 0.09), (0, 0, 0), [TABLE, block])  # 80 mm either way
    assert rest is not None
    assert rest.support == "table"
    rest = settle(CAN, translation(0, 0, 0.0901), (0, 0, 0), [TABLE, block])
    assert rest is not None
    assert (rest.support, rest.height_m) == ("block", 0.0)
