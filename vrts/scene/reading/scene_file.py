"""Reads `scene.toml`: what stands in the workspace, in millimetres and degrees.

Every fault is one diagnostic that points into the file; the reader goes on after each, so that one
pass reports them all.
"""

import hashlib
import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType

from vrts.base.diagnostic import Diagnostic, Label, Rule
from vrts.base.pose import Pose
from vrts.base.source import SourceFile
from vrts.base.toml.reading import Problems, Table, read_toml
from vrts.base.units import DEG
from vrts.robots.model import Robot
from vrts.robots.timed import timed
from vrts.scene.colors import NAMED, Color, color
from vrts.scene.default import floor_body
from vrts.scene.handling.places import check_given, find_places
from vrts.scene.handling.withheld import check_withheld, read_withheld, withholding
from vrts.scene.model import Body, Mobility, Scene
from vrts.scene.reading.controller_section import read_controller
from vrts.scene.reading.files import SceneFolder
from vrts.scene.reading.form_section import CARRIED, COLORS, FARTHEST, MAY_BE_FIXED, read_form
from vrts.scene.reading.gripper_section import read_gripper
from vrts.scene.reading.lab import in_lab, laid_over, read_lab
from vrts.scene.reading.locations_section import INVALID_NAME, read_following, read_locations
from vrts.scene.reading.robot_section import read_robot
from vrts.scene.standing import (
    check_footing,
    check_overlaps,
    check_robot,
    check_support,
    find_support,
    must_stand,
)
from vrts.scene.things.placing import Draft, Placer

NAME_CLASH = Rule("V611", "name-clash")
HEIGHT = Rule("V610", "height-of-object")
UNKNOWN_COLOR = Rule("V607", "unknown-color")

LONGEST_NAME = 10  # letters; with "_grip" it fills VAL's 15 [manual language/names#length]

_NAME = re.compile(r"[a-z][a-z0-9_]*", re.IGNORECASE)


def read_scene(
    source: SourceFile,
    folder: Path | None = None,
    *,
    name: str | None = None,
    files: Mapping[str, bytes] | None = None,
) -> tuple[Scene | None, tuple[Diagnostic, ...]]:
    """Return the scene a file describes, or None, with everything there is to say about it.

    Args:
        source: The file.
        folder: Where files that it names are; None: none can be read.
        name: Of the scene; None: as the file is named.
        files: Those that it names, by name, where they came with it; then no folder is opened.
    """
    top, problems = read_toml(source)
    place = SceneFolder(folder, given=files)
    scene = None if top is None else _scene(top, place, problems, name)
    if problems.any_error:
        scene = None
    return scene, problems.in_order()


def read_scene_in_lab(
    source: SourceFile,
    lab: SourceFile,
    folder: Path | None,
    lab_folder: Path | None,
    *,
    name: str | None = None,
) -> tuple[Scene | None, tuple[Diagnostic, ...], SourceFile]:
    """Return the scene a file describes with a lab laid over it, and the text of both.

    Args:
        source: The scene's file.
        lab: The lab's.
        folder: Where files that the scene names are.
        lab_folder: Where files that the lab names are.
        name: Of the scene; None: as its file is named.
    """
    both, found = laid_over(source, lab)
    if both is None:
        return None, found, source
    top, problems = read_toml(both.joined)
    place = SceneFolder(folder, lab_folder)
    scene = None if top is None else _scene(top, place, problems, name)
    told = tuple(in_lab(both.diagnostic(d), lab) for d in problems.in_order())
    if scene is None or problems.any_error:
        return None, told, both.joined
    bodies = tuple(
        replace(body, span=None if body.span is None else both.span(body.span))
        for body in scene.bodies
    )
    return replace(scene, bodies=bodies), told, both.joined


def scene_name(file_name: str) -> str:
    """Return the name of a scene: its folder's for `scene.toml`, else the file's."""
    parts = [part for part in re.split(r"[/\\]", file_name) if part]
    last = parts[-1].removesuffix(".toml") if parts else "scene"
    return parts[-2] if last == "scene" and len(parts) > 1 else last


