"""The depth buffer shows what is nearest at the middle of every pixel, and leaves no gap."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from vrts.report.picture.raster import NOTHING, nearness, numbers, plane, rasterise, signed_area

WIDTH, HEIGHT = 23, 17


def triangles(seed: int, count: int) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    points = random.uniform(-8, 30, (count, 1, 2)) + random.normal(0, 9, (count, 3, 2))
    return points, random.uniform(0.2, 2.0, (count, 3))


@given(st.integers(0, 10_000), st.integers(1, 12))
@settings(max_examples=examples(40), deadline=None)
def test_every_pixel_shows_the_nearest_triangle_at_its_middle(seed: int, count: int) -> None:
    points, near = triangles(seed, count)
    buffer = rasterise(points, near, WIDTH, HEIGHT)
    coefficients = plane(points, near)
    sign = np.sign(signed_area(points))
    for row in range(HEIGHT):
        for column in range(WIDTH):
            middle = np.array([column + 0.5, row + 0.5])
            ahead = np.roll(points, -1, axis=1)
            side = (ahead - points)[:, :, 0] * (middle - points)[:, :, 1]
            side -= (ahead - points)[:, :, 1] * (middle - points)[:, :, 0]
            inside = (side * sign[:, None] > 1e-6).all(axis=1)
            if not inside.any() or (np.abs(side) < 1e-6).any():
                continue
            depth = np.where(inside, coefficients @ [*middle, 1.0], -np.inf)
            best = int(np.argmax(depth))
            shown = buffer[row : row + 1, column]
            assert numbers(shown)[0] == best + 1 or np.ptp(np.sort(depth)[-2:]) < 1e-5
            assert abs(nearness(shown)[0] - max(depth[best], 1e-30)) < 1e-4


@given(st.integers(0, 10_000))
@settings(max_examples=examples(20), deadline=None)
def test_order_and_number_of_calls_do_not_matter(seed: int) -> None:
    points, near = triangles(seed, 10)
    whole = rasterise(points, near, WIDTH, HEIGHT)
    first = rasterise(points[:4], near[:4], WIDTH, HEIGHT)
    both = rasterise(points[4:], near[4:], WIDTH, HEIGHT, first=5, onto=first)
    assert (both == whole).all()
    assert (first == rasterise(points[:4], near[:4], WIDTH, HEIGHT)).all()  # it stayed as it was


@given(st.integers(0, 10_000))
@settings(max_examples=examples(20), deadline=None)
def test_triangles_round_a_point_leave_no_gap_and_share_no_pixel(seed: int) -> None:
    random = np.random.default_rng(seed)
    centre = random.uniform(8, 15, 2)
    angles = np.arange(9) * 2 * np.pi / 9 + random.uniform(0, 1)
    rim = centre + 40 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    fan = np.array([[centre, rim[k], rim[(k + 1) % 9]] for k in range(9)])
    parts = [rasterise(fan[k : k + 1], np.ones((1, 3)), WIDTH, HEIGHT) for k in range(9)]
    assert (np.stack([part != NOTHING for part in parts]).sum(axis=0) == 1).all()


def test_nothing_is_an_empty_screen() -> None:
    none = np.zeros((0, 3, 2)), np.zeros((0, 3))
    assert (rasterise(*none, WIDTH, HEIGHT) == NOTHING).all()
