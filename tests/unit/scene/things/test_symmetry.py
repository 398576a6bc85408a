"""Symmetries of things, against points that are inside before and after a turn, or are not."""

import math
from random import Random

import pytest

from vrts.base.pose import (
    IDENTITY,
    Pose,
    Rotation,
    Vector,
    multiply,
    rotation_about,
    rotation_angle,
    translation,
)
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece
from vrts.geometry.support import bounds
from vrts.scene.things.forms import dish, stand, table, upright_box, upright_cylinder
from vrts.scene.things.oven import Oven, oven
from vrts.scene.things.pizza import pizza
from vrts.scene.things.symmetry import SAME, SAME_TURN, Symmetries, symmetries

GREY, RED = (0.5, 0.5, 0.5), (1.0, 0.0, 0.0)


def found_of(*pieces: Piece, axis: Vector | None = None) -> Symmetries:
    return symmetries(pieces, (GREY,) * len(pieces), axis)


def inside(piece: Piece, point: Vector) -> float:
    """Return how deep a point is in a piece [m]; negative outside. Boxes and cylinders only."""
    x, y, z = piece.X_OP.inverse().apply(point)
    match piece.shape:
        case Box(half_extents=(a, b, c)):
            return min(a - abs(x), b - abs(y), c - abs(z))
        case Cylinder(radius=radius, half_length=half_length):
            return min(radius - math.hypot(x, y), half_length - abs(z))
        case Hull():
            raise AssertionError


def changes(pieces: tuple[Piece, ...], turn: Pose, chance: Random) -> bool:
    """Return whether some point is clearly inside before a turn and clearly outside after it."""
    back = turn.inverse()
    size = 0.16
    for _ in range(2000):
        x, y, z = (chance.uniform(-size, size) for _ in range(3))
        before = max(inside(piece, (x, y, z)) for piece in pieces)
        after = max(inside(piece, back.apply((x, y, z))) for piece in pieces)
        if before * after < 0.0 and min(abs(before), abs(after)) > 2 * SAME:
            return True
    return False


def quarter_turns() -> list[Rotation]:
    """Return the 24 turns of a cube."""
    steps = [rotation_about(axis, math.pi / 2) for axis in ((1.0, 0.0, 0.0), (0.0, 0.0, 1.0))]
    known = [IDENTITY.rotation]
    for turn in known:
        for step in steps:
            new = multiply(step, turn)
            if all(rotation_angle(new, other) > 0.1 for other in known):
                known.append(new)
    return known


def test_what_is_inside_something_is_not_seen() -> None:
    block = Piece(Box((0.03, 0.03, 0.02)), IDENTITY)
    pin = Piece(Cylinder(0.005, 0.01), translation(0.01, 0.015, 0.0))
    assert found_of(block, pin) == found_of(block)
    can = upright_cylinder(0.03, 0.1).pieces[0]
    assert found_of(can, Piece(Box((0.01, 0.02, 0.01)), can.X_OP)) == found_of(can)
    assert found_of(block, block) == found_of(block)
    assert len(found_of(block, pin._replace(shape=Cylinder(0.005, 0.03))).turns) == 1


def middle_of(pieces: tuple[Piece, ...]) -> Vector:
    """Return the middle of the box round a thing, which every turn of a cube keeps in its place."""
    box = bounds(pieces, IDENTITY)
    x, y, z = ((low + high) / 2 for low, high in zip(box.lower, box.upper, strict=True))
    return (x, y, z)


def built(chance: Random) -> tuple[Piece, ...]:
    """Return a thing of blocks and pins, often symmetric."""
    size = (0.02, 0.03, 0.04)
    blocks = [Box((chance.choice(size), chance.choice(size), chance.choice(size)))]
    pieces = [Piece(blocks[0], IDENTITY)]
    for _ in range(chance.randrange(3)):
        x, y, z = (chance.choice((0.0, 0.09)) for _ in range(3))
        shape = (
            Cylinder(0.02, chance.choice(size))
            if chance.random() < 0.4
            else Box((0.02, 0.02, 0.02))
        )
        pieces.append(Piece(shape, translation(x, y, z)))
        if chance.random() < 0.7:
            pieces.append(Piece(shape, translation(-x, -y, chance.choice((z, -z)))))
    return tuple(pieces)


@pytest.mark.parametrize(
    "seed", [*range(6), *(pytest.param(k, marks=pytest.mark.thorough) for k in range(6, 40))]
)
def test_every_turn_that_changes_nothing_is_found_and_no_other(seed: int) -> None:
    """Judged by points inside, for the turns of a cube: the things are built along its axes."""
    chance = Random(seed)
    pieces = built(chance)
    found = found_of(*pieces)
    assert found.axis is None
    centre = middle_of(pieces)
    for rotation in quarter_turns():
        turn = (
            translation(*centre) @ Pose(rotation, (0.0, 0.0, 0.0)) @ translation(*centre).inverse()
        )
        known = any(rotation_angle(rotation, t.rotation) < SAME_TURN for t in found.turns)
        assert changes(pieces, turn, chance) is not known
    for turn in found.turns:
        assert not changes(pieces, turn, chance)


