"""Collision checks that look at instants, as one would write them with trimesh or python-fcl.

They ask what the certified check asks: robot and held object against the scene, and the arm against
itself, by name, since neighbours in the arm and the pads on an object always touch. They are kept
cheap: one mesh for each link and body (trimesh), shapes in closed form (python-fcl), and forward
kinematics of all instants in one batch.
"""

from collections.abc import Callable, Sequence
from importlib import import_module
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose
from vrts.check.collision.pairs.cast import Cast, robot_solids
from vrts.check.curves.timeline_arrays import Curves
from vrts.engine.memory.records import Lie
from vrts.engine.run import Run
from vrts.geometry.fcl_engine import solid
from vrts.geometry.mesh import tessellate
from vrts.geometry.shapes import Piece
from vrts.robots.kinematics.batch import link_frames

Array: TypeAlias = npt.NDArray[np.float64]
Sampler: TypeAlias = Callable[[Array], int]  # instants [s] to the number of those in contact

fcl: Any = import_module("fcl")
trimesh: Any = import_module("trimesh")

FACETS = 16  # sides of a cylinder, as few as look round


def matrix(X: Pose) -> Array:
    """Return a pose as 4 x 4."""
    found = np.eye(4)
    found[:3, :3] = np.array(X.rotation).reshape(3, 3)
    found[:3, 3] = X.translation
    return found


class _Motion:
    """Where the robot's parts and the carried objects are at instants."""

    def __init__(self, run: Run, curves: Curves) -> None:
        self.run = run
        self.curves = curves
        self.arm = run.scene.robot.arm
        self.X_LF = matrix(self.arm.X_LF)
        cast = Cast(0.0, 1.0, self.arm.X_LF)
        robot_solids(cast, run.scene.robot)
        self.parts: dict[str, list[int]] = {}
        for number, member in enumerate(cast.members):
            if member.frame > 0:
                self.parts.setdefault(member.part, []).append(number)
        self.members = cast.members
        self.carried = {name: own for name, own in run.placements.items() if len(own) > 1}

    def frames(self, times: Array) -> tuple[Array, Array]:
        """Return the link frames as 4 x 4, shape (7, n, 4, 4), and the openings of the hand."""
        values = self.curves.values(times)
        rotations, origins = link_frames(self.arm, values[:, :6])
        found = np.zeros((7, len(times), 4, 4))
        found[:, :, :3, :3] = rotations
        found[:, :, :3, 3] = origins
        found[:, :, 3, 3] = 1.0
        return found, values[:, 6]

    def body(self, name: str, t: float, flange: Array) -> tuple[bool, Array]:
        """Return whether a carried object is held, and where it is."""
        own = self.carried[name]
        placement = next((p for p in own if p.start_s <= t < p.end_s), own[-1])
        X = matrix(placement.X)
        held = placement.lie is Lie.HELD
        return held, flange @ X if held else X


def trimesh_sampler(run: Run, curves: Curves) -> Sampler:
    """Return a sampler on two managers of trimesh, asked for the names of what touches."""
    motion = _Motion(run, curves)
    managers = [trimesh.collision.CollisionManager() for _ in range(2)]
    robot, scene = managers
    for name, members in motion.parts.items():
        pieces = [Piece(motion.members[k].shape, motion.members[k].X_LP) for k in members]
        robot.add_object(name, _mesh(pieces))
    for body in run.scene.bodies:
        scene.add_object(body.name, _mesh(body.pieces), matrix(body.X_WO))
    meshes = {name: _mesh(run.scene.body(name).pieces) for name in motion.carried}
    owner: dict[str, Any] = dict.fromkeys(meshes, scene)
    touching: set[Any] = set()  # neighbours in the arm, as it stands at first

    def carry(name: str, t: float, flange: Array) -> None:
        held, X_WO = motion.body(name, t, flange)
        manager = robot if held else scene
        if manager is not owner[name]:
            owner[name].remove_object(name)
            manager.add_object(name, meshes[name])
            owner[name] = manager
        manager.set_transform(name, X_WO)

    def sampled(times: Array) -> int:
        frames, openings = motion.frames(times)
        hits = 0
        for at, t in enumerate(times.tolist()):
            for name, members in motion.parts.items():
                first = motion.members[members[0]]
                placed = frames[first.frame, at]
                if any(first.slide):
                    placed = placed @ _shift(first.slide, float(openings[at]))
                robot.set_transform(name, placed)
            for name in motion.carried:
                carry(name, t, frames[6, at] @ motion.X_LF)
            _, names = scene.in_collision_other(robot, return_names=True)
            _, itself = robot.in_collision_internal(return_names=True)
            touching.update(itself if t == 0.0 else ())
            hits += bool(names or itself - touching)
        return hits

    return sampled


