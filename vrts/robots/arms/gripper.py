"""The hand on every flange: two fingers, closed and opened by air [manual robots/grippers]."""

from typing import NamedTuple

from vrts.base.pose import translation
from vrts.base.units import MM
from vrts.robots.arms.primitives import box, cylinder
from vrts.robots.model import Finger, Gripper

PLATE_RADIUS, PLATE = 45.0, 15.0  # [mm] of the round plate between flange and palm


class Measures(NamedTuple):
    """What differs between two hands of this kind, in mm and seconds.

    The whole hand is assumed: no drawing of the laboratory's was found.
    """

    length: float = 150.0  # from the flange to the middle of the pads
    opening: tuple[float, float] = (0.0, 80.0)  # closed and open, from pad to pad
    stroke_s: float = 0.30  # from closed to open [s]
    palm: tuple[float, float, float] = (60.0, 140.0, 80.0)  # along x, y and z of the flange
    finger: tuple[float, float, float] = (24.0, 20.0, 70.0)  # width, thickness, length
    pad: tuple[float, float] = (24.0, 30.0)  # width and length, at the tip of a finger

    @property
    def palm_end(self) -> float:
        """How far the palm reaches from the flange [mm]."""
        return PLATE + self.palm[2]

    @property
    def tip(self) -> float:
        """How far the fingers reach from the flange [mm]."""
        return self.length + self.pad[1] / 2.0


def two_fingers(m: Measures) -> Gripper:
    """Return a hand of some measures."""
    x, y, z = m.palm
    return Gripper(
        name="pneumatic",
        opening_min=m.opening[0] * MM,
        opening_max=m.opening[1] * MM,
        stroke_time=m.stroke_s,
        body=(
            cylinder((0, 0, PLATE / 2), "z", PLATE_RADIUS, PLATE / 2),
            box((0, 0, PLATE + z / 2), (x / 2, y / 2, z / 2)),
        ),
        fingers=(_finger("left finger", 1, m), _finger("right finger", -1, m)),
        X_FP=translation(0.0, 0.0, m.length * MM),
        pad_width=m.pad[0] * MM,
        pad_length=m.pad[1] * MM,
        overlap_min=5 * MM,
    )


def _finger(name: str, side: int, m: Measures) -> Finger:
    width, thickness, length = m.finger
    centre = (0.0, side * thickness / 2, m.tip - length / 2)
    return Finger(name, side, (box(centre, (width / 2, thickness / 2, length / 2)),))


TWO_FINGERS = two_fingers(Measures())
