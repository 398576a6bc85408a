"""What is put down rests if and only if its mass is above the hull of its contact points.

The oracle is that sentence: points that touch are sampled, and something has to be found of them in
every direction from the mass. Placements nearer to the limit than samples lie tell nothing.
"""

import math
from collections.abc import Callable
from typing import TypeAlias

import numpy as np
import numpy.typing as npt
import pytest

from vrts.base.pose import IDENTITY, X_AXIS, Pose, Vector, rotation_about, translation
from vrts.engine.hand.resting import Standing
from vrts.engine.hand.settle import settle
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece

Array: TypeAlias = npt.NDArray[np.float64]
Ground: TypeAlias = tuple[list[Standing], Array]  # what stands there, and points of its tops

RADIUS = 0.03  # [m] of the can
STEP = 5e-4  # [m] between samples
SURE = 2e-3  # [m] nearer to the limit, samples do not tell
TOP = 0.05  # [m] where all supports end
TRIALS = 30
WAYS = np.stack([np.cos(np.arange(0, math.tau, 0.05)), np.sin(np.arange(0, math.tau, 0.05))])
CAN = (Piece(Cylinder(RADIUS, 0.05), IDENTITY),)


def depth(points: Array, mass: Array) -> float:
    """Return how far the mass is inside the hull of points, or outside: less than zero [m]."""
    if not len(points):
        return -1.0
    return float(((points - mass) @ WAYS).max(axis=0).min())


def grid(x: float, y: float, a: float, b: float) -> Array:
    """Return points of a rectangle with this middle and these half sides."""
    xs, ys = (np.append(np.arange(-half, half, STEP), half) for half in (a, b))
    return np.stack(np.meshgrid(xs + x, ys + y), axis=2).reshape(-1, 2)


def post(name: str, x: float, y: float, a: float, b: float) -> Standing:
    shape = Box((a, b, TOP / 2))
    return Standing(name, (Piece(shape, IDENTITY),), translation(x, y, TOP / 2))


def spike(x: float, y: float, z: float, height: float) -> Piece:
    """Return a pyramid with its point at a place, upward or, height less than zero, downward."""
    low = z - height
    corners = [(x + a, y + b, low) for a in (-0.004, 0.004) for b in (-0.004, 0.004)]
    return Piece(Hull((*corners, (x, y, z))), IDENTITY)


def two_bars(rng: np.random.Generator) -> Ground:
    a, b = -rng.uniform(0.01, 0.03), rng.uniform(0.01, 0.03)
    bars = [post("a", a, 0.0, 0.004, 0.1), post("b", b, 0.0, 0.004, 0.1)]
    return bars, np.concatenate([grid(x, 0.0, 0.004, 0.06) for x in (a, b)])


def two_rods(rng: np.random.Generator) -> Ground:
    """Return two rods that lie: a can touches each along a line."""
    rods: list[Standing] = []
    tops: list[Array] = []
    for name, y in (("a", -rng.uniform(0.01, 0.03)), ("b", rng.uniform(0.01, 0.03))):
        lying = Pose(rotation_about((0.0, 1.0, 0.0), math.pi / 2), (0.0, y, TOP - 0.01))
        rods.append(Standing(name, (Piece(Cylinder(0.01, 0.1), IDENTITY),), lying))
        tops.append(grid(0.0, y, 0.06, 0.0))
    return rods, np.concatenate(tops)


def three_pins(rng: np.random.Generator) -> Ground:
    turns = rng.uniform(0, 2) + np.array([0.0, 2.1, 4.2]) + rng.uniform(-0.6, 0.6, 3)
    at = rng.uniform(0.012, 0.022, 3)[:, None] * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    points: list[tuple[float, float]] = [(x, y) for x, y in at.tolist()]
    return [Standing(f"{x}", (spike(x, y, TOP, 0.03),), IDENTITY) for x, y in points], at


