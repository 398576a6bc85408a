"""The robot as it was found, on the operator's sheet: what stands off, and how surely."""

from collections.abc import Iterator

from vrts.base.units import DEG, MM
from vrts.report.page.html import Markup, element
from vrts.robots.built import NAMES
from vrts.robots.model import Arm, Built

LENGTHS = ("links", "tool", "base")
SHOWN, HIDDEN = "encoders show it", "encoders do not show it"


def found_robot(arm: Arm) -> Iterator[Markup]:
    """Yield what a lab says of how an arm stands; nothing where it stands as it counts."""
    if arm.built is None:
        return
    yield element("h2", "The robot as it was found, by the lab: verified so, not as it counts")
    lines = [element("tr", *(element("td", cell) for cell in line)) for line in stated(arm.built)]
    yield element("table", *lines)
    yield element(
        "p",
        "Whoever puts one of these right at the robot has to plan again without it.",
        class_="for",
    )


def stated(built: Built) -> Iterator[tuple[str, str, str]]:
    """Yield name, number with its half interval, and remark of all that stands off or may."""
    for field, names in NAMES.items():
        unit, word = (MM, "mm") if field in LENGTHS else (DEG, "deg")
        values, halves = getattr(built.off, field), getattr(built.within.off, field)
        remark = {"shown": SHOWN, "zeros": HIDDEN}.get(field, "")
        for name, value, half in zip(names, values, halves, strict=True):
            if value or half:
                yield name, f"{value / unit:+.3f} ± {half / unit:.3f} {word}", remark
    within = built.within
    for k, share in enumerate(within.speeds, 1):
        if share:
            yield f"speed of joint {k}", f"± {100.0 * share:.2f} %", ""
    if within.lines:
        yield "speed of straight lines", f"± {100.0 * within.lines:.2f} %", ""
    if within.acceleration_s:
        yield "time of an acceleration", f"± {1e3 * within.acceleration_s:.0f} ms", ""
    if within.blend_s:
        yield "time of a rounded corner", f"± {1e3 * within.blend_s:.0f} ms", ""
