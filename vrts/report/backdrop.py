"""What a camera sees of what never moves, drawn once for all pictures it takes."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from vrts.report.ground import Ground, ground
from vrts.report.layer import Layer, Screen, draw, empty_layer
from vrts.report.lighting import ShadowMap, from_srgb, shadow_map
from vrts.report.outlines import Mask
from vrts.report.placing import Fixed, Placed, place_fixed
from vrts.report.projection import Projected, project
from vrts.report.raster import NOTHING, Array32, Indices, rasterise
from vrts.report.solids import Solid

ALARM = np.array(from_srgb("#e11d2a"), np.float32)  # bodies in contact
ALARM_SHARE = 0.72
MAP = 1024  # longer side of the shadow map, texels
KEPT = 8  # views and backdrops, of about 10 MB each at 480x360


class Stage(NamedTuple):
    """What never moves in a scene, and the shadows it throws."""

    placed: Placed
    shadows: ShadowMap


class View(NamedTuple):
    """What one camera sees of a stage, without colours."""

    seen: Projected
    buffer: Indices  # (height * samples, width * samples)
    ground: Ground


@lru_cache(maxsize=KEPT)
def stage(fixed: tuple[Fixed, ...]) -> Stage:
    """Return what never moves."""
    placed = place_fixed(fixed)
    return Stage(placed, shadow_map(placed.corners, MAP))


@lru_cache(maxsize=KEPT)
def view(fixed: tuple[Fixed, ...], floor_m: float, screen: Screen) -> View:
    """Return what a camera sees of what never moves, above a floor at a height [m]."""
    at = stage(fixed)
    width, height = screen.width * screen.samples, screen.height * screen.samples
    seen = project(at.placed, screen.camera, width, height)
    buffer = rasterise(seen.screen, seen.near, width, height)
    buffer.flags.writeable = False
    around = ground(screen.camera, (screen.width, screen.height), floor_m, at.shadows)
    return View(seen, buffer, around)


@lru_cache(maxsize=KEPT)
def backdrop(
    fixed: tuple[Fixed, ...], floor_m: float, screen: Screen, highlight: frozenset[str]
) -> Layer:
    """Return the same with colours; highlighted bodies in the colour of alarm."""
    at, shown = stage(fixed), view(fixed, floor_m, screen)
    layer = empty_layer(screen)
    wanted = any_sample(shown.buffer != NOTHING, screen.samples)
    table = colors(at.placed.solids, highlight)
    draw(layer, screen, shown.buffer, shown.seen, table, at.shadows, wanted)
    for values in layer:
        values.flags.writeable = False
    return layer


def any_sample(samples: Mask, n: int) -> Mask:
    """Return for every pixel whether any of its n * n samples is set."""
    found = samples[::n, ::n].copy()
    for i in range(n):
        for j in range(n):
            found |= samples[i::n, j::n]
    return found


def colors(solids: tuple[Solid, ...], highlight: frozenset[str]) -> Array32:
    """Return the colour of every solid, shape (n, 3), linear."""
    table = np.array([solid.color for solid in solids], np.float32).reshape(-1, 3)
    for number, solid in enumerate(solids):
        if solid.name in highlight or solid.group in highlight:
            table[number] += ALARM_SHARE * (ALARM - table[number])
    return table
