"""Programs executed, checked and marked."""

from collections.abc import Iterable
from os import PathLike
from typing import overload

from vrts.api.assessments import Assessment
from vrts.api.errors import public, refuse, wrong_call
from vrts.api.given import File, Given, Program, given, reading, word
from vrts.api.requests import verify_request
from vrts.api.scenes import Scene, Task
from vrts.api.scenes import task as read_task
from vrts.api.settings import setting_read, where_of
from vrts.assignments.packed import found_setting
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import Reading
from vrts.pipeline.execution import compiled_for
from vrts.pipeline.files import scene_names
from vrts.pipeline.request import Checks, Request
from vrts.pipeline.setting import Setting
from vrts.run_files.simulated import of_run

STRICT = "val2"  # as the controller takes it: the usual dialect of what is verified


@public
def verify(
    program: Program,
    *,
    scene: File | Scene | None = None,
    task: File | Task | None = None,
    scenario: File | None = None,
    lab: File | None = None,
    controller: str | None = None,
    entry: str | None = None,
    dialect: str | None = None,
    files: tuple[File, ...] = (),
    collisions: bool = True,
) -> Assessment:
    r"""Execute a program and check everything: collisions, limits, goals. Mark it by its task.

    Args:
        program: A path, or the text of a program, which has several lines.
        scene: Where it runs, without a mark.
        task: Where it runs, and what is asked for. In another scene than its own marks do not
            count. Without scene and task: the task beside the file.
        scenario: How the run begins, and what happens in it: a file.
        lab: A file with your own robot, hand and table, laid over the scene.
        controller: A controller model.
        entry: Program of the file to execute; None: the task's, else the main one.
        dialect: `val2`, `val2+`, `val`, `vplus`, `as` or `auto`; None: `val2`.
        files: Compiled together with the program.
        collisions: Whether to check them.

    Raises:
        VrtsError: A file is not there or has errors, nothing says in which scene to verify, or a
            scene or task that was read before does not go with the rest.

    >>> import vrts
    >>> task = vrts.task("01-cans-on-bases")
    >>> found = vrts.verify(".PROGRAM lazy()\nDELAY 1\n.END\n", task=task)
    >>> found.mark, found.total
    (0.0, 10.0)
    >>> found.losses[0].words
    '`can1` was never picked up: it is 750 mm from its goal'
    """
    file = given(program)
    setting = setting_of(file, scene, task, (scenario, lab, controller))
    checks = Checks(collisions=collisions, curve=True, causes=True)
    entry, how = word(entry, "entry"), reading(dialect, files, STRICT)
    return assessed(verify_request(file, setting, how, entry=entry, checks=checks))


@overload  # a text is no list of texts here
def mark(  # pyright: ignore[reportOverlappingOverload]
    programs: str | PathLike[str], task: File | Task, *, staff: bool | None = None
) -> Assessment: ...
@overload
def mark(
    programs: Iterable[Program], task: File | Task, *, staff: bool | None = None
) -> list[Assessment]: ...
@public
def mark(
    programs: Program | Iterable[Program], task: File | Task, *, staff: bool | None = None
) -> Assessment | list[Assessment]:
    r"""Mark one program by a task, or many, as `vrts grade` does: the hidden part counts too.

    Of a task with hidden scenes the lowest mark counts. All are marked in this process, one after
    another: for a class whose programs you do not trust use `vrts grade`.

    Args:
        programs: A program, or several, each as for `vrts.verify`.
        task: `task.toml`, its folder, a zip, the name of an example, or what `vrts.task` gives.
        staff: Whether the hidden part of a task that is given by name counts; None: it does. What
            `vrts.task` gives has it or not.

    Returns:
        An assessment for one program; a list, in the same order, for several.

    Raises:
        VrtsError: A file is not there or has errors, or `staff` is given for what was read before.

    >>> import vrts
    >>> wrong = ".PROGRAM lazy()\nDELEY 1\n.END\n"
    >>> vrts.mark(wrong, "01-cans-on-bases").status
    'does not compile'
    """
    if isinstance(task, Task):
        refuse("`vrts.task` has read the task, with the hidden part or without it", staff=staff)
        setting = task.setting
    else:
        setting = read_task(task, staff=True if staff is None else staff).setting
    if isinstance(programs, str | PathLike):
        return _lowest(given(programs), setting)
    if not isinstance(programs, Iterable):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise wrong_call("`programs` is a program, or a list of programs")
    return [_lowest(given(program), setting) for program in programs]


def setting_of(
    file: Given,
    scene: File | Scene | None,
    task: File | Task | None,
    more: tuple[File | None, File | None, str | None],
) -> Setting:
    """Return the setting that a program is verified in; `more` is scenario, lab and controller.

    Raises:
        CannotRead: A file is not there.
        Refused: A file has errors.
        VrtsError: Nothing says which scene.
    """
    scenario, lab, controller = more
    where = where_of(scene, task, scenario, lab, controller)
    setting = setting_read(file, scene, task, where) or found_setting(file.path, where)
    if setting is None:
        raise wrong_call(
            "nothing says in which scene to verify the program",
            "give `scene=` or `task=`, or put a `task.toml` beside the program",
            f"scenes: {', '.join(scene_names())}",
        )
    return setting


def assessed(request: Request) -> Assessment:
    """Return what is found of one program."""
    compiled = compiled_for(request)
    found = assess(request, compiled)
    return Assessment(found, request, of_run(request, compiled, found.run, found.diagnostics))


def _lowest(file: Given, setting: Setting) -> Assessment:
    """Return the assessment with the lowest mark, of the setting and its hidden scenes."""
    found = [
        assessed(verify_request(file, one, Reading(STRICT), checks=Checks(curve=True, causes=True)))
        for one in (setting, *setting.variants)
    ]
    return min(found, key=lambda one: one.mark or 0.0)
