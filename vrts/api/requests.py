"""What the public API and the commands ask of the pipeline about one program."""

from pathlib import Path

from vrts.api.given import Given
from vrts.assignments.packed import found_setting
from vrts.base.diagnostic import Diagnostic
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import Reading
from vrts.pipeline.environments import load_environment, usual_environment, with_scenario_of
from vrts.pipeline.request import ALL_CHECKS, Checks, Request
from vrts.pipeline.scenes import free_setting
from vrts.pipeline.setting import Setting
from vrts.pipeline.where import ANYWHERE, Where
from vrts.prove.environment.environment import Environment


def run_request(given: Given, where: Where, reading: Reading, entry: str | None = None) -> Request:
    """Return a request to run a program without a task, in a scene or with the robot alone.

    Args:
        given: The program.
        where: Names of scene, scenario and lab.
        reading: How it is to be read.
        entry: Program of the file to execute; None: the main one.

    Raises:
        CannotRead: A file is not there, or a lab has no scene to be laid over.
        Refused: Scene, scenario or lab have errors.
    """
    if where == ANYWHERE:
        return Request(given.program, robot_alone(), reading, entry)
    return Request(given.program, free_setting(where, given.folder), reading, entry)


def run_request_beside(
    given: Given, where: Where, reading: Reading, entry: str | None = None
) -> Request:
    """Return a request to run a program where `verify`, `view` and `debug` would.

    That is the task given, else the one beside the program unless a scene is asked for, else the
    robot alone.

    Raises:
        CannotRead: A file is not there.
        Refused: Task, scene, scenario or lab have errors.
    """
    setting = found_setting(given.path, where)
    if setting is None:
        return run_request(given, where, reading, entry)
    return Request(given.program, setting, reading, entry)


def verify_request(
    given: Given,
    setting: Setting,
    reading: Reading,
    *,
    entry: str | None = None,
    checks: Checks = ALL_CHECKS,
) -> Request:
    """Return a request to verify a program where its setting says.

    Args:
        given: The program.
        setting: Scene, and task if there is one.
        reading: How it is to be read.
        entry: Program of the file to execute; None: the task's, else the main one.
        checks: What is to be found out.
    """
    name, path = given.program.name, given.path
    identifier, title = (name, None) if path is None else (path.stem, path.name)
    return Request(given.program, setting, reading, entry, checks, identifier, title)


def outside(
    setting: Setting, environment: Path | None, *, fixed: bool
) -> tuple[Environment, tuple[Diagnostic, ...]]:
    """Return what may come from outside in the futures of a program, and what there is to say.

    Args:
        setting: Where the program runs.
        environment: A file that says it; None: that of the task, else all is free.
        fixed: Whether all that the scenario says is the same in every future: it was asked for.

    Raises:
        CannotRead: The file is not there.
        Refused: It has errors.
    """
    if environment is None:
        found, said = usual_environment(setting), ()
    else:
        found, said = load_environment(environment, setting)
    return (with_scenario_of(found, setting) if fixed else found), said
