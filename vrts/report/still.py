"""A picture of a scene at an instant, drawn with numpy alone.

Shows what is tested for collision, not more: the convex pieces of robot and bodies.
"""

import math
from collections.abc import Collection, Mapping
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from vrts.base.pose import Pose, Vector
from vrts.report import lighting
from vrts.report.camera import Camera, bounds, close_up, fitting
from vrts.report.ground import ground
from vrts.report.lighting import ShadowMap, shade, shadow_map, to_srgb
from vrts.report.png import png
from vrts.report.raster import Array, Array32, Indices, on_screen, rasterise, signed_area
from vrts.report.solids import Solid, body_solids, link_solids
from vrts.robots.batch import flange_frames, link_frames
from vrts.robots.model import Configuration
from vrts.scene.model import Scene

SIZE = (1200, 800)
SAMPLES = 2  # a side: sub-pixels of a pixel
NEAR = 0.02  # [m] nothing nearer to the eye is drawn
ALARM = np.array(lighting.from_srgb("#e11d2a"), np.float32)  # bodies in contact
ALARM_SHARE = 0.72
LINE = 0.42  # how much of the light an outline keeps
CREASE_LINE = 0.80  # the same of an inner edge

NOWHERE: Mapping[str, Pose] = MappingProxyType({})


class Placed(NamedTuple):
    """Everything to draw, in W."""

    corners: Array  # (m, 3, 3) [m]
    normals: Array  # (m, 3, 3)
    solid: Indices  # (m,) index in `solids`
    solids: tuple[Solid, ...]


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
    placed = place(scene, configuration, hand_opening=hand_opening, poses=poses)
    if camera is None:
        camera = (
            whole_scene(scene, placed, size)
            if marker is None
            else near_point(scene, placed, marker)
        )
    floor = _floor_height(scene)
    shadows = shadow_map(placed.corners)
    width, height = size[0] * samples, size[1] * samples
    light, covered = _solids(placed, camera, width, height, shadows, frozenset(highlight))
    light = _averaged(light.reshape(height, width, 3), samples)
    share = _averaged(covered.reshape(height, width, 1), samples)
    around = ground(camera, size, floor, placed.corners)
    picture = (light + (1 - share) * around).astype(np.float32)
    if marker is not None:
        _ring(picture, camera, marker)
    return png(to_srgb(picture))


def place(
    scene: Scene,
    configuration: Configuration,
    *,
    hand_opening: float = 0.0,
    poses: Mapping[str, Pose] = NOWHERE,
) -> Placed:
    """Return the triangles of robot and bodies in W; the floor, which is ground, is left out."""
    solids: list[Solid] = []
    where: list[tuple[Array, Array]] = []
    bodies = {body.name: body for body in scene.bodies}
    for solid in body_solids(scene):
        body = bodies[solid.group]
        if body.kind != "floor":
            X_WO = poses.get(body.name, body.X_WO)
            solids.append(solid)
            where.append((np.array(X_WO.rotation).reshape(3, 3), np.array(X_WO.translation)))
    q = np.array([configuration])
    turns, places = link_frames(scene.robot.arm, q)
    hand_turn, hand_place = flange_frames(scene.robot.arm, q)
    robot = link_solids(scene.robot)
    links = len(scene.robot.arm.links)
    solids += robot
    where += [(turns[link.joint, 0], places[link.joint, 0]) for link in scene.robot.arm.links]
    sides = (0, *(finger.side for finger in scene.robot.gripper.fingers))
    for side in sides:
        along = hand_turn[0] @ np.array([0.0, side * hand_opening / 2, 0.0])
        where.append((hand_turn[0], hand_place[0] + along))
    assert len(solids) == len(where)
    assert links + len(sides) == len(robot)
    return Placed(
        np.concatenate(
            [s.surface.corners @ R.T + p for s, (R, p) in zip(solids, where, strict=True)]
        ),
        np.concatenate([s.surface.normals @ R.T for s, (R, _) in zip(solids, where, strict=True)]),
        np.repeat(np.arange(len(solids)), [len(s.surface.corners) for s in solids]),
        tuple(solids),
    )


