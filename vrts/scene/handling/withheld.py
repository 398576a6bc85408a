"""Locations that a scene withholds from those who work in it: they find and teach them.

`withheld = ["can1_grip"]` at the top of a scene does not keep a secret: where the objects stand
tells it. It keeps vrts from working it out for whoever asks.
"""

import re
from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace
from difflib import get_close_matches
from types import MappingProxyType

from vrts.base.pose import Pose
from vrts.base.toml.kinds import UNKNOWN_CHOICE
from vrts.base.toml.reading import Table
from vrts.scene.model import Scene

KEY = "withheld"
SAFE = "safe"


def may_be_worked_out(name: str, objects: Iterable[str]) -> bool:
    """Return whether vrts may work out a location of a name in a scene with some objects."""
    ends = "|".join(re.escape(one.lower()) for one in objects)
    return name == SAFE or re.fullmatch(rf"(?:{ends})_(?:grip|g\d+|put\d*)", name) is not None


def read_withheld(top: Table) -> tuple[str, ...]:
    """Return which locations a scene withholds, in small letters."""
    return tuple(name.lower() for name in top.names(KEY, choices=None))


def withholding(scene: Scene, names: Iterable[str]) -> Scene:
    """Return a scene that withholds some locations more.

    Args:
        scene: The scene.
        names: Of what is withheld, in small letters.
    """
    withheld = {**scene.withheld, **{name: scene.locations.get(name) for name in names}}
    shown = {name: X_WT for name, X_WT in scene.locations.items() if name not in withheld}
    return replace(scene, locations=MappingProxyType(shown), withheld=MappingProxyType(withheld))


def all_locations(scene: Scene) -> Mapping[str, Pose]:
    """Return the locations of a scene for staff: with those that are withheld."""
    more = {name: X_WT for name, X_WT in scene.withheld.items() if X_WT is not None}
    return MappingProxyType({**scene.locations, **more})


def check_withheld(
    top: Table, withheld: Collection[str], places: Mapping[str, Pose], objects: Collection[str]
) -> None:
    """Report what is withheld and is no location: a misspelt name would be given to everybody."""
    for number, name in enumerate(withheld):
        if name in places or may_be_worked_out(name, objects):
            continue
        near = get_close_matches(name, places, 1, 0.6)
        remedy = f"did you mean `{near[0]}`?" if near else "leave it out"
        top.problems.error(
            UNKNOWN_CHOICE,
            f"the scene has no location `{name}` that it could withhold",
            top.element_span(KEY, number),
            notes=(f"known: {', '.join(f'`{one}`' for one in places) or 'none'}",),
            help=(remedy,),
        )