def ring(rng: np.random.Generator, floor: float = 0.0) -> Ground:
    """Return the rim of a dish: 16 pieces of one body, round a hollow."""
    inner, outer, count = rng.uniform(0.012, 0.024), 0.04, 16
    pieces: list[Piece] = []
    turns = math.tau * np.arange(count + 1) / count
    for a, b in zip(turns[:-1].tolist(), turns[1:].tolist(), strict=True):
        corners = [(r * math.cos(t), r * math.sin(t)) for t in (a, b) for r in (inner, outer)]
        pieces.append(Piece(Hull(tuple((x, y, z) for x, y in corners for z in (0, TOP))), IDENTITY))
    if floor:
        pieces.append(Piece(Box((inner, inner, floor / 2)), translation(0, 0, floor / 2)))
    rho, phi = np.meshgrid(np.arange(inner, outer, 4 * STEP), np.arange(0, math.tau, 0.05))
    top = np.stack([rho * np.cos(phi), rho * np.sin(phi)], axis=2).reshape(-1, 2)
    return [Standing("dish", tuple(pieces), IDENTITY)], top


def dish(rng: np.random.Generator) -> Ground:
    return ring(rng, 0.01)


@pytest.mark.parametrize(
    "ground", [two_bars, two_rods, three_pins, ring, pytest.param(dish, marks=pytest.mark.thorough)]
)
def test_a_can_rests_where_its_mass_is_above_the_hull_of_its_contacts(
    ground: Callable[[np.random.Generator], Ground],
) -> None:
    rng = np.random.default_rng(7)
    told = [0, 0]
    for _ in range(TRIALS if ground not in {ring, dish} else TRIALS // 2):
        standing, tops = ground(rng)
        at = rng.uniform(-0.02, 0.02, 2)
        wide = 0.03 if ground in {ring, dish} else 0.02
        off = rng.uniform(-wide, wide, 2)
        x, y = at.tolist()
        away = np.linalg.norm(tops - at, axis=1)
        if abs(float(away.min()) - RADIUS) < SURE:
            continue
        limit = depth(tops[away <= RADIUS], at + off)
        if abs(limit) < SURE:
            continue
        mass = (float(off[0]), float(off[1]), 0.0)
        rest = settle(CAN, translation(x, y, 0.12), mass, standing)
        stands = rest is not None and rest.stands and rest.X_WO.translation[2] > TOP
        assert stands == (limit > 0.0), (x, y, off, limit)
        told[stands] += 1
    assert min(told) >= 1, told


def test_feet_of_several_heights_stand_on_steps() -> None:
    """The contacts are at three heights, and each is a point."""
    rng = np.random.default_rng(8)
    told = [0, 0]
    for _ in range(TRIALS):
        at = np.array([[-0.04, -0.03], [0.04, -0.03], [0.0, 0.05]]) + rng.uniform(
            -0.01, 0.01, (3, 2)
        )
        heights: list[float] = rng.uniform(0.01, 0.05, 3).tolist()
        feet = [(x, y, h) for (x, y), h in zip(at.tolist(), heights, strict=True)]
        plate = Piece(Box((0.07, 0.07, 0.005)), translation(0, 0, 0.105))
        pieces = (plate, *(spike(x, y, h, h - 0.1) for x, y, h in feet))
        steps = [
            Standing(f"{h}", (Piece(Box((0.01, 0.01, h / 2)), IDENTITY),), translation(x, y, h / 2))
            for x, y, h in feet
        ]
        mass = rng.uniform(-0.05, 0.05, 2)
        limit = depth(at, mass)
        if abs(limit) < 1e-4:
            continue
        own: Vector = (float(mass[0]), float(mass[1]), 0.1)
        rest = settle(pieces, translation(0, 0, 0.03), own, steps)
        assert rest is not None
        assert rest.stands == (limit > 0.0)
        assert rest.height_m == pytest.approx(0.03, abs=2e-5)
        told[rest.stands] += 1
    assert min(told) >= 3, told


def test_nothing_stands_on_a_line() -> None:
    lying = Pose(rotation_about(X_AXIS, math.pi / 2), (0.0, 0.0, 0.12))
    rest = settle(CAN, lying, (0.0, 0.0, 0.0), [post("block", 0.0, 0.0, 0.1, 0.1)])
    assert rest is not None
    assert not rest.stands