def fcl_sampler(run: Run, curves: Curves) -> Sampler:
    """Return a sampler on two of python-fcl's trees of boxes."""
    motion = _Motion(run, curves)
    robot, scene = fcl.DynamicAABBTreeCollisionManager(), fcl.DynamicAABBTreeCollisionManager()
    names: dict[int, str] = {}
    kept: list[Any] = []  # fcl's managers do not keep what they are given

    def thing(piece: Piece, name: str) -> Any:
        geometry = solid(piece.shape)
        names[id(geometry)] = name
        kept.append(fcl.CollisionObject(geometry, fcl.Transform()))
        return kept[-1]

    moving: list[tuple[int, Array, Any]] = []
    for name, members in motion.parts.items():
        for k in members:
            member = motion.members[k]
            piece = Piece(member.shape, member.X_LP)
            moving.append((k, matrix(member.X_LP), thing(piece, name)))
    robot.registerObjects([one for _, _, one in moving])
    carried: dict[str, list[tuple[Array, Any]]] = {name: [] for name in motion.carried}
    for body in run.scene.bodies:
        for piece in body.pieces:
            one = thing(piece, body.name)
            one.setTransform(_transform(matrix(body.X_WO @ piece.X_OP)))
            scene.registerObject(one)
            if body.name in carried:
                carried[body.name].append((matrix(piece.X_OP), one))
    robot.setup()
    scene.setup()
    owner: dict[str, Any] = dict.fromkeys(carried, scene)
    request = fcl.CollisionRequest(num_max_contacts=1000, enable_contact=True)

    def pairs(data: Any) -> set[frozenset[str]]:
        return {
            frozenset((names[id(contact.o1)], names[id(contact.o2)]))
            for contact in data.result.contacts
        }

    def internal() -> set[frozenset[str]]:
        data = fcl.CollisionData(request)
        robot.collide(data, fcl.defaultCollisionCallback)
        return pairs(data)

    touching: set[Any] = set()  # neighbours in the arm, as it stands at first

    def carry(name: str, t: float, flange: Array) -> None:
        held, X_WO = motion.body(name, t, flange)
        manager = robot if held else scene
        for X_OP, one in carried[name]:
            if manager is not owner[name]:
                owner[name].unregisterObject(one)
                manager.registerObject(one)
            one.setTransform(_transform(X_WO @ X_OP))
        owner[name] = manager

    def sampled(times: Array) -> int:
        frames, openings = motion.frames(times)
        hits = 0
        for at, t in enumerate(times.tolist()):
            for k, X_LP, one in moving:
                member = motion.members[k]
                placed = frames[member.frame, at]
                if any(member.slide):
                    placed = placed @ _shift(member.slide, float(openings[at]))
                one.setTransform(_transform(placed @ X_LP))
            for name in carried:
                carry(name, t, frames[6, at] @ motion.X_LF)
            robot.update()
            scene.update()
            data = fcl.CollisionData(request)
            scene.collide(robot, data, fcl.defaultCollisionCallback)
            itself = internal()
            touching.update(itself if t == 0.0 else ())
            hits += bool(pairs(data) or itself - touching)
        return hits

    return sampled


def _mesh(pieces: Sequence[Piece]) -> Any:
    meshes: list[Any] = []
    for piece in pieces:
        vertices, triangles = tessellate(piece, FACETS)
        meshes.append(trimesh.Trimesh(vertices, triangles, process=False))
    whole = trimesh.util.concatenate(meshes)
    # trimesh would ask scipy whether a mesh is convex; here it is known
    surface = type("Surface", (trimesh.Trimesh,), {"is_convex": len(pieces) == 1})
    return surface(whole.vertices, whole.faces, process=False)


def _shift(slide: tuple[float, float, float], opening: float) -> Array:
    found = np.eye(4)
    found[:3, 3] = np.multiply(slide, opening)
    return found


def _transform(X: Array) -> Any:
    return fcl.Transform(X[:3, :3], X[:3, 3])
