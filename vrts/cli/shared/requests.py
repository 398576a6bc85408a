"""What commands ask of the pipeline.

Commands import this when they are called: robots and scenes are loaded with it.
"""

from vrts.api import requests
from vrts.cli.shared.options import Language
from vrts.cli.shared.programs import Given, reading_of
from vrts.pipeline.request import ALL_CHECKS, Checks, Request
from vrts.pipeline.setting import Setting
from vrts.pipeline.where import Where


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
    return requests.run_request(given, where, reading_of(language), entry)


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
    return requests.run_request_beside(given, where, reading_of(language), entry)


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
    how = reading_of(language, "val2")
    return requests.verify_request(given, setting, how, entry=entry, checks=checks)
