"""Settings with a task: read from its folder, or found for a program."""

from dataclasses import replace
from pathlib import Path

from vrts.base.diagnostic import Diagnostic
from vrts.base.safe_names import safe
from vrts.check.task.manifest import (
    altered,
    announced,
    for_students,
    hidden_scene,
    listed,
    other_scene,
)
from vrts.check.task.staff import read_whole_task
from vrts.check.task.task_file import read_task
from vrts.check.task.task_places import controller_name, lab_name, scene_name
from vrts.pipeline.controllers import with_controller
from vrts.pipeline.environments import proof_is_hidden, with_environment
from vrts.pipeline.files import (
    MANIFEST_FILE,
    MAX_TOML,
    SCENARIO_FILE,
    STAFF,
    TASK_FILE,
    member_bytes,
    named_place,
    read_toml_source,
)
from vrts.pipeline.finding.task_of import task_of
from vrts.pipeline.scenes import load_asked_scene, load_scene, with_scenario
from vrts.pipeline.setting import Setting, Sources, accepted
from vrts.pipeline.where import ANYWHERE, Where


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
    folder = path if path.is_dir() else path.parent
    scene = scene or None
    source = read_toml_source(folder / TASK_FILE if path.is_dir() else path, home)
    named, found = scene_name(source)
    own_lab = lab_name(source)
    its_lab = None if own_lab is None else named_place(folder, own_lab)
    if scene is None:
        setting = load_scene(accepted(named, found), folder, home, lab or its_lab)
    else:
        setting = load_asked_scene(scene, folder, home, lab or its_lab)
    setting = with_controller(setting, controller_name(source))
    stamps: tuple[Diagnostic, ...] = ()
    more, is_whole = 0, True
    if (folder / MANIFEST_FILE).is_file():
        packed = _packed_files(folder)
        manifest = packed[MANIFEST_FILE]
        stamps, more, is_whole = altered(packed), announced(manifest), not for_students(manifest)
    if named is not None and (lab is not None or scene is not None):
        stamps += other_scene(load_scene(named, folder, home, its_lab).scene, setting.scene)
    hidden, name = 0, safe(folder.resolve().name or "task")  # the same wherever one stands
    if staff and (folder / STAFF / TASK_FILE).is_file():
        staff_source = read_toml_source(folder / STAFF / TASK_FILE, home)
        task, counts, found = read_whole_task(source, staff_source, setting.scene, name)
        hidden = sum(counts.values())
    else:
        task, found = read_task(source, setting.scene, name)
    read = accepted(task, found)
    if proof_is_hidden(read, source):
        if staff and is_whole:
            hidden += 1
        else:  # its environment is not there, or is not for whoever asks
            read, more = replace(read, proof=None), max(more, 1)
    setting = replace(
        setting,
        task=read,
        diagnostics=(*setting.diagnostics, *found),
        stamps=stamps,
        hidden=hidden,
        more=0 if hidden else more,
        sources=Sources(task=source),
    )
    setting = with_environment(setting, folder, home)
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
    manifest = member_bytes(folder / MANIFEST_FILE)[: MAX_TOML + 1]
    found = {MANIFEST_FILE: manifest}
    for name in listed(manifest):
        place = folder / name
        if place.resolve().is_relative_to(folder.resolve()) and place.is_file():
            found[name] = member_bytes(place)
    return found


def setting_for(program: Path | None, where: Where = ANYWHERE) -> Setting | None:
    """Return the setting that a program is verified in; None when nothing tells which.

    The task is the one given, else the one that the program belongs to, unless a scene is asked
    for; see `finding.task_of`.
    Scenario, lab and controller are those given, else the task's.
    """
    scene, task, scenario, lab, controller = where
    if task is not None:
        return with_controller(load_task(task, scene, scenario, lab=lab), controller)
    beside = program.parent if program is not None else None
    if scene is not None:
        setting = with_controller(load_asked_scene(scene, beside, lab=lab), controller)
        return setting if scenario is None else with_scenario(setting, scenario)
    found = None if program is None else task_of(program)
    if found is None:
        return None
    return with_controller(load_task(found, scenario=scenario, lab=lab), controller)
