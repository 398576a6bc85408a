"""The Unimation PUMA family as data. Every number has its source beside it, or the word assumed.

Sources: *maker's drawing*, the workspace and range drawings of the 700 series; *762 model*, a
public CAD-derived model of a real PUMA 762 (dimensions only); [Lee1984]_ and [FGL1987]_ for
the 560.
"""

import math

from vrts.base.pose import X_AXIS, Y_AXIS, Pose, Vector, rotation_about, translation
from vrts.base.units import DEG, MM
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece
from vrts.robots.model import Configuration, Finger, Gripper, Link, SphericalWristArm

FACETS = 24  # corners of a tapered round part; the polygon lies inside the circle by at most 0.9 %

READY: Configuration = (0.0, -90.0 * DEG, 90.0 * DEG, 0.0, 0.0, 0.0)  # arm straight up


def _degrees(*values: float) -> Configuration:
    a, b, c, d, e, f = (value * DEG for value in values)
    return (a, b, c, d, e, f)


def _box(centre: Vector, half: Vector) -> Piece:
    return Piece(Box((half[0] * MM, half[1] * MM, half[2] * MM)), _at(centre))


def _cylinder(centre: Vector, axis: str, radius: float, half_length: float) -> Piece:
    turn = {
        "x": rotation_about(Y_AXIS, math.pi / 2),
        "y": rotation_about(X_AXIS, -math.pi / 2),
        "z": rotation_about(X_AXIS, 0.0),
    }[axis]
    return Piece(Cylinder(radius * MM, half_length * MM), Pose(turn, _at(centre).translation))


def _hull(points: list[Vector]) -> Piece:
    return Piece(Hull(tuple((x * MM, y * MM, z * MM) for x, y, z in points)), translation(0, 0, 0))


def _at(centre: Vector) -> Pose:
    return translation(centre[0] * MM, centre[1] * MM, centre[2] * MM)


def _ring(radius: float, z: float) -> list[Vector]:
    steps = (math.tau * k / FACETS for k in range(FACETS))
    return [(radius * math.cos(a), radius * math.sin(a), z) for a in steps]


def _links_700(d4: float) -> tuple[Link, ...]:
    """Return convex pieces of a 700-series arm [mm], fitted to the extents of the 762 model.

    The 761 is the 762 with a forearm longer in front of the elbow. The surface of the model stands
    out of these pieces by at most 3.8 mm.
    """
    neck_end = -(d4 - 105.5)
    elbow = [
        (650 + 137 * math.cos(a), 137 * math.sin(a), z)
        for a in (math.pi * (k / 12 - 0.5) for k in range(13))
        for z in (270.5, 435.5)
    ]
    shoulder_end = [(0.0, side * 192.5, z) for side in (-1, 1) for z in (270.5, 455.5)]
    taper = [(s * 137.0, 0.0, t * 68.5) for s in (-1, 1) for t in (-1, 1)]
    front = [(s * 97.5, -380.0, t * 68.5) for s in (-1, 1) for t in (-1, 1)]
    if d4 > 600:
        neck = _hull(front + [(x, neck_end, y) for x, y, _ in _ring(63.5, 0)])
    else:
        neck = _cylinder((0, -437.25, 0), "y", 63.5, 57.25)
    housing = [(s * 125.0, y, -35.0) for s in (-1, 1) for y in (-240.0, -85.0)]
    housing += [(s * 80.0, y, 265.0) for s in (-1, 1) for y in (-203.0, -123.0)]
    return (
        Link(
            "base",
            0,
            (
                _cylinder((0, 0, -1082.5), "z", 300, 37.5),
                _cylinder((0, 0, -970), "z", 260, 75),
                _hull(_ring(260, -895) + _ring(125, -185)),
            ),
        ),
        Link(
            "turret",
            1,
            (
                _cylinder((0, 0, -157), "z", 175, 32),
                _box((0, -17, -80), (125, 223.5, 45)),
                _cylinder((0, 60.5, 0), "y", 125, 146),
                _hull(housing),
            ),
        ),
        Link(
            "upper arm",
            2,
            (
                _cylinder((0, 0, 238.5), "z", 175, 32),
                _box((-320, 0, 363), (320, 192.5, 92.5)),
                _hull(shoulder_end + elbow),
                _cylinder((650, 0, 264.5), "z", 137, 6),
            ),
        ),
        Link("forearm", 3, (_box((0, 195, 0), (137, 195, 68.5)), _hull(taper + front), neck)),
        Link(
            "wrist",
            4,
            (
                _cylinder((0, 0, d4 - 90), "z", 63.5, 15.5),
                _cylinder((0, 0, d4), "y", 76.2, 40),
                _box((0, 0, d4 - 60), (60, 40, 20)),
            ),
        ),
        Link(
            "wrist bend",
            5,
            (_cylinder((0, 0, 0), "z", 71.2, 88.9), _box((0, -80, 0), (63.5, 32.1, 88.9))),
        ),
        Link("flange", 6, (_cylinder((0, 0, 118), "z", 50, 7),)),
    )


