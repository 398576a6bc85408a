"""The part of a README that tells one variant's numbers: what stands where, and what is given."""

from collections.abc import Collection

from vrts.assignments.handed.words import number, place, title, turn
from vrts.base.pose import IDENTITY_ROTATION, Pose
from vrts.base.units import mm
from vrts.geometry.support import bounds
from vrts.scene.colors import NAMED, color, hex_code
from vrts.scene.model import Body, Scene

MAP = "pictures/your-scene.svg"
BEGIN = "<!-- vrts: what counts"  # the part that is written from the task
HEADING = "## Your variant"

_NAMES = {hex_code(found): name for name in NAMED if (found := color(name)) is not None}


def tag_line(tag: str) -> str:
    """Return the comment of a program that says to which variant it belongs."""
    return f"; variant {tag}"


def your_numbers(scene: Scene, tag: str, staff_names: Collection[str]) -> str:
    """Return the part about one variant, as Markdown.

    Args:
        scene: Of the variant.
        tag: Of the variant.
        staff_names: Locations that are not given.
    """
    bodies = [body for body in scene.bodies if body.name != "floor"]
    given = [name for name in scene.locations if name not in staff_names]
    taught = scene.withheld or any(name in staff_names for name in scene.locations)
    lines = [
        HEADING,
        "",
        f"You have the variant `{tag}`: these numbers are yours. Leave the line",
        f"`{tag_line(tag)}` in your program.",
        "",
        "What stands where, in mm: X, Y and Z of the middle of its underside, and how large it is",
        "along X, Y and Z.",
        "",
        "| object | X | Y | Z | turned | size | color |",
        "|---|---:|---:|---:|---:|---|---|",
        *map(_row, bodies),
        "",
        f"![Your scene from above and from the side]({MAP})",
    ]
    if given:
        lines += ["", "Places of the hand that are given to you:", ""]
        lines += [f"- `{name}`: {place(scene.locations[name].translation)}" for name in given]
    if taught:
        lines += ["", "All other places you find and teach yourself."]
    return "\n".join(lines) + "\n"


def with_part(page: str, part: str) -> str:
    """Return a README with a part before the one that is written from the task."""
    at = page.find(f"\n{BEGIN}") + 1
    if not at:
        return f"{page.rstrip()}\n\n{part}"
    return f"{page[:at].rstrip()}\n\n{part}\n{page[at:]}"


def _row(body: Body) -> str:
    x, y, z = (number(mm(value)) for value in body.X_WO.translation)
    box = bounds(body.pieces, Pose(IDENTITY_ROTATION, (0.0, 0.0, 0.0)))
    size = " × ".join(number(mm(b - a), 1) for a, b in zip(*box, strict=True))
    name = f"`{body.name}`" + (f", {title(body.title)}" if body.title != body.name else "")
    turned = turn(body.X_WO).removeprefix("turned by ")
    code = hex_code(body.color)
    return f"| {name} | {x} | {y} | {z} | {turned} | {size} | {_NAMES.get(code, code)} |"
