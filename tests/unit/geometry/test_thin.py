"""Hulls with fewer points."""

import numpy as np

from vrts.geometry.thin import sphere, thinned


def test_directions_are_spread_over_the_sphere() -> None:
    directions = sphere(500)
    assert np.allclose(np.linalg.norm(directions, axis=1), 1.0)
    nearest = (directions @ sphere(300).T).max(axis=0)
    assert np.degrees(np.arccos(nearest.min())) < 8.0  # degrees; spaced 9


def test_few_points_reach_nearly_as_far_as_all() -> None:
    points = 0.1 * sphere(5000) * np.array([1.0, 0.5, 2.0])
    kept = thinned(points, 1e-3)
    assert 8 < len(kept) < 300
    directions = sphere(977)
    gap = (points @ directions.T).max(axis=0) - (kept @ directions.T).max(axis=0)
    assert gap.min() >= 0.0
    assert gap.max() < 1.5e-3


def test_kept_points_are_points_of_the_mesh_and_the_same_every_time() -> None:
    points = 0.1 * sphere(400)
    kept = thinned(points, 2e-3)
    rows = {tuple(row) for row in points.tolist()}
    assert all(tuple(row) in rows for row in kept.tolist())
    assert (thinned(points, 2e-3) == kept).all()


def test_a_box_keeps_its_corners() -> None:
    corners = np.array([(x, y, z) for x in (0, 1.0) for y in (0, 1.0) for z in (0, 1.0)])
    inside = 0.25 + 0.5 * corners
    assert len(thinned(np.concatenate([inside, corners]), 1e-3)) == 8