def _scene(top: Table, folder: SceneFolder, problems: Problems, named: str | None) -> Scene | None:
    source = problems.source
    name = scene_name(source.name) if named is None else named
    title = top.string("title", name)
    lab = read_lab(top)
    gripper = read_gripper(lab.gripper_over(top.table("gripper")))
    arm_and_hand, X_FT, X_WS = read_robot(lab.robot_over(top.table("robot")), gripper, folder)
    model = read_controller(lab.controller_over(top.table("controller")))
    sections = lab.objects_over(top.named_tables("objects"))
    locations_section = top.table("locations")
    withheld = read_withheld(top)
    top.finish()
    drafts: dict[str, Draft] = {}
    for object_name, section in sections:
        draft = _draft(object_name, section, arm_and_hand, folder)
        if draft is not None and _acceptable(draft, drafts, arm_and_hand, problems):
            drafts[object_name] = draft
    floor = floor_body(arm_and_hand)
    declared = frozenset(object_name for object_name, _ in sections)
    bodies = Placer(drafts, declared, floor, X_WS, problems).place_all()
    given: Mapping[str, Pose] = {}
    if locations_section is not None:
        given = read_locations(locations_section, X_WS)
    scene = Scene(
        name,
        title + lab.suffix(),
        timed(arm_and_hand, model),
        X_FT,
        bodies,
        MappingProxyType({}),
        _digest(source, folder),
        model,
        MappingProxyType(dict(sorted(folder.contents.items()))),
    )
    if problems.any_error:  # geometry is looked at only when all of it is known
        return None
    check_overlaps(bodies, problems)
    check_robot(arm_and_hand, bodies, problems)
    if problems.any_error:
        return None
    scene = replace(scene, bodies=_supported(bodies, problems))
    if problems.any_error:
        return None
    places = dict(find_places(scene, given, locations_section, problems))
    if locations_section is not None:
        following = dict(read_following(locations_section, places, X_WS))
        check_given(scene, following, locations_section, problems)
        places.update(following)
    check_withheld(top, withheld, places, declared)
    if problems.any_error:
        return None
    return withholding(replace(scene, locations=places), withheld)


def _digest(source: SourceFile, folder: SceneFolder) -> str:
    """Return the hash of the file and of those it names."""
    digest = hashlib.sha256(source.text.encode())
    for name, data in sorted(folder.contents.items()):
        digest.update(f"\0{name}\0{len(data)}\0".encode())
        digest.update(data)
    return digest.hexdigest()


def _draft(name: str, section: Table, chosen: Robot, folder: SceneFolder) -> Draft | None:
    kind = section.string("kind", choices=COLORS, required=True)
    if kind is None:
        return None
    title = section.string("title", name)
    paint = _color(section, COLORS[kind])
    form = read_form(kind, section, chosen, paint, folder)
    heights = (2,) if kind == "table" else (2, 3)
    at = section.numbers("at_mm", count=heights, minimum=-FARTHEST, maximum=FARTHEST, required=True)
    turn = section.number("turn_deg", 0.0, minimum=-360.0, maximum=360.0) * DEG
    on = "floor" if kind == "table" else section.string("on")
    fixed = section.boolean("fixed", kind not in CARRIED) if kind in MAY_BE_FIXED else True
    section.finish()
    if form is None or at is None:
        return None
    if len(at) == 2 and on is None:
        section.problems.error(
            HEIGHT,
            f"the height of `{name}` is not given",
            section.span,
            help=('write on = "table", or x, y and z of its underside in `at_mm`',),
        )
        return None
    if len(at) == 3 and on is not None:
        section.problems.error(
            HEIGHT,
            f"the height of `{name}` is given twice",
            section.value_span("at_mm"),
            "by its third number",
            secondary=(Label(section.span_of("on"), "and by what it stands on"),),
            help=("leave out one of the two",),
        )
        return None
    return Draft(name, section, kind, title, form, at, turn, on, fixed, paint)


def _color(section: Table, usual: str) -> Color:
    text = section.string("color", usual)
    found = color(text)
    if found is None:
        section.problems.error(
            UNKNOWN_COLOR,
            f"unknown color `{text}`",
            section.value_span("color"),
            notes=(f"known: {', '.join(NAMED)}",),
            help=('or write red, green and blue as "#rrggbb"',),
        )
        return (0.5, 0.5, 0.5)
    return found


def _acceptable(
    draft: Draft, drafts: Mapping[str, Draft], chosen: Robot, problems: Problems
) -> bool:
    name, span = draft.name, draft.section.name_span
    if not _NAME.fullmatch(name) or len(name) > LONGEST_NAME:
        problems.error(
            INVALID_NAME,
            f"invalid object name `{name}`",
            span,
            notes=(f"VAL-II counts 15 characters, and `{name}_grip` must be told from others",),
            help=(
                f"a name begins with a letter and has at most {LONGEST_NAME} letters, digits, _",
            ),
        )
        return False
    taken = {other.lower(): other for other in drafts}
    if name.lower() in taken:
        other = drafts[taken[name.lower()]]
        problems.error(
            NAME_CLASH,
            f"`{name}` and `{other.name}` are one name in VAL-II",
            span,
            secondary=(Label(other.section.name_span, "the other one"),),
            help=("VAL-II does not tell capitals from small letters: rename one",),
        )
        return False
    reserved = {"floor", "robot", *(link.name for link in chosen.arm.links)}
    if name.lower() in reserved:
        problems.error(
            NAME_CLASH,
            f"`{name}` is the name of something else",
            span,
            notes=("the floor and the parts of the robot are always there",),
            help=("choose another name",),
        )
        return False
    return True


def _supported(bodies: tuple[Body, ...], problems: Problems) -> tuple[Body, ...]:
    found: list[Body] = []
    for body in bodies:
        if not must_stand(body):
            found.append(body)
            continue
        check_footing(body, problems)
        support = find_support(body, bodies)
        check_support(body, support, problems)
        movable = body.mobility is Mobility.MOVABLE
        found.append(replace(body, rests_on=support.body) if movable else body)
    return tuple(found)
