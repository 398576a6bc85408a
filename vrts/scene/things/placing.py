"""Puts the objects of a scene where they stand, each on what it is said to stand on."""

from collections.abc import Mapping
from typing import NamedTuple

from vrts.base.diagnostic import Rule
from vrts.base.pose import Z_AXIS, Pose, rotation_about
from vrts.base.toml.reading import Problems, Table
from vrts.base.units import MM
from vrts.geometry.support import bounds
from vrts.scene.colors import Color
from vrts.scene.model import Body, Mobility
from vrts.scene.things.forms import Form

UNKNOWN_SUPPORT = Rule("V616", "unknown-support")
CIRCULAR_SUPPORT = Rule("V617", "circular-support")


class Draft(NamedTuple):
    """An object as far as it can be read without the others."""

    name: str
    section: Table
    kind: str
    title: str
    form: Form
    at: tuple[float, ...]  # x, y and perhaps z of the underside [mm]
    turn: float  # [rad]
    on: str | None
    fixed: bool
    color: Color


class Placer:
    """Puts objects on what they stand on, supports first."""

    def __init__(
        self,
        drafts: Mapping[str, Draft],
        declared: frozenset[str],
        floor: Body,
        X_WS: Pose,
        problems: Problems,
    ) -> None:
        """Keep what was read; `declared` are all names, also of objects that could not be read."""
        self.drafts = drafts
        self.X_WS = X_WS  # the frame of the file
        self.declared = declared
        self.problems = problems
        self.bodies: dict[str, Body] = {floor.name: floor}
        self.failed: set[str] = set()

    def place_all(self) -> tuple[Body, ...]:
        """Return the floor and every object that could be placed, in the order of the file."""
        for draft in self.drafts.values():
            self.place(draft, ())
        order = [name for name in self.drafts if name in self.bodies]
        return (self.bodies["floor"], *(self.bodies[name] for name in order))

    def place(self, draft: Draft, above: tuple[str, ...]) -> Body | None:
        """Return an object at its place; `above` are those that wait for it."""
        if draft.name in self.bodies or draft.name in self.failed:
            return self.bodies.get(draft.name)
        if draft.name in above:
            self.problems.error(
                CIRCULAR_SUPPORT,
                f"`{draft.name}` stands on itself: {' on '.join((*above, draft.name))}",
                draft.section.value_span("on"),
                help=("the lowest object stands on the table or on the floor",),
            )
            self.failed.update(above)
            return None
        z = draft.at[2] * MM if len(draft.at) == 3 else self._top_of_support(draft, above)
        if z is None:
            self.failed.add(draft.name)
            return None
        form = draft.form
        X_SO = Pose(rotation_about(Z_AXIS, draft.turn), (draft.at[0] * MM, draft.at[1] * MM, z))
        body = Body(
            draft.name,
            draft.title,
            draft.kind,
            Mobility.FIXED if draft.fixed else Mobility.MOVABLE,
            form.pieces,
            self.X_WS @ X_SO,
            draft.color,
            form.centre_of_mass,
            form.symmetry_axis,
            None,
            draft.section.name_span,
            form.paint,
            form.grips,
        )
        self.bodies[draft.name] = body
        return body

    def _top_of_support(self, draft: Draft, above: tuple[str, ...]) -> float | None:
        on = draft.on or "floor"
        support = self.bodies.get(on)
        if support is None and on in self.drafts:
            support = self.place(self.drafts[on], (*above, draft.name))
        if support is not None:
            return bounds(support.pieces, support.X_WO).upper[2]
        if on not in self.declared:
            span = draft.section.value_span("on")
            known = ", ".join(f"`{name}`" for name in ("floor", *self.drafts))
            self.problems.error(
                UNKNOWN_SUPPORT,
                f"`{draft.name}` stands on `{on}`, which is not in the scene",
                span,
                notes=(f"there is {known}",),
                data={"name": on},
            )
        return None
