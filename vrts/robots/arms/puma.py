"""The Unimation PUMA 761 and 762 as data: every number with its source, or the word assumed.

Sources: *maker's drawing*, the workspace and range drawings of the 700 series; *762 model*, a
public CAD-derived model of a real PUMA 762 (dimensions only). See [manual robots/puma761,
robots/puma762].
"""

import math

from vrts.base.units import DEG, MM
from vrts.robots.arms.primitives import box, cylinder, degrees, hull, ring
from vrts.robots.model import Configuration, Link, SphericalWristArm

READY: Configuration = (0.0, -90.0 * DEG, 90.0 * DEG, 0.0, 0.0, 0.0)  # arm straight up


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
        neck = hull(front + [(x, neck_end, y) for x, y, _ in ring(63.5, 0)])
    else:
        neck = cylinder((0, -437.25, 0), "y", 63.5, 57.25)
    housing = [(s * 125.0, y, -35.0) for s in (-1, 1) for y in (-240.0, -85.0)]
    housing += [(s * 80.0, y, 265.0) for s in (-1, 1) for y in (-203.0, -123.0)]
    return (
        Link(
            "base",
            0,
            (
                cylinder((0, 0, -1082.5), "z", 300, 37.5),
                cylinder((0, 0, -970), "z", 260, 75),
                hull(ring(260, -895) + ring(125, -185)),
            ),
        ),
        Link(
            "turret",
            1,
            (
                cylinder((0, 0, -157), "z", 175, 32),
                box((0, -17, -80), (125, 223.5, 45)),
                cylinder((0, 60.5, 0), "y", 125, 146),
                hull(housing),
            ),
        ),
        Link(
            "upper arm",
            2,
            (
                cylinder((0, 0, 238.5), "z", 175, 32),
                box((-320, 0, 363), (320, 192.5, 92.5)),
                hull(shoulder_end + elbow),
                cylinder((650, 0, 264.5), "z", 137, 6),
            ),
        ),
        Link("forearm", 3, (box((0, 195, 0), (137, 195, 68.5)), hull(taper + front), neck)),
        Link(
            "wrist",
            4,
            (
                cylinder((0, 0, d4 - 90), "z", 63.5, 15.5),
                cylinder((0, 0, d4), "y", 76.2, 40),
                box((0, 0, d4 - 60), (60, 40, 20)),
            ),
        ),
        Link(
            "wrist bend",
            5,
            (cylinder((0, 0, 0), "z", 71.2, 88.9), box((0, -80, 0), (63.5, 32.1, 88.9))),
        ),
        Link("flange", 6, (cylinder((0, 0, 118), "z", 50, 7),)),
    )


SKIPPED = frozenset(
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
        lower=degrees(-160, -200, -45, -266, -100, -300),  # maker's drawing for the totals
        upper=degrees(160, 20, 225, 266, 100, 300),
        speed=degrees(90, 90, 90, 180, 180, 180),  # assumed: no published speeds
        ready=READY,
        linear_speed=1000 * MM,  # assumed
        angular_speed=100 * DEG,  # assumed
        acceleration_time=0.224,  # 8 ticks, the nearest to a quarter second [assumed]
        tick=0.028,  # [FGL1987]_, section 5.3.1, from memory
        links=_links_700(d4),
        skipped_pairs=SKIPPED,
    )


PUMA_761 = _arm_700("puma761", "Unimation PUMA 761", 850)  # d4: maker's drawing, reach 1500 mm
PUMA_762 = _arm_700("puma762", "Unimation PUMA 762", 600)  # d4: 762 model
