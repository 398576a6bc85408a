"""A picture of a scene at an instant, drawn with numpy alone.

Shows what is tested for collision, not more: the convex pieces of robot and bodies.
"""

import math
from collections.abc import Collection, Mapping, Sequence
from types import MappingProxyType

import numpy as np

from vrts.base.pose import Pose, Vector
from vrts.report.picture.backdrop import ALARM, Backdrop, any_sample, backdrop, colors, stage, view
from vrts.report.picture.camera import Camera, axes, close_up, fitting
from vrts.report.picture.draw import Band, Places, Screen, Shown, bands, draw
from vrts.report.picture.lighting import ShadowMap, shadow_map, to_srgb
from vrts.report.picture.placing import boxes, fixed_parts, place_moving
from vrts.report.picture.png import png
from vrts.report.picture.projection import NEAR, Projected, focal_length, joined, project
from vrts.report.picture.raster import Array, Array32, Mask, rasterise
from vrts.robots.model import Configuration
from vrts.scene.model import Scene

SIZE = (1200, 800)
SAMPLES = 2  # a side: sub-pixels of a pixel
GRID_M = 0.04  # cameras stand on a grid, so that their backdrops serve again
MAP = 400  # longer side of the shadow map of what moves, texels; more for wide pictures

NOWHERE: Mapping[str, Pose] = MappingProxyType({})


