"""Reads `[locations]` of a scene: places with their numbers, and places that follow others.

A place that follows another one, `can1_goal = { at = "base2_put" }`, goes where that one goes, also
where vrts has worked it out; `plus_mm` puts it beside or above.
"""

import re
from collections.abc import Iterator, Mapping

from vrts.base.diagnostic import Rule
from vrts.base.oat import pose_from_components
from vrts.base.pose import Pose, add, rotate
from vrts.base.toml.reading import Table
from vrts.base.units import MM
from vrts.scene.reading.form_section import FARTHEST

INVALID_NAME = Rule("V612", "invalid-name")

LONGEST = 15  # letters that VAL-II counts [manual language/names#length]
_NAME = re.compile(r"[a-z][a-z0-9_]*", re.IGNORECASE)


def read_locations(section: Table, X_WS: Pose) -> Mapping[str, Pose]:
    """Return the places that have numbers of their own, by name in small letters."""
    found: dict[str, Pose] = {}
    for name in section.keys:
        follows = section.holds_table(name)
        values = None
        if not follows:
            values = section.numbers(name, count=6, minimum=-FARTHEST, maximum=FARTHEST)
        if not _NAME.fullmatch(name) or len(name) > LONGEST:
            section.problems.error(
                INVALID_NAME,
                f"invalid location name `{name}`",
                section.span_of(name),
                help=("a name has letters, digits and _, begins with a letter, at most 15 long",),
            )
        elif values is not None:
            found[name.lower()] = X_WS @ pose_from_components(*values)
    return found


def read_following(
    section: Table, known: Mapping[str, Pose], X_WS: Pose
) -> Iterator[tuple[str, Pose]]:
    """Yield the places that follow others, in the order of the file.

    Args:
        section: `[locations]`.
        known: Every other place of the scene, with those that vrts has worked out.
        X_WS: Pose of the scene's frame, along which `plus_mm` is.
    """
    found = dict(known)
    for name in section.keys:
        table = section.table(name) if section.holds_table(name) else None
        if table is None:
            continue
        other = table.string("at", choices=found, required=True)
        x, y, z = table.numbers(
            "plus_mm", (0.0, 0.0, 0.0), count=3, minimum=-FARTHEST, maximum=FARTHEST
        ) or (0.0, 0.0, 0.0)
        table.finish()
        if other is None:
            continue
        shift = rotate(X_WS.rotation, (x * MM, y * MM, z * MM))
        pose = found[other]
        found[name.lower()] = Pose(pose.rotation, add(pose.translation, shift))
        yield name.lower(), found[name.lower()]