BRICKS = [
    ((0.08, 0.06, 0.05), 4, 2),
    ((0.08, 0.08, 0.05), 8, 4),
    ((0.08, 0.05, 0.08), 8, 2),  # a square side, but not from above
    ((0.06, 0.06, 0.06), 24, 4),
    ((0.08, 0.08 + SAME / 2, 0.05), 8, 4),  # nobody sees that
    ((0.08, 0.0805, 0.05), 4, 2),
]


@pytest.mark.parametrize(("size", "all_turns", "upright"), BRICKS)
def test_bricks(size: Vector, all_turns: int, upright: int) -> None:
    found = found_of(*upright_box(*size).pieces)
    assert (len(found.turns), len(found.upright().turns)) == (all_turns, upright)
    assert found.turns[0] == IDENTITY
    assert found.axis is None


def test_a_can_may_be_turned_anyhow_and_stand_upside_down() -> None:
    can = upright_cylinder(0.03, 0.115)
    for axis in (None, can.symmetry_axis):
        found = found_of(*can.pieces, axis=axis)
        assert found.axis == pytest.approx((0.0, 0.0, 1.0))
        assert found.foot == (0.0, 0.0, 0.0)
        (_, over) = found.turns
        assert over.apply((0.0, 0.0, 0.115)) == pytest.approx((0.0, 0.0, 0.0))
        assert over.approach == pytest.approx((0.0, 0.0, -1.0))
        assert found.upright() == Symmetries((IDENTITY,), found.axis, found.foot)


def test_things_that_only_look_round_from_above_cannot_stand_upside_down() -> None:
    cup = dish(0.1, 0.05, 0.005)
    found = found_of(*cup.pieces, axis=cup.symmetry_axis)
    assert found.axis is not None
    assert found.turns == (IDENTITY,)
    bottle = (
        Piece(Cylinder(0.03, 0.05), translation(0.0, 0.0, 0.05)),
        Piece(Cylinder(0.01, 0.02), translation(0.0, 0.0, 0.12)),
    )
    found = found_of(*bottle)
    assert found.axis == pytest.approx((0.0, 0.0, 1.0))
    assert found.turns == (IDENTITY,)


@pytest.mark.parametrize(("corners", "is_round"), [(6, False), (8, False), (24, True)])
def test_a_cone_of_many_corners_is_round(corners: int, is_round: bool) -> None:
    turns = [math.tau * k / corners for k in range(corners)]
    ring = tuple((0.05 * math.cos(turn), 0.05 * math.sin(turn), 0.0) for turn in turns)
    found = found_of(Piece(Hull((*ring, (0.0, 0.0, 0.1))), IDENTITY))
    assert (found.axis is not None) is is_round
    assert len(found.turns) == (1 if is_round else corners)
    prism = found_of(Piece(Hull((*ring, *((x, y, 0.1) for x, y, _ in ring))), IDENTITY))
    assert len(prism.turns) == (2 if is_round else 2 * corners)


def test_a_pin_beside_the_origin_is_round_about_itself() -> None:
    found = found_of(Piece(Cylinder(0.01, 0.05), translation(0.03, 0.04, 0.2)))
    assert found.axis == pytest.approx((0.0, 0.0, 1.0))
    assert found.foot == pytest.approx((0.03, 0.04, 0.0))


def test_colours_tell_turns_apart() -> None:
    halves = tuple(Piece(Box((0.02, 0.02, 0.02)), translation(x, 0.0, 0.0)) for x in (-0.02, 0.02))
    assert len(symmetries(halves, (GREY, GREY)).turns) == 8
    assert len(symmetries(halves, (GREY, RED)).turns) == 4  # about the long axis only


def test_the_things_of_scenes() -> None:
    many = table(1.0, 1.4, 0.8, 0.04, legs=True)
    assert len(found_of(*many.pieces).turns) == 2
    assert len(found_of(*stand(0.28, 0.28, 0.12, 0.016, 0.3).pieces).turns) == 1
    for form in (pizza(0.1, 0.1, RED), oven(Oven(0.3, 0.3, 0.3, 0.08), GREY)):
        colors = form.paint or (GREY,) * len(form.pieces)
        found = symmetries(form.pieces, colors, form.symmetry_axis)
        assert found == Symmetries((IDENTITY,), None, (0.0, 0.0, 0.0))