SKIPPED_700 = frozenset(
    frozenset(pair)
    for pair in (
        ("base", "turret"),
        ("turret", "upper arm"),
        ("upper arm", "forearm"),
        ("forearm", "wrist"),
        ("forearm", "wrist bend"),
        ("wrist", "wrist bend"),
        ("wrist", "flange"),
        ("wrist bend", "flange"),
        ("wrist bend", "hand"),
        ("flange", "hand"),
    )
)  # neighbours, which touch by construction, and those joined within the wrist


def _arm_700(name: str, title: str, d4: float) -> SphericalWristArm:
    return SphericalWristArm(
        name=name,
        title=title,
        a2=650 * MM,  # 762 model
        a3=0.0,  # 762 model
        d2=190 * MM,  # 762 model
        d4=d4 * MM,
        d6=125 * MM,  # table of a public copy of the 762 model; unverified
        shoulder_height=1120 * MM,  # 762 model
        lower=_degrees(-160, -200, -45, -266, -100, -300),  # maker's drawing for the totals
        upper=_degrees(160, 20, 225, 266, 100, 300),
        speed=_degrees(90, 90, 90, 180, 180, 180),  # assumed: no published speeds
        ready=READY,
        linear_speed=1000 * MM,  # assumed
        angular_speed=100 * DEG,  # assumed
        acceleration_time=0.224,  # 8 ticks, the nearest to a quarter second [assumed]
        tick=0.028,  # [FGL1987]_, section 5.3.1, from memory
        links=_links_700(d4),
        skipped_pairs=SKIPPED_700,
    )


PUMA_761 = _arm_700("puma761", "Unimation PUMA 761", 850)  # d4: maker's drawing, reach 1500 mm
PUMA_762 = _arm_700("puma762", "Unimation PUMA 762", 600)  # d4: 762 model

PUMA_560 = SphericalWristArm(  # kinematics only: no geometry, so no scene takes it yet
    name="puma560",
    title="Unimation PUMA 560",
    a2=431.8 * MM,  # [Lee1984]_
    a3=-20.32 * MM,  # [Lee1984]_
    d2=149.09 * MM,  # [Lee1984]_
    d4=433.07 * MM,  # [Lee1984]_
    d6=56.25 * MM,  # [Lee1984]_, from memory
    shoulder_height=671.8 * MM,  # 26.45 inch, public toolbox model
    lower=_degrees(-160, -225, -45, -110, -100, -266),  # [Lee1984]_
    upper=_degrees(160, 45, 225, 170, 100, 266),
    speed=_degrees(82, 74, 122, 228, 241, 228),  # from memory, unverified
    ready=READY,
    linear_speed=508 * MM,  # 20 inch/s [assumed]
    angular_speed=90 * DEG,  # assumed
    acceleration_time=0.224,  # assumed
    tick=0.028,  # [FGL1987]_, from memory
    links=(),
    skipped_pairs=frozenset(),
)


def _finger(name: str, side: int) -> Finger:
    return Finger(name, side, (_box((0, side * 10, 130), (12, 10, 35)),))


TWO_FINGERS = (
    Gripper(  # the whole gripper is assumed: no drawing of the laboratory's hand was found
        name="pneumatic",
        opening_min=0.0,
        opening_max=80 * MM,
        stroke_time=0.30,  # [s] full stroke
        body=(_cylinder((0, 0, 7.5), "z", 45, 7.5), _box((0, 0, 55), (30, 70, 40))),
        fingers=(_finger("left finger", 1), _finger("right finger", -1)),
        X_FP=translation(0.0, 0.0, 150 * MM),
        pad_width=24 * MM,
        pad_length=30 * MM,  # of the finger's 70 mm: 15 mm either side of the pad centre
        overlap_min=5 * MM,
    )
)