def whole_scene(scene: Scene, placed: Placed, size: tuple[int, int]) -> Camera:
    """Return a camera from the side of the work, a little from above, with all in the picture."""
    clouds = [
        placed.corners[placed.solid == number].reshape(-1, 3)
        for number in range(len(placed.solids))
    ]
    angle = _front(scene) + math.radians(62.0)
    towards = -np.array([math.cos(angle), math.sin(angle), math.tan(math.radians(21.0))])
    return fitting(bounds(clouds), towards, size)


def near_point(scene: Scene, placed: Placed, point: Vector) -> Camera:
    """Return a camera that looks at a point from near."""
    return close_up(point, placed.corners, _front(scene))


def _front(scene: Scene) -> float:
    """Return the azimuth, from the robot, of the middle of what can be carried, rad."""
    places = [b.X_WO.translation for b in scene.bodies if b.rests_on is not None]
    places = places or [b.X_WO.translation for b in scene.bodies if b.kind != "floor"]
    x, y = (sum(p[axis] for p in places) for axis in (0, 1))
    return math.atan2(y, x) if math.hypot(x, y) > 1e-6 else 0.0


def _floor_height(scene: Scene) -> float:
    return -scene.robot.arm.shoulder_height


def _solids(
    placed: Placed,
    camera: Camera,
    width: int,
    height: int,
    shadows: ShadowMap,
    highlight: frozenset[str],
) -> tuple[Array32, Array32]:
    """Return light and coverage of every sub-pixel, shape (width * height, 3) and (..., 1)."""
    frame = camera.axes()
    eye = np.array(camera.eye)
    focal = height / 2 / math.tan(camera.field_of_view / 2)
    local = (placed.corners - eye) @ frame.T
    local, normals, solid = _clipped(local, placed.normals, placed.solid)
    depth = local[:, :, 2]
    screen = local[:, :, :2] / depth[:, :, None] * focal + (width / 2, height / 2)
    front = signed_area(screen) < -1e-9
    screen, depth, normals, solid = screen[front], depth[front], normals[front], solid[front]
    seen = rasterise(screen, 1 / depth, width, height)
    row, column = np.divmod(seen.pixel, width)
    x = (column + 0.5).astype(np.float32)
    y = (row + 0.5).astype(np.float32)
    planes = on_screen(screen, normals / depth[:, :, None])[seen.triangle]
    facing = planes[:, 0] * x[:, None] + planes[:, 1] * y[:, None] + planes[:, 2]
    facing /= np.sqrt(np.einsum("ij,ij->i", facing, facing))[:, None]
    ray = np.empty((len(x), 3), np.float32)
    ray[:, 0] = (x - width / 2) / focal
    ray[:, 1] = (y - height / 2) / focal
    ray[:, 2] = 1
    turned = (ray / seen.nearness[:, None]) @ frame.astype(np.float32)
    points: Array32 = (turned + eye.astype(np.float32)).astype(np.float32)
    owner = solid[seen.triangle]
    color = _colors(placed.solids, highlight)[owner]
    lit = shade(color, facing, points, eye, shadows.lit(points + facing * np.float32(0.004)))
    lit *= _outlines(seen.pixel, owner, seen.nearness, facing, width, height)[:, None]
    light = np.zeros((width * height, 3), np.float32)
    light[seen.pixel] = lit
    covered = np.zeros((width * height, 1), np.float32)
    covered[seen.pixel] = 1
    return light, covered


