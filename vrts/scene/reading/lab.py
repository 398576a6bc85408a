"""A lab file: the robot, hand and table of one's own laboratory, laid over any scene.

A lab file has nothing but `[lab]` and its parts. It is read as if it stood at the end of the scene,
so a scene with its lab is one text, with one hash. What a part says counts in place of what the
scene says; what it does not say stays.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.base.source import SourceFile
from vrts.base.toml.appended import Appended
from vrts.base.toml.reading import Table, read_toml

NOT_OF_LAB = Rule("V640", "not-of-a-lab")
LAB_TABLE = Rule("V641", "lab-table")
TWO_LABS = Rule("V644", "two-labs")

SECTION = "lab"
PARTS = ("robot", "gripper", "table", "controller")
ONE_ROBOT = ("name", "urdf")  # either says which robot: then nothing of the scene's is left
TABLE = "table"  # name of the object that `[lab.table]` describes


class Lab(NamedTuple):
    """The parts of a lab, as tables of the text that holds scene and lab."""

    title: str | None = None  # None: there is no lab
    robot: Table | None = None
    gripper: Table | None = None
    table: Table | None = None
    controller: Table | None = None

    def suffix(self) -> str:
        """Return what a scene's title has in addition."""
        return "" if self.title is None else f", in {self.title}"

    def robot_over(self, own: Table | None) -> Table | None:
        """Return the section `[robot]` of a scene with that of the lab over it."""
        if self.robot is not None and any(key in self.robot for key in ONE_ROBOT):
            return self.robot
        return _over(own, self.robot)

    def gripper_over(self, own: Table | None) -> Table | None:
        """Return the section `[gripper]` of a scene with that of the lab over it."""
        return _over(own, self.gripper)

    def controller_over(self, own: Table | None) -> Table | None:
        """Return the section `[controller]` of the lab, else that of the scene."""
        return self.controller or own

    def objects_over(self, own: Sequence[tuple[str, Table]]) -> tuple[tuple[str, Table], ...]:
        """Return the objects of a scene, with what the lab says about the table."""
        if self.table is None:
            return tuple(own)
        if TABLE not in (name for name, _ in own):
            self.table.problems.warning(
                LAB_TABLE,
                f"the scene has no object `{TABLE}`, so the table of the lab is left out",
                self.table.span,
                help=(f"give the scene's table the name `{TABLE}`",),
            )
        return tuple(
            (name, section.overlaid(self.table) if name == TABLE else section)
            for name, section in own
        )


def read_lab(top: Table) -> Lab:
    """Return the parts of a lab in a text; no parts where there is none."""
    section = top.table(SECTION)
    if section is None:
        return Lab()
    title = section.string("title", "the lab")
    robot, gripper, table, controller = (section.table(part) for part in PARTS)
    section.finish()
    return Lab(title, robot, gripper, table, controller)


def laid_over(scene: SourceFile, lab: SourceFile) -> tuple[Appended | None, tuple[Diagnostic, ...]]:
    """Return a scene with a lab at its end, or None and why they cannot be one text."""
    top, problems = read_toml(lab)
    if top is None:
        return None, problems.in_order()
    own, told = read_toml(scene)
    if own is None:
        return None, told.in_order()
    for key in top.keys:
        if key == SECTION:
            continue
        remedy = f"write it as `[{SECTION}.{key}]`" if key in PARTS else "scenes describe the rest"
        known = ", ".join(f"`[{SECTION}.{part}]`" for part in PARTS)
        problems.error(
            NOT_OF_LAB,
            f"`{key}` is no part of a lab",
            top.span_of(key),
            notes=(f"a lab has `[{SECTION}]`, {known}",),
            help=(remedy,),
        )
    if not top.keys:
        problems.error(NOT_OF_LAB, "there is nothing in the lab", None)
    elif SECTION in own and SECTION in top:
        problems.error(
            TWO_LABS,
            "the scene has a lab of its own",
            top.span_of(SECTION),
            notes=(f"`{scene.name}` has a section `[{SECTION}]`",),
            help=("take the section out of the scene",),
        )
    return None if problems.any_error else Appended(scene, lab), problems.in_order()


def in_lab(d: Diagnostic, lab: SourceFile) -> Diagnostic:
    """Return what is said of a scene with a note on the lab, which may be what is wrong."""
    if d.primary is not None and d.primary.span.source is lab:
        return d
    return replace(d, notes=(*d.notes, f"with `{lab.name}` laid over the scene"))


def _over(own: Table | None, upper: Table | None) -> Table | None:
    if own is None or upper is None:
        return own or upper
    return own.overlaid(upper)
