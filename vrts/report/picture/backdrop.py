"""What a camera sees of what never moves, drawn once for all pictures it takes."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from vrts.report.picture.draw import Places, Screen, Shown, bands, draw
from vrts.report.picture.lighting import ShadowMap, from_srgb, shadow_map
from vrts.report.picture.placing import Fixed, Placed, boxes, place_fixed
from vrts.report.picture.projection import Projected, project
from vrts.report.picture.raster import Array, Array32, Indices, Mask, rasterise
from vrts.report.picture.solids import Solid

ALARM = np.array(from_srgb("#e11d2a"), np.float32)  # bodies in contact
ALARM_SHARE = 0.72
MAP = 1024  # longer side of the shadow map, texels
KEPT = 8  # views and backdrops, of about 10 MB each at 480x360


class Stage(NamedTuple):
    """What never moves in a scene, and the shadows it throws."""

    placed: Placed
    shadows: ShadowMap
    boxes: Array  # corners of those round it, (k, 3) [m]


class Backdrop(NamedTuple):
    """The picture of a stage, and where its light comes from."""

    buffer: Indices  # (height * samples, width * samples)
    light: Array32  # (3, height, width) linear
    places: Places


@lru_cache(maxsize=KEPT)
def stage(fixed: tuple[Fixed, ...]) -> Stage:
    """Return what never moves."""
    placed = place_fixed(fixed)
    return Stage(placed, shadow_map(placed.corners, MAP), boxes(placed))


@lru_cache(maxsize=KEPT)
def view(fixed: tuple[Fixed, ...], screen: Screen) -> Projected:
    """Return what a camera sees of what never moves."""
    width, height = screen.width * screen.samples, screen.height * screen.samples
    return project(stage(fixed).placed, screen.camera, width, height)


@lru_cache(maxsize=KEPT)
def backdrop(
    fixed: tuple[Fixed, ...], floor_m: float, screen: Screen, highlight: frozenset[str]
) -> Backdrop:
    """Return the same as a picture, above a floor at a height [m].

    Highlighted bodies have the colour of alarm.
    """
    at, seen = stage(fixed), view(fixed, screen)
    shown = Shown(seen, colors(at.placed.solids, highlight), floor_m, (at.shadows,))
    shape, n = (screen.height, screen.width), screen.samples
    buffer = rasterise(seen.screen, seen.near, screen.width * n, screen.height * n)
    light, solid, floor = (np.full((k, *shape), np.nan, np.float32) for k in (3, 3, 2))
    for band in bands(screen.height):
        rows = band.rows
        noted = Places(solid[:, rows], floor[:, rows])
        fine = buffer[rows.start * n : rows.stop * n]
        draw(light[:, rows], screen, shown, fine, band.whole(screen.width), rows.start, noted)
    for values in (buffer, light, solid, floor):
        values.flags.writeable = False
    return Backdrop(buffer, light, Places(solid, floor))


def any_sample(samples: Mask, n: int) -> Mask:
    """Return for every pixel whether any of its n * n samples is set."""
    found = samples[::n, ::n].copy()
    for i in range(n):
        for j in range(n):
            found |= samples[i::n, j::n]
    return found


def colors(solids: tuple[Solid, ...], highlight: frozenset[str]) -> Array32:
    """Return the colour of every solid, shape (3, n), linear."""
    table = np.array([solid.color for solid in solids], np.float32).reshape(-1, 3)
    for number, solid in enumerate(solids):
        if solid.name in highlight or solid.group in highlight:
            table[number] += ALARM_SHARE * (ALARM - table[number])
    return np.ascontiguousarray(table.T)
