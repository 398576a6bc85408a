"""The hand on every flange: two fingers, closed and opened by air."""

from vrts.base.pose import translation
from vrts.base.units import MM
from vrts.robots.model import Finger, Gripper
from vrts.robots.primitives import box, cylinder


def _finger(name: str, side: int) -> Finger:
    return Finger(name, side, (box((0, side * 10, 130), (12, 10, 35)),))


TWO_FINGERS = (
    Gripper(  # the whole gripper is assumed: no drawing of the laboratory's hand was found
        name="pneumatic",
        opening_min=0.0,
        opening_max=80 * MM,
        stroke_time=0.30,  # [s] full stroke
        body=(cylinder((0, 0, 7.5), "z", 45, 7.5), box((0, 0, 55), (30, 70, 40))),
        fingers=(_finger("left finger", 1), _finger("right finger", -1)),
        X_FP=translation(0.0, 0.0, 150 * MM),
        pad_width=24 * MM,
        pad_length=30 * MM,  # of the finger's 70 mm: 15 mm either side of the pad centre
        overlap_min=5 * MM,
    )
)