def _clipped(corners: Array, normals: Array, solid: Indices) -> tuple[Array, Array, Indices]:
    """Return triangles with what lies behind the near plane cut off; depth is the third column."""
    behind = corners[:, :, 2] < NEAR
    count = behind.sum(1)
    parts = [(corners[count == 0], normals[count == 0], solid[count == 0])]
    for number in (1, 2):
        for odd in range(3):  # the corner that is alone on its side
            chosen = (count == number) & (behind[:, odd] == (number == 1))
            if not chosen.any():
                continue
            turn = [odd, (odd + 1) % 3, (odd + 2) % 3]
            p, n, s = corners[chosen][:, turn], normals[chosen][:, turn], solid[chosen]
            share = (NEAR - p[:, :1, 2]) / (p[:, 1:, 2] - p[:, :1, 2])
            cut_p = p[:, :1] + share[:, :, None] * (p[:, 1:] - p[:, :1])
            cut_n = n[:, :1] + share[:, :, None] * (n[:, 1:] - n[:, :1])
            if number == 2:
                parts.append((_fan(p[:, 0], *_pair(cut_p)), _fan(n[:, 0], *_pair(cut_n)), s))
            else:
                b, c = _pair(cut_p)
                nb, nc = _pair(cut_n)
                parts.append((_fan(b, p[:, 1], p[:, 2]), _fan(nb, n[:, 1], n[:, 2]), s))
                parts.append((_fan(b, p[:, 2], c), _fan(nb, n[:, 2], nc), s))
    return (
        np.concatenate([part[0] for part in parts]),
        np.concatenate([part[1] for part in parts]),
        np.concatenate([part[2] for part in parts]),
    )


def _pair(ends: Array) -> tuple[Array, Array]:
    return ends[:, 0], ends[:, 1]


def _fan(a: Array, b: Array, c: Array) -> Array:
    return np.stack([a, b, c], axis=1)


def _colors(solids: tuple[Solid, ...], highlight: frozenset[str]) -> Array32:
    table = np.array([solid.color for solid in solids], np.float32)
    for number, solid in enumerate(solids):
        if solid.name in highlight or solid.group in highlight:
            table[number] += ALARM_SHARE * (ALARM - table[number])
    return table


def _outlines(
    pixel: Indices, owner: Indices, nearness: Array32, facing: Array32, width: int, height: int
) -> Array32:
    """Return how much light is left where a solid ends before another, or has an edge."""
    ids = np.full((height, width), -1, np.int32)
    ids.ravel()[pixel] = owner
    near = np.zeros((height, width), np.float32)
    near.ravel()[pixel] = nearness
    where = np.zeros((height, width, 3), np.float32)
    where.reshape(-1, 3)[pixel] = facing
    keep = np.ones((height, width), np.float32)
    for ahead, behind in ((np.s_[:, 1:], np.s_[:, :-1]), (np.s_[1:], np.s_[:-1])):
        other = ids[ahead] != ids[behind]
        nearer = near[ahead] > near[behind]
        crease = np.einsum("ijk,ijk->ij", where[ahead], where[behind]) < 0.8
        jump = np.abs(near[ahead] - near[behind]) > 0.05 * np.maximum(near[ahead], near[behind])
        edge = ~other & (crease | jump) & (ids[ahead] >= 0)
        keep[ahead][other & nearer] = LINE
        keep[behind][other & ~nearer] = LINE
        view = keep[behind]
        view[edge] = np.minimum(view[edge], CREASE_LINE)
    return keep.ravel()[pixel]


def _averaged(picture: Array32, samples: int) -> Array32:
    if samples == 1:
        return picture
    height, width, depth = picture.shape
    blocks = picture.reshape(height // samples, samples, width // samples, samples, depth)
    total = sum(
        (blocks[:, i, :, j] for i in range(samples) for j in range(samples)),
        np.zeros((height // samples, width // samples, depth), np.float32),
    )
    return total * np.float32(1 / samples**2)


def _ring(picture: Array32, camera: Camera, point: Vector) -> None:
    """Draw a ring with a light rim round a point, over everything."""
    height, width, _ = picture.shape
    local = camera.axes() @ np.subtract(point, camera.eye)
    if local[2] <= NEAR:
        return
    focal = height / 2 / math.tan(camera.field_of_view / 2)
    x, y = local[:2] / local[2] * focal + (width / 2, height / 2)
    rows, columns = np.mgrid[0:height, 0:width] + 0.5
    away = np.hypot(columns - x, rows - y)
    radius = height / 22
    for thickness, color in ((height / 130, np.ones(3)), (height / 260, ALARM)):
        share = np.clip(thickness + 0.5 - np.abs(away - radius), 0, 1)
        share = share.astype(np.float32)[:, :, None]
        picture += share * (np.asarray(color, np.float32) - picture)
