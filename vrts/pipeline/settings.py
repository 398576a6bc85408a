"""What a program is verified in: scene, task and scenario, read and found right."""

import hashlib
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.pipeline.files import MAX_TOML, TASK_FILE, find_scene, read_bytes, read_toml_source

if TYPE_CHECKING:
    from vrts.check.task.task import Task
    from vrts.scene.model import Scene
    from vrts.scene.reading.scenario_file import ScenarioFile

STAFF = "staff"  # folder beside a task: what students do not get
MANIFEST_FILE = "manifest.json"  # of a packed task, also after unpacking
SCENARIO_FILE = "scenario.toml"  # beside a task: how its runs begin, and what happens in them

Value = TypeVar("Value")


class Refused(Exception):  # noqa: N818 -- names the situation
    """A scene or task file has errors; the diagnostics say which."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        """Keep everything that was found."""
        super().__init__("errors in a scene or task file")
        self.diagnostics = diagnostics


@dataclass(frozen=True, slots=True)
class Setting:
    """A scene, and the task and scenario set in it if there are, read and found right.

    Where a task has a scenario, the digest of the task covers both: marks are valid for this
    scenario only, as they are for this scene only.
    """

    scene: "Scene"
    task: "Task | None"
    diagnostics: tuple[Diagnostic, ...]  # warnings
    scenario: "ScenarioFile | None" = None
    scene_source: SourceFile | None = None  # None: a robot alone
    stamps: tuple[Diagnostic, ...] = ()  # why marks do not count; part of every assessment
    hidden: int = 0  # checks that are in `task` for marking only
    more: int = 0  # checks that are not in `task` but will be at marking
    variants: tuple["Setting", ...] = ()  # the task in hidden scenes; the lowest mark counts


def robot_alone() -> Setting:
    """Return the scene of a robot by itself."""
    from vrts.scene.default import robot_alone as alone

    return Setting(alone(), None, ())


def load_scene(
    name: str, beside: Path | None = None, home: Path | None = None, lab: Path | None = None
) -> Setting:
    """Return a scene without a task, with a lab laid over it if one is given.

    Args:
        name: A path, or a name of the library.
        beside: Folder to look in first.
        home: As for `read_toml_source`.
        lab: File of a lab.

    Raises:
        CannotRead: There is no such scene or lab.
        Refused: One of the files has errors.
    """
    from vrts.scene.reading.scene_file import read_scene, read_scene_in_lab

    path = find_scene(name, beside)
    source = read_toml_source(path, home)
    if lab is None:
        scene, found = read_scene(source, path.parent)
    else:
        laid = read_toml_source(lab, home)
        scene, found, source = read_scene_in_lab(source, laid, path.parent, lab.parent)
    return Setting(_accepted(scene, found), None, found, scene_source=source)


def load_task(
    path: Path,
    scene: str | None = None,
    scenario: Path | None = None,
    *,
    staff: bool = False,
    home: Path | None = None,
    lab: Path | None = None,
) -> Setting:
    """Return a task in its scene, or in another one, which is stamped: its marks do not count.

    The lab is the one given, else the one that the task names. The scenario is the one given, else
    `scenario.toml` beside the task if there is one.

    Args:
        path: `task.toml`, or its folder.
        scene: Name or path of another scene than the task's.
        scenario: A scenario file.
        staff: Whether to add the hidden parts in `staff/task.toml` and `staff/scenes`.
        home: As for `read_toml_source`.
        lab: File of a lab; another one than the task's is like another scene.

    Raises:
        CannotRead: The task, its scene, lab or scenario is not there.
        Refused: One of the files has errors.
    """
    from vrts.check.task.manifest import altered, announced, other_scene
    from vrts.check.task.staff import read_whole_task
    from vrts.check.task.task_file import read_task
    from vrts.check.task.task_places import lab_name, scene_name

    folder = path if path.is_dir() else path.parent
    source = read_toml_source(folder / TASK_FILE if path.is_dir() else path, home)
    named, found = scene_name(source)
    own_lab = lab_name(source)
    its_lab = None if own_lab is None else folder / own_lab
    setting = load_scene(scene or _accepted(named, found), folder, home, lab or its_lab)
    stamps: tuple[Diagnostic, ...] = ()
    more = 0
    if (folder / MANIFEST_FILE).is_file():
        packed = _packed_files(folder)
        stamps, more = altered(packed), announced(packed[MANIFEST_FILE])
    if named is not None and (lab is not None or scene not in (None, named)):
        stamps += other_scene(load_scene(named, folder, home, its_lab).scene, setting.scene)
    hidden = 0
    if staff and (folder / STAFF / TASK_FILE).is_file():
        staff_source = read_toml_source(folder / STAFF / TASK_FILE, home)
        task, counts, found = read_whole_task(source, staff_source, setting.scene)
        hidden = sum(counts.values())
    else:
        task, found = read_task(source, setting.scene)
    setting = replace(
        setting,
        task=_accepted(task, found),
        diagnostics=(*setting.diagnostics, *found),
        stamps=stamps,
        hidden=hidden,
        more=0 if hidden else more,
    )
    if scenario is None and (folder / SCENARIO_FILE).is_file():
        scenario = folder / SCENARIO_FILE
    if scenario is not None:
        setting = with_scenario(setting, scenario, home)
    if not staff or scene is not None:
        return setting
    return _with_variants(setting, path, scenario, home, lab)


def _with_variants(
    setting: Setting, path: Path, scenario: Path | None, home: Path | None, lab: Path | None
) -> Setting:
    """Add the task in every scene of `staff/scenes`; each counts as one hidden check."""
    from vrts.check.task.manifest import hidden_scene

    folder = path if path.is_dir() else path.parent
    variants = [
        load_task(path, str(place.resolve()), scenario, staff=True, home=home, lab=lab)
        for place in sorted((folder / STAFF / "scenes").glob("*.toml"))
    ]
    told = tuple(
        replace(variant, stamps=(*setting.stamps, *hidden_scene(variant.scene)))
        for variant in variants
    )
    return replace(
        setting,
        variants=told,
        hidden=setting.hidden + len(told),
        more=0 if told else setting.more,
    )


def _packed_files(folder: Path) -> dict[str, bytes]:
    """Return the files that the manifest of an unpacked task names, as far as they are there."""
    from vrts.check.task.manifest import listed

    manifest = read_bytes(folder / MANIFEST_FILE)[: MAX_TOML + 1]
    found = {MANIFEST_FILE: manifest}
    for name in listed(manifest):
        place = folder / name
        if place.resolve().is_relative_to(folder.resolve()) and place.is_file():
            found[name] = read_bytes(place)
    return found


def with_scenario(setting: Setting, path: Path, home: Path | None = None) -> Setting:
    """Return a setting in which runs go as a scenario file says; `home` as for `load_task`.

    Raises:
        CannotRead: The file is not there.
        Refused: It has errors.
    """
    from vrts.ir.system import PARAMETERS
    from vrts.scene.reading.scenario_file import read_scenario

    numbers = PARAMETERS.keys() - {"NEST.POS"}  # which is six of them
    scenario, found = read_scenario(read_toml_source(path, home), setting.scene, sorted(numbers))
    accepted = _accepted(scenario, found)
    task = setting.task
    if task is not None:
        both = hashlib.sha256(f"{task.digest} {accepted.digest}".encode()).hexdigest()
        task = replace(task, digest=both)
    return replace(
        setting, task=task, diagnostics=(*setting.diagnostics, *found), scenario=accepted
    )


def setting_for(
    program: Path | None,
    *,
    scene: str | None = None,
    task: Path | None = None,
    scenario: Path | None = None,
    lab: Path | None = None,
) -> Setting | None:
    """Return the setting that a program is verified in; None when nothing tells which.

    The task is the one given, else `task.toml` beside the program, unless a scene is asked for.
    Scenario and lab are those given, else the task's.
    """
    if task is not None:
        return load_task(task, scene, scenario, lab=lab)
    beside = program.parent if program is not None else None
    if scene is not None:
        setting = load_scene(scene, beside, lab=lab)
        return setting if scenario is None else with_scenario(setting, scenario)
    found = None if program is None else task_beside(program)
    return None if found is None else load_task(found, scenario=scenario, lab=lab)


def task_beside(program: Path) -> Path | None:
    """Return the file of the task that a program is verified against where nothing else is said."""
    beside = program.parent
    for folder in (beside, beside.parent if beside.name == "submissions" else beside):
        if (folder / TASK_FILE).is_file():
            return folder / TASK_FILE
    return None


def _accepted(value: Value | None, found: tuple[Diagnostic, ...]) -> Value:
    if value is None:
        raise Refused(found)
    return value
