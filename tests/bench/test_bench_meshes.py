"""Meshes: how long pieces take to be made and to be proven, and how far they stand out.

python -m pytest tests/bench/test_bench_meshes.py -s
"""

import math
import time

import numpy as np
import pytest

from tests.parts import stl, u_shape
from vrts.pipeline.pieces.making import compared, made

ROUND = (24, 60, 200)  # corners round a ring


def ring(count: int) -> bytes:
    """Return a ring of 2 * count * count / 2 triangles as STL, 80 mm across."""
    around = np.arange(count) * math.tau / count
    across = np.arange(count // 2) * math.tau / (count // 2)
    u, v = np.meshgrid(around, across, indexing="ij")
    radius = 30.0 + 10.0 * np.cos(v)
    grid = np.stack([radius * np.cos(u), radius * np.sin(u), 10.0 * np.sin(v)], axis=2)
    right, up = np.roll(grid, -1, axis=0), np.roll(grid, -1, axis=1)
    both = np.roll(right, -1, axis=1)
    faces = [np.stack([grid, right, both], axis=2), np.stack([grid, both, up], axis=2)]
    return stl(np.concatenate([each.reshape(-1, 3, 3) for each in faces]))


@pytest.mark.parametrize("count", [0, *ROUND])
def test_pieces_are_made_and_proven(count: int) -> None:
    data = ring(count) if count else stl(u_shape())
    start = time.perf_counter()
    pieces = made("part.stl", data, "mm", 0.05, 32)
    making = time.perf_counter() - start
    start = time.perf_counter()
    beside = compared(pieces, "part.stl", data)
    proving = time.perf_counter() - start
    corners = sum(map(len, pieces.corners))
    print(
        f"\n{pieces.triangles:>6,} triangles: {len(pieces.corners)} pieces, {corners} corners, "
        f"{pieces.found:.2f} to {pieces.at_most:.2f} mm out, volume "
        f"{100 * (pieces.pieces_volume / pieces.mesh_volume - 1):+.1f} %; "
        f"made in {making:.1f} s, proven in {proving:.1f} s"
    )
    assert beside.same
    assert beside.stands_out == 0.0
