"""The section `[gripper]` of a scene or a lab: a hand of two fingers by its measures."""

from typing import cast

from vrts.base.diagnostic import Rule
from vrts.base.toml.reading import Table
from vrts.robots.arms.gripper import TWO_FINGERS, Measures, two_fingers
from vrts.robots.model import Gripper

HAND_MEASURES = Rule("V642", "hand-measures")

LONGEST = 1000.0  # [mm]
LEAST_PAD = 10.0  # [mm]
USUAL = Measures()


def read_gripper(section: Table | None) -> Gripper:
    """Return the hand that a section describes, the usual one where there is none.

    What is wrong is reported; the usual hand then stands in for the rest of the reading.
    """
    if section is None:
        return TWO_FINGERS
    before = len(section.problems.found)
    opening = section.numbers("opening_mm", USUAL.opening, count=2, minimum=0.0, maximum=LONGEST)
    palm = section.numbers("palm_mm", USUAL.palm, count=3, above=0.0, maximum=LONGEST)
    finger = section.numbers("finger_mm", USUAL.finger, count=3, above=0.0, maximum=LONGEST)
    pad = section.numbers("pad_mm", USUAL.pad, count=2, minimum=LEAST_PAD, maximum=LONGEST)
    measures = Measures(
        section.number("length_mm", USUAL.length, above=0.0, maximum=LONGEST),
        cast("tuple[float, float]", opening),
        section.number("stroke_s", USUAL.stroke_s, minimum=0.01, maximum=60.0),
        cast("tuple[float, float, float]", palm),
        cast("tuple[float, float, float]", finger),
        cast("tuple[float, float]", pad),
    )
    section.finish()
    if len(section.problems.found) == before:
        _check(measures, section)
    return TWO_FINGERS if len(section.problems.found) > before else two_fingers(measures)


def _check(m: Measures, section: Table) -> None:
    """Report measures that cannot belong to one hand, the first of them."""
    closed, opened = m.opening
    start = m.tip - m.finger[2]  # of the fingers, from the flange
    if closed >= opened:
        key, why = "opening_mm", f"it is {closed:g} mm open when closed, and {opened:g} when open"
        remedy = "write the opening of the closed hand first"
    elif m.pad[0] > m.finger[0] or m.pad[1] > m.finger[2]:
        key, why = "pad_mm", "its pads are larger than its fingers"
        remedy = "`pad_mm` is width and length, `finger_mm` width, thickness and length"
    elif m.tip - m.pad[1] < m.palm_end:
        inside = m.palm_end - m.tip + m.pad[1]
        key, why = "length_mm", f"its pads would be {inside:g} mm inside its palm"
        remedy = "`length_mm` is from the flange to the middle of the pads"
    elif start > m.palm_end:
        key, why = "finger_mm", f"its fingers begin {start - m.palm_end:g} mm in front of its palm"
        remedy = "make the fingers longer, or the palm: the third number of `palm_mm`"
    else:
        return
    given = key if key in section else next(iter(section.keys))
    section.problems.error(
        HAND_MEASURES,
        "these measures do not make a hand",
        section.value_span(given),
        why,
        help=(remedy,),
        data={"key": key},
    )
