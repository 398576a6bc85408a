"""Where shapes may touch: a face, an edge, a corner, a rim, and the direction out of them there."""

import math
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt
from scipy.spatial import ConvexHull

from vrts.geometry.shapes import Box, Cylinder, Hull, Shape

Array: TypeAlias = npt.NDArray[np.float64]

FACE, EDGE, CORNER = "face", "edge", "corner"  # of a cylinder: cap, rim; its side is an edge


class Feature(NamedTuple):
    """A place on the surface of a shape, in its frame."""

    point: Array  # (3,) [m]
    outward: Array  # (3,) unit vector; no point of the shape lies farther along it
    along: Array  # (3,) unit vector across it: along the edge, or along a side of the face


def feature(shape: Shape, kind: str, random: np.random.Generator, *, middle: bool) -> Feature:
    """Return a feature of some kind, anywhere, or in the middle of a face."""
    spread = 0.0 if middle else 0.8
    match shape:
        case Box(half_extents=half):
            return _of_box(np.array(half), kind, random, spread)
        case Cylinder():
            return _of_cylinder(shape, kind, random, spread)
        case Hull(points=points):
            return _of_hull(np.array(points), kind, random)


def _of_box(half: Array, kind: str, random: np.random.Generator, spread: float) -> Feature:
    axes = random.permutation(3)
    signs = random.choice((-1.0, 1.0), 3)
    free = {FACE: 2, EDGE: 1, CORNER: 0}[kind]
    point = signs * half
    point[axes[:free]] *= random.uniform(-spread, spread, free)
    weights = np.zeros(3)
    weights[axes[free:]] = random.uniform(0.3, 1.0, 3 - free)
    outward = signs * weights
    along = np.eye(3)[axes[0]] if free else across(outward)
    return Feature(point, outward / np.linalg.norm(outward), along)


def _of_cylinder(shape: Cylinder, kind: str, random: np.random.Generator, spread: float) -> Feature:
    angle = random.uniform(0.0, math.tau)
    radial = np.array((math.cos(angle), math.sin(angle), 0.0))
    axial = np.array((0.0, 0.0, float(random.choice((-1.0, 1.0)))))
    round_ = np.cross(axial, radial)
    if kind == FACE:
        point = shape.half_length * axial + random.uniform(0, spread) * shape.radius * radial
        return Feature(point, axial, radial)
    if kind == EDGE:  # its side
        point = shape.radius * radial + random.uniform(-0.8, 0.8) * shape.half_length * axial
        return Feature(point, radial, axial)
    outward = random.uniform(0.3, 1.0) * radial + random.uniform(0.3, 1.0) * axial
    point = shape.radius * radial + shape.half_length * axial
    return Feature(point, outward / np.linalg.norm(outward), round_)


def _of_hull(points: Array, kind: str, random: np.random.Generator) -> Feature:
    hull = ConvexHull(points)
    number = int(random.integers(len(hull.simplices)))
    normal, corners = hull.equations[number, :3], points[hull.simplices[number]]
    along = corners[1] - corners[0]
    along /= np.linalg.norm(along)
    if kind == FACE:
        return Feature(random.dirichlet((1.0, 1.0, 1.0)) @ corners, normal, along)
    if kind == EDGE:
        beside = next(
            k
            for k in hull.neighbors[number]
            if len(set(hull.simplices[k]) & set(hull.simplices[number][:2])) == 2
        )
        outward = normal + random.uniform(0.3, 1.0) * hull.equations[beside, :3]
        point = corners[0] + random.uniform(0.1, 0.9) * (corners[1] - corners[0])
        return Feature(point, outward / np.linalg.norm(outward), along)
    outward = random.normal(size=3)
    outward /= np.linalg.norm(outward)
    return Feature(points[int((points @ outward).argmax())], outward, across(outward))


def facing(
    first: Feature, rotation: Array, origin: Array, second: Feature, gap: float, twist: float
) -> tuple[Array, Array]:
    """Return rotation and origin of a second shape that faces a first across a gap.

    Args:
        first: Feature of the first shape.
        rotation: Of the first shape in W.
        origin: Of the first shape in W [m].
        second: Feature of the second shape.
        gap: Between the two, along the direction out of the first; below zero they overlap [m].
        twist: From one `along` to the other [rad].
    """
    out, along = rotation @ first.outward, rotation @ first.along
    across = np.cross(out, along)
    turned = math.cos(twist) * along + math.sin(twist) * across
    world = np.column_stack([-out, turned, np.cross(-out, turned)])
    local = np.column_stack([second.outward, second.along, np.cross(second.outward, second.along)])
    there = world @ local.T
    point = origin + rotation @ first.point + gap * out
    return there, point - there @ second.point


def across(way: Array) -> Array:
    """Return a unit vector across another."""
    axis = np.zeros(3)
    axis[int(np.argmin(np.abs(way)))] = 1.0
    found = np.cross(way, axis)
    return found / np.linalg.norm(found)
