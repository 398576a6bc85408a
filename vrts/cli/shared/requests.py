"""What commands ask of the pipeline.

Commands import this when they are called: robots and scenes are loaded with it.
"""

from vrts.cli.shared.options import Language
from vrts.cli.shared.programs import Given, reading_of, require_scene_of_lab
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.request import ALL_CHECKS, Checks, Request
from vrts.pipeline.setting import Setting
from vrts.pipeline.where import ANYWHERE, Where


def run_request(
    given: Given, where: Where, language: Language, entry: str | None = None
) -> Request:
    """Return a request to run a program without a task, in a scene or with the robot alone.

    Args:
        given: The program.
        where: Names of scene, scenario and lab.
        language: How it is to be read; without a dialect file name and content tell.
        entry: Program of the file to execute; None: the main one.

    Raises:
        CannotRead: A file is not there.
        Refused: Scene, scenario or lab have errors.
    """
    require_scene_of_lab(where)
    reading = reading_of(language)
    if where == ANYWHERE:
        return Request(given.program, robot_alone(), reading, entry)
    from vrts.pipeline.scenes import free_setting

    return Request(given.program, free_setting(where, given.folder), reading, entry)


def run_request_beside(
    given: Given, where: Where, language: Language, entry: str | None = None
) -> Request:
    """Return a request to run a program where `verify`, `view` and `debug` would.

    That is the task given, else the one beside the program unless a scene is asked for, else the
    robot alone.

    Raises:
        CannotRead: A file is not there.
        Refused: Task, scene, scenario or lab have errors.
    """
    from vrts.pipeline.settings import setting_for

    setting = setting_for(given.path, where)
    if setting is None:
        return run_request(given, where, language, entry)
    return Request(given.program, setting, reading_of(language), entry)


def verify_request(
    given: Given,
    setting: Setting,
    language: Language,
    *,
    entry: str | None = None,
    checks: Checks = ALL_CHECKS,
) -> Request:
    """Return a request to verify a program where its setting says.

    Args:
        given: The program.
        setting: Scene, and task if there is one.
        language: How it is to be read; strictly as VAL-II without a dialect.
        entry: Program of the file to execute; None: the task's, else the main one.
        checks: What is to be found out.

    Raises:
        CannotRead: A file that belongs to the program is not there.
    """
    reading = reading_of(language, "val2")
    name, path = given.program.name, given.path
    identifier, title = (name, None) if path is None else (path.stem, path.name)
    return Request(given.program, setting, reading, entry, checks, identifier, title)
