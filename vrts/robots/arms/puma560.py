"""The Unimation PUMA 560 as data: kinematics from [Lee1984]_ and [FGL1987]_, shape assumed.

See [manual robots/puma560].
"""

import math

from vrts.base.units import DEG, MM
from vrts.robots.arms.primitives import box, cylinder, degrees, hull, ring
from vrts.robots.arms.puma import READY, SKIPPED
from vrts.robots.model import Link, SphericalWristArm


def _links() -> tuple[Link, ...]:
    """Return convex pieces in the proportions of the 700 series [mm; the whole shape is assumed].

    Lengths along the arm follow the kinematics, so that the elbow and the wrist are where they
    are; thicknesses are what the offset of the shoulder leaves room for.
    """
    elbow = [
        (431.8 + 80 * math.cos(a), 80 * math.sin(a), z)
        for a in (math.pi * (k / 12 - 0.5) for k in range(13))
        for z in (208.0, 292.0)
    ]
    shoulder_end = [(0.0, side * 115.0, z) for side in (-1, 1) for z in (208.0, 300.0)]
    back = [(s * 78.0 - 10.0, 0.0, t * 50.0) for s in (-1, 1) for t in (-1, 1)]
    front = [(x, -335.0, z) for x, z, _ in ring(45.0, 0.0)]
    return (
        Link(
            "base",
            0,
            (
                cylinder((0, 0, -656.8), "z", 150, 15),
                hull(ring(105, -641.8) + ring(92, -170)),
            ),
        ),
        Link(
            "turret",
            1,
            (
                cylinder((0, 0, -132), "z", 92, 37),
                cylinder((0, 35, 0), "y", 98, 135),
            ),
        ),
        Link(
            "upper arm",
            2,
            (
                cylinder((0, 0, 189), "z", 105, 19),
                box((-110, 0, 254), (110, 115, 46)),
                hull(shoulder_end + elbow),
                cylinder((431.8, 0, 204), "z", 80, 4),
            ),
        ),
        Link(
            "forearm",
            3,
            (
                box((-10, 45, 0), (78, 45, 50)),
                hull(back + [(x - 20.32, y, z) for x, y, z in front]),
            ),
        ),
        Link(
            "wrist",
            4,
            (
                cylinder((0, 0, 433.07 - 75), "z", 45, 22),
                cylinder((0, 0, 433.07), "y", 40, 30),
                box((0, 0, 433.07 - 45), (36, 30, 12)),
            ),
        ),
        Link(
            "wrist bend",
            5,
            (cylinder((0, 0, 0), "z", 38, 45), box((0, -40, 0), (32, 6, 40))),
        ),
        Link("flange", 6, (cylinder((0, 0, 51.125), "z", 31.75, 5.125),)),
    )


PUMA_560 = SphericalWristArm(
    name="puma560",
    title="Unimation PUMA 560",
    a2=431.8 * MM,  # [Lee1984]_
    a3=-20.32 * MM,  # [Lee1984]_
    d2=149.09 * MM,  # [Lee1984]_
    d4=433.07 * MM,  # [Lee1984]_
    d6=56.25 * MM,  # [Lee1984]_, from memory
    shoulder_height=671.8 * MM,  # 26.45 inch, public toolbox model
    lower=degrees(-160, -225, -45, -110, -100, -266),  # [Lee1984]_
    upper=degrees(160, 45, 225, 170, 100, 266),
    speed=degrees(82, 74, 122, 228, 241, 228),  # from memory, unverified
    ready=READY,
    linear_speed=508 * MM,  # 20 inch/s [assumed]
    angular_speed=90 * DEG,  # assumed
    acceleration_time=0.224,  # assumed
    tick=0.028,  # [FGL1987]_, from memory
    links=_links(),
    skipped_pairs=SKIPPED,
)
