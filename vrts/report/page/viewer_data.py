"""A scene as the browser's viewer takes it: plain JSON, lengths in m, angles in rad.

Poses are twelve numbers: the rotation row by row, then the translation. The shapes of these values
are written as types in `vrts/web/viewer/*.js`.

Boxes and cylinders stay what they are, and the viewer rounds their edges. As triangles in a GLB
file the same scenes are up to four times as large, compressed or not, and want a loader besides.
"""

from collections import deque
from collections.abc import Sequence
from functools import cache
from typing import TypeAlias

from vrts.base.pose import Pose
from vrts.check.task.goals import Goal
from vrts.check.task.task import Task
from vrts.geometry.mesh import surface
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece
from vrts.geometry.support import bounds
from vrts.report.page.html import json_text
from vrts.robots.kinematics.chain import fixed_frames
from vrts.robots.model import Robot, flange_in_hand
from vrts.scene.model import Body, Mobility, Scene

Json: TypeAlias = dict[str, object]

DECIMALS = 6  # 1 µm
KEPT = 4  # scenes as text

_written: deque[tuple[Scene, Task | None, str]] = deque(maxlen=KEPT)


def scene_data(scene: Scene, task: Task | None) -> Json:
    """Return what the viewer draws before anything moves, goals and via points included."""
    goals = task.goals if task else ()
    vias = task.vias if task else ()
    return {
        "name": scene.name,
        "title": scene.title,
        "robot": robot_data(scene.robot),
        "bodies": [_body(body) for body in scene.bodies],
        "floor": -scene.robot.arm.shoulder_height,
        "table": _table_top(scene),
        "goals": [goal for each in goals for goal in _goals(each)],
        "vias": [{"name": v.name, "point": _rounded(v.point), "radius": v.radius} for v in vias],
    }


def scene_text(scene: Scene, task: Task | None) -> str:
    """Return the same as JSON, which is kept: a whole class has one scene and one task."""
    for of_scene, of_task, text in _written:
        if of_scene is scene and of_task is task:
            return text
    text = json_text(scene_data(scene, task))
    _written.append((scene, task, text))
    return text


def _goals(goal: Goal) -> list[Json]:
    """Return an object at every place where it may end."""
    return [
        {"body": choice.body, "X": pose_numbers(choice.X_WG), "title": goal.title}
        for choice in goal.choices
    ]


@cache
def robot_data(robot: Robot) -> Json:
    """Return an arm and its gripper."""
    arm, gripper = robot.arm, robot.gripper
    return {
        "arm": {
            "name": arm.name,
            "title": arm.title,
            "joints": [pose_numbers(frame) for frame in fixed_frames(arm)],
            "flange": pose_numbers(flange_in_hand(arm)),
            "shoulderHeight": arm.shoulder_height,
            "lower": _rounded(arm.lower, 9),
            "upper": _rounded(arm.upper, 9),
            "speed": _rounded(arm.speed, 9),
            "linearSpeed": arm.linear_speed,
        },
        "links": [
            {"name": link.name, "joint": link.joint, "pieces": _pieces(link.pieces)}
            for link in arm.links
        ],
        "gripper": {
            "openingMin": gripper.opening_min,
            "openingMax": gripper.opening_max,
            "body": _pieces(gripper.body),
            "fingers": [
                {"name": f.name, "side": f.side, "pieces": _pieces(f.pieces)}
                for f in gripper.fingers
            ],
        },
    }


def pose_numbers(X: Pose) -> list[float]:
    """Return the twelve numbers of a pose."""
    return _rounded((*X.rotation, *X.translation), 9)


def _body(body: Body) -> Json:
    return {
        "name": body.name,
        "title": body.title,
        "kind": body.kind,
        "movable": body.mobility is Mobility.MOVABLE,
        "color": _rounded(body.color, 4),
        "pieces": _painted(body),
        "X": pose_numbers(body.X_WO),
    }


def _pieces(pieces: Sequence[Piece]) -> list[Json]:
    return [{**_shape(piece), "X": pose_numbers(piece.X_OP)} for piece in pieces]


def _painted(body: Body) -> list[Json]:
    """Return the pieces of a body; those of another colour than the body's have it with them."""
    found = _pieces(body.pieces)
    for piece, (_, color) in zip(found, body.painted, strict=True):
        if color != body.color:
            piece["color"] = _rounded(color, 4)
    return found


def _shape(piece: Piece) -> Json:
    match piece.shape:
        case Box(half_extents=half):
            return {"shape": "box", "half": _rounded(half)}
        case Cylinder(radius=radius, half_length=half_length):
            return {"shape": "cylinder", "radius": radius, "halfLength": half_length}
        case Hull() as hull:
            return _hull(hull)


@cache
def _hull(hull: Hull) -> Json:
    mesh = surface(hull)
    return {
        "shape": "hull",
        "vertices": _rounded(mesh.vertices.ravel().tolist()),
        "triangles": mesh.triangles.ravel().tolist(),
    }


def _table_top(scene: Scene) -> Json | None:
    """Return the level rectangle on top of the highest piece of the table, in W."""
    tables = [body for body in scene.bodies if body.kind == "table"]
    boxes = [bounds([piece], body.X_WO) for body in tables for piece in body.pieces]
    if not boxes:
        return None
    top = max(boxes, key=lambda box: box.upper[2])
    (x0, y0, _), (x1, y1, z) = top.lower, top.upper
    return {"x0": x0, "x1": x1, "y0": y0, "y1": y1, "z": z}


def _rounded(values: Sequence[float], decimals: int = DECIMALS) -> list[float]:
    return [round(value, decimals) + 0.0 for value in values]
