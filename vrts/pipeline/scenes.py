"""Settings without a task: a scene with its lab and scenario."""

import hashlib
from dataclasses import replace
from pathlib import Path

from vrts.base.safe_names import safe
from vrts.base.source import SourceFile
from vrts.ir.system import PARAMETERS
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.controllers import with_controller
from vrts.pipeline.files import CannotRead, asked_scene, find_scene, read_toml_source
from vrts.pipeline.setting import Setting, accepted
from vrts.pipeline.where import Where
from vrts.scene.reading.scenario_file import read_scenario
from vrts.scene.reading.scene_file import read_scene, read_scene_in_lab, scene_name


def load_scene(
    name: str, beside: Path | None = None, home: Path | None = None, lab: Path | None = None
) -> Setting:
    """Return a scene without a task, with a lab laid over it if one is given.

    Args:
        name: A path, or a name of the library.
        beside: Folder of the file that names it; None: whoever calls does.
        home: As for `read_toml_source`.
        lab: File of a lab.

    Raises:
        CannotRead: There is no such scene or lab.
        Refused: One of the files has errors.
    """
    if beside is None:
        return load_asked_scene(name, None, home, lab)
    return _loaded(find_scene(name, beside), home, lab)


def load_asked_scene(
    name: str, beside: Path | None = None, home: Path | None = None, lab: Path | None = None
) -> Setting:
    """Return a scene that whoever calls has named, as `load_scene` does.

    Args:
        name: A path, a name of the library, or `-` for stdin.
        beside: Folder to look for it in last: that of the program.
        home: As for `read_toml_source`.
        lab: File of a lab.

    Raises:
        CannotRead: There is no such scene or lab.
        Refused: One of the files has errors.
    """
    return _loaded(asked_scene(name, beside), home, lab)


def _loaded(path: Path, home: Path | None, lab: Path | None) -> Setting:
    source = read_toml_source(path, home)
    # the name of a scene depends neither on the working folder nor on how its path was typed
    named = safe(scene_name(str(path.resolve()))) if home is None else None
    if lab is None:
        scene, found = read_scene(source, path.parent, name=named)
    else:
        laid = read_toml_source(lab, home)
        scene, found, source = read_scene_in_lab(source, laid, path.parent, lab.parent, name=named)
    return Setting(accepted(scene, found), None, found, scene_source=source)


def with_scenario(setting: Setting, path: Path, home: Path | None = None) -> Setting:
    """Return a setting in which runs go as a scenario file says; `home` as for `load_task`.

    Raises:
        CannotRead: The file is not there.
        Refused: It has errors.
    """
    return with_scenario_text(setting, read_toml_source(path, home))


def with_scenario_text(setting: Setting, source: SourceFile) -> Setting:
    """Return a setting in which runs go as the text of a scenario file says.

    Raises:
        Refused: It has errors.
    """
    numbers = PARAMETERS.keys() - {"NEST.POS"}  # which is six of them
    scenario, found = read_scenario(source, setting.scene, sorted(numbers))
    file = accepted(scenario, found)
    task = setting.task
    if task is not None:
        both = hashlib.sha256(f"{task.digest} {file.digest}".encode()).hexdigest()
        task = replace(task, digest=both)
    told, sources = (*setting.diagnostics, *found), setting.sources._replace(scenario=source)
    return replace(setting, task=task, diagnostics=told, scenario=file, sources=sources)


def free_setting(where: Where, beside: Path | None = None) -> Setting:
    """Return the scene that is asked for, or a robot alone, with its scenario; never a task.

    Args:
        where: Names of scene, lab, controller and scenario.
        beside: Folder to look for the scene in last.

    Raises:
        CannotRead: One of the files is not there, or a lab has no scene to be laid over.
        Refused: One of them has errors.
    """
    if where.scene:
        setting = load_asked_scene(where.scene, beside, lab=where.lab)
    elif where.lab is not None:
        hint = "give `--scene NAME` (`scene=` in Python), too"
        raise CannotRead("a lab is laid over a scene", (hint,))
    else:
        setting = robot_alone()
    setting = with_controller(setting, where.controller)
    return setting if where.scenario is None else with_scenario(setting, where.scenario)