def still(
    scene: Scene,
    configuration: Configuration,
    *,
    hand_opening: float = 0.0,
    poses: Mapping[str, Pose] = NOWHERE,
    camera: Camera | None = None,
    size: tuple[int, int] = SIZE,
    samples: int = SAMPLES,
    highlight: Collection[str] = (),
    marker: Vector | None = None,
) -> bytes:
    """Return a PNG picture. The same call gives the same bytes on the same machine.

    Args:
        scene: What to draw.
        configuration: Of the arm, rad.
        hand_opening: Distance of the pads [m].
        poses: X_WO of bodies that are not where the scene starts.
        camera: None: the whole scene, or near the marker when there is one.
        size: Width and height in pixels.
        samples: Sub-pixels a side of a pixel: 1 is quick, 2 has smooth edges.
        highlight: Names of bodies drawn in the colour of alarm: "robot" for arm and hand, "left
            finger" for a part.
        marker: A point in W [m] marked with a ring, in front of everything.
    """
    fixed, floor_m = fixed_parts(scene), -scene.robot.arm.shoulder_height
    standing = stage(fixed).placed
    moving = place_moving(scene, configuration, hand_opening=hand_opening, poses=poses)
    if camera is None:
        camera = (
            _whole_scene(scene, (stage(fixed).boxes, boxes(moving)), size)
            if marker is None
            else close_up(
                _on_grid(marker), np.concatenate([standing.corners, moving.corners]), _front(scene)
            )
        )
    screen = Screen(camera, *size, samples)
    at, seen = stage(fixed), view(fixed, screen)
    added = project(moving, camera, size[0] * samples, size[1] * samples)
    shown = Shown(
        joined(seen, added, len(standing.solids)),
        colors((*standing.solids, *moving.solids), frozenset(highlight)),
        floor_m,
        (at.shadows, shadow_map(moving.corners, max(MAP, 5 * size[0] // 6))),
    )
    own = frozenset(highlight) & {part.name for part in fixed}
    # close pictures seldom have a place in common: their backdrops are not worth it
    before = backdrop(fixed, floor_m, screen, own) if marker is None else None
    pixels = np.empty((size[1], size[0], 3), np.uint8)
    for band in bands(size[1]):
        if before is None:
            light = _whole(screen, shown, band)
        else:
            light = _changed(screen, shown, band, before, added)
        if marker is not None:
            _ring(light, band, screen, marker)
        for k, channel in enumerate(to_srgb(light[:, band.inner])):
            pixels[band.own, :, k] = channel
    return png(pixels)


def _whole(screen: Screen, shown: Shown, band: Band) -> Array32:
    """Return the light of a band's rows."""
    n, rows = screen.samples, band.rows
    light = np.empty((3, rows.stop - rows.start, screen.width), np.float32)
    width, height = screen.width * n, light.shape[1] * n
    buffer = rasterise(shown.seen.screen, shown.seen.near, width, height, top=rows.start * n)
    draw(light, screen, shown, buffer, band.whole(screen.width), rows.start)
    return light


def _changed(
    screen: Screen, shown: Shown, band: Band, before: Backdrop, added: Projected
) -> Array32:
    """Return the same from a backdrop: only what the added triangles change is drawn."""
    n, rows = screen.samples, band.rows
    onto = before.buffer[rows.start * n : rows.stop * n]
    height, width = onto.shape
    first = len(shown.seen.screen) - len(added.screen) + 1
    buffer = rasterise(
        added.screen, added.near, width, height, first=first, onto=onto, top=rows.start * n
    )
    wanted = any_sample(buffer != onto, n)
    places = Places(*(values[:, rows] for values in before.places))
    wanted |= _darkened(places, shown.shadows[-1])
    light = before.light[:, rows].copy()
    draw(light, screen, shown, buffer, _grown(wanted) & band.whole(screen.width), rows.start)
    return light


def _darkened(places: Places, moving: ShadowMap) -> Mask:
    """Return to which of the pixels with known places a shadow map brings less light."""
    shape = places.floor.shape[1:]
    solid, floor = places.solid.reshape(3, -1), places.floor.reshape(2, -1)
    found = np.zeros(shape[0] * shape[1], np.bool_)
    at = np.flatnonzero(moving.covers(solid))
    found[at] = moving.lit(solid.take(at, axis=1)) < 1
    at = np.flatnonzero(moving.covers(floor))
    found[at] |= moving.shadow(floor.take(at, axis=1)) > 0
    return found.reshape(shape)


def _whole_scene(scene: Scene, parts: Sequence[Array], size: tuple[int, int]) -> Camera:
    """Return a camera from the side of the work, a little from above, with all in the picture.

    Of each part come the corners of boxes, shape (k, 3), m.
    """
    angle = _front(scene) + math.radians(62.0)
    towards = -np.array([math.cos(angle), math.sin(angle), math.tan(math.radians(21.0))])
    found = fitting(np.concatenate(parts), towards, size)
    frame = axes(towards)
    eye = frame @ np.array(found.eye) / GRID_M
    eye = np.append(np.round(eye[:2]), np.floor(eye[2])) * GRID_M
    return Camera(_vector(eye @ frame), _vector(eye @ frame + frame[2]))


def _on_grid(point: Vector) -> Vector:
    """Return a place near a point, so that pictures of neighbouring points share a backdrop."""
    return _vector(np.round(np.array(point) / GRID_M) * GRID_M)


def _vector(values: Array) -> Vector:
    x, y, z = values
    return (float(x), float(y), float(z))


def _front(scene: Scene) -> float:
    """Return the azimuth, from the robot, of the middle of what can be carried, rad."""
    places = [b.X_WO.translation for b in scene.bodies if b.rests_on is not None]
    places = places or [b.X_WO.translation for b in scene.bodies if b.kind != "floor"]
    x, y = (sum(p[axis] for p in places) for axis in (0, 1))
    return math.atan2(y, x) if math.hypot(x, y) > 1e-6 else 0.0


def _grown(mask: Mask) -> Mask:
    """Return the pixels of a mask and their neighbours, whose outlines may change."""
    grown = mask.copy()
    grown[1:] |= mask[:-1]
    grown[:-1] |= mask[1:]
    grown[:, 1:] |= mask[:, :-1]
    grown[:, :-1] |= mask[:, 1:]
    return grown


def _ring(light: Array32, band: Band, screen: Screen, point: Vector) -> None:
    """Draw a ring with a light rim round a point into the rows of a band, over everything."""
    camera, height = screen.camera, screen.height
    local = camera.axes() @ np.subtract(point, camera.eye)
    if local[2] <= NEAR:
        return
    x, y = local[:2] / local[2] * focal_length(camera, height) + (screen.width / 2, height / 2)
    radius = height / 22
    room = radius + height / 130 + 1
    first = max(int(y - room), band.rows.start) - band.rows.start
    last = max(int(y + room) + 2 - band.rows.start, 0)
    left = max(int(x - room), 0)
    part = light[:, first:last, left : max(int(x + room) + 2, 0)]
    rows, columns = np.indices(part.shape[1:]) + 0.5
    away = np.hypot(columns + left - x, rows + (band.rows.start + first) - y)
    for thickness, color in ((height / 130, np.ones(3)), (height / 260, ALARM)):
        share = np.clip(thickness + 0.5 - np.abs(away - radius), 0, 1).astype(np.float32)
        part += share * (np.asarray(color, np.float32)[:, None, None] - part)
