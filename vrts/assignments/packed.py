"""The setting of a packed task, read from its zip."""

from dataclasses import replace
from pathlib import Path
from posixpath import normpath
from tempfile import TemporaryDirectory

from vrts.assignments.pack import BAD_ARCHIVE, Bundle, read_zip
from vrts.base.diagnostic import error
from vrts.base.safe_names import safe
from vrts.check.task.task_places import lab_name, scene_name
from vrts.pipeline.controllers import with_controller
from vrts.pipeline.files import SCENE_FILE, TASK_FILE, names_file, read_bytes, read_toml_source
from vrts.pipeline.refused import Refused
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import load_task, setting_for
from vrts.pipeline.where import Where

SUFFIX = ".zip"


def is_packed(path: Path) -> bool:
    """Return whether a path is meant to be a packed task."""
    return path.suffix.lower() == SUFFIX


def public_answer(ready: bool, setting: Setting) -> str | None:
    """Return what students are told about checks they cannot see; None where there are none."""
    if not setting.more:
        return None
    passed = "all public checks passed" if ready else "not all public checks passed"
    return f"{passed}; {setting.more} more at marking"


def load_zip(
    path: Path,
    *,
    staff: bool = True,
    scene: str | None = None,
    scenario: Path | None = None,
    lab: Path | None = None,
) -> Setting:
    """Return the setting of a packed task, with the hidden part if that is in it and wanted.

    Args:
        path: The zip.
        staff: Whether to add the hidden part.
        scene: Name or path of another scene; marks in it do not count.
        scenario: A scenario file in place of the task's.
        lab: A lab in place of the task's; marks in it do not count.

    Raises:
        CannotRead: A file is not there.
        Refused: It is no packed task, or its task or scene have errors.
    """
    bundle = read_zip(read_bytes(path))
    return setting_of(bundle, staff=staff, scene=scene, scenario=scenario, lab=lab)


def found_setting(program: Path | None, where: Where) -> Setting | None:
    """Return the setting that a program is verified in; see `pipeline.settings.setting_for`.

    The task may also be a packed one; its hidden part is left out.
    """
    scene, task, scenario, lab, controller = where
    if task is None or not is_packed(task):
        return setting_for(program, where)
    setting = load_zip(task, scene=scene, scenario=scenario, staff=False, lab=lab)
    return with_controller(setting, controller)


def setting_of(
    bundle: Bundle,
    *,
    staff: bool = True,
    scene: str | None = None,
    scenario: Path | None = None,
    lab: Path | None = None,
) -> Setting:
    """Return the setting of a packed task; see `load_zip`."""
    with TemporaryDirectory(prefix="vrts-") as temporary:
        home = Path(temporary)
        folder = home / safe(bundle.manifest.name)  # as where it was packed: names are of folders
        for name, data in bundle.files.items():
            place = folder / name
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(data)
        _require_own_scene(bundle, folder, home)
        task_file = folder / TASK_FILE
        whole = staff and bundle.manifest.staff
        setting = load_task(task_file, scene, scenario, staff=whole, home=home, lab=lab)
    hidden = bundle.manifest.hidden
    task = setting.task
    assert task is not None
    name = bundle.manifest.name
    title = name if task.title == task.name else task.title  # it has none of its own
    return replace(
        setting,
        task=replace(task, name=name, title=title),
        stamps=(*bundle.stamps, *setting.stamps),
        more=0 if setting.hidden else hidden,
    )


def _require_own_scene(bundle: Bundle, folder: Path, home: Path) -> None:
    """Refuse a task that names a scene or a lab outside its zip, or no scene."""
    named, lab, found = None, None, ()
    if TASK_FILE in bundle.files:
        source = read_toml_source(folder / TASK_FILE, home)
        named, found = scene_name(source)
        lab = lab_name(source)
    places = {normpath(f"{named}/{end}") for end in ("", SCENE_FILE)}
    inside = places & bundle.files.keys()
    if named is None or not inside or not names_file(named):
        raise Refused(found or (error(BAD_ARCHIVE, "the packed task has no scene of its own"),))
    if lab is not None and normpath(lab) not in bundle.files:
        raise Refused((error(BAD_ARCHIVE, "the packed task has no lab of its own"),))
