"""Where a program runs: of names, and of scenes and tasks that were read before."""

from vrts.api.errors import wrong_call
from vrts.api.given import File, Given, optional_path, path_of, word
from vrts.api.scenes import Scene, Task, task_path
from vrts.assignments.packed import found_setting
from vrts.pipeline.scenes import load_asked_scene, with_scenario
from vrts.pipeline.setting import Setting
from vrts.pipeline.where import Where


def where_of(
    scene: File | Scene | None,
    task: File | Task | None,
    scenario: File | None,
    lab: File | None = None,
    controller: str | None = None,
) -> Where:
    """Return what is given by name; what was read before has none here.

    Raises:
        VrtsError: One of them is no path.
    """
    return Where(
        None if scene is None or isinstance(scene, Scene) else str(path_of(scene)),
        None if task is None or isinstance(task, Task) else task_path(task),
        optional_path(scenario),
        optional_path(lab),
        word(controller, "controller"),
    )


def setting_read(
    file: Given, scene: File | Scene | None, task: File | Task | None, where: Where
) -> Setting | None:
    """Return the setting of a scene or task that was read before; None: neither was.

    Args:
        file: The program; a scene is looked for beside it last.
        scene: As callers give it.
        task: As callers give it.
        where: What of all is given by name.

    Raises:
        CannotRead: A file is not there.
        Refused: A file has errors.
        VrtsError: A lab or controller is given too, or another scene than the task's: they belong
            to what was read.
    """
    read = task if isinstance(task, Task) else scene if isinstance(scene, Scene) else None
    if read is None:
        return None
    if where.lab is not None or where.controller is not None:
        name = "vrts.task" if isinstance(read, Task) else "vrts.scene"
        raise wrong_call(f"give `lab` and `controller` to `{name}`, which has read the files")
    if isinstance(read, Scene) and task is not None:
        setting = found_setting(None, where)  # of the task, which is given by name
        assert setting is not None
        _require_same(setting, read.setting)
        return setting
    if isinstance(scene, Scene):
        _require_same(read.setting, scene.setting)
    elif where.scene is not None:
        _require_same(read.setting, load_asked_scene(where.scene, file.folder))
    setting = read.setting
    return setting if where.scenario is None else with_scenario(setting, where.scenario)


def _require_same(own: Setting, taken: Setting) -> None:
    """Refuse another scene than that of a task: one of the two was read already, without it."""
    mine, other = own.scene, taken.scene
    if (mine.digest, mine.controller) != (other.digest, other.controller):
        raise wrong_call(
            f"`scene` is not the scene of the task, which is `{mine.name}`",
            "leave out `scene`, or give both `scene` and `task` by their names",
        )
