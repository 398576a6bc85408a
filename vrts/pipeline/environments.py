"""What may come from outside in the futures of a program: as a file or a task says, or usually."""

import hashlib
from dataclasses import replace
from pathlib import Path

from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.base.source import SourceFile
from vrts.check.task.task import Task
from vrts.pipeline.files import CannotRead, named_place, read_toml_source
from vrts.pipeline.refused import Refused
from vrts.pipeline.setting import Setting, accepted, scenario_of
from vrts.prove.environment.environment import Environment
from vrts.prove.environment.reading import read_environment, read_inner

HIDDEN_ENVIRONMENT = Rule("V683", "hidden-environment")
IN_TASK = ("prove", "environment")  # table of a task that is one


def usual_environment(setting: Setting) -> Environment:
    """Return the environment of the task, else that in which everything that is read is free.

    Every future begins as the scenario of the task says. When inputs come there, and what is
    answered, is one example: that does not count.
    """
    return without_example(setting.environment or Environment(), setting)


def without_example(environment: Environment, setting: Setting) -> Environment:
    """Return an environment in which futures begin as in a scenario, and then go their own way."""
    usual = replace(scenario_of(setting), analog=())
    return replace(
        environment,
        scenario=replace(usual, inputs=(), answers=(), draws=(), operator=(), process_first=()),
    )


def with_scenario_of(environment: Environment, setting: Setting) -> Environment:
    """Return an environment in which all that a scenario says is the same in every future."""
    return replace(environment, scenario=scenario_of(setting))


def load_environment(
    path: Path, setting: Setting, home: Path | None = None
) -> tuple[Environment, tuple[Diagnostic, ...]]:
    """Return the environment that a file describes, and what there is to say about it.

    Args:
        path: The file.
        setting: Where programs run, and by its scenario how they begin: as `usual_environment`.
        home: As for `read_toml_source`.

    Raises:
        CannotRead: The file is not there.
        Refused: It has errors.
    """
    return environment_of(read_toml_source(path, home), setting)


def environment_of(
    source: SourceFile, setting: Setting
) -> tuple[Environment, tuple[Diagnostic, ...]]:
    """Return the environment that the text of a file describes; see `load_environment`.

    Raises:
        Refused: It has errors.
    """
    found, said = read_environment(source)
    return without_example(accepted(found, said), setting), said


def proof_is_hidden(task: Task, public: SourceFile) -> bool:
    """Return whether the public part of a task asks for a proof in an environment that is not.

    Args:
        task: As it was read.
        public: Its file that students get.

    Raises:
        Refused: The environment stands in that file.
    """
    proof = task.proof
    if proof is None or not proof.hidden or proof.span.source.name != public.name:
        return False
    if proof.inline:
        headline = "an environment that is hidden stands in the file that students get"
        remedy = "write it in `staff/environment.toml`, and name that file here"
        raise Refused((error(HIDDEN_ENVIRONMENT, headline, Label(proof.span), help=(remedy,)),))
    return True


def environment_file(task: Task, folder: Path) -> Path | None:
    """Return the file in which a task says what may come; None where it names none.

    Raises:
        CannotRead: It is no name of a file, or one outside the folder of the task.
    """
    named = None if task.proof is None else task.proof.environment
    if named is None:
        return None
    place = named_place(folder, named)
    if not place.resolve().is_relative_to(folder.resolve()):
        raise CannotRead(
            f"the environment `{named}` is outside the task's folder",
            ("copy it into the folder, and name it from there",),
        )
    return place


def with_environment(setting: Setting, folder: Path, home: Path | None = None) -> Setting:
    """Return the setting of a task with the environment in which it asks for every future.

    Args:
        setting: Of the task; its digest then covers the environment too.
        folder: Of the task.
        home: As for `read_toml_source`.

    Raises:
        CannotRead: The file of the environment is not there.
        Refused: The environment has errors.
    """
    task = setting.task
    if task is None or task.proof is None:
        return setting
    place = environment_file(task, folder)
    return in_environment(setting, None if place is None else read_toml_source(place, home))


def in_environment(setting: Setting, source: SourceFile | None) -> Setting:
    """Return the setting of a task with the environment in which it asks for every future.

    Args:
        setting: Of the task; its digest then covers the environment too.
        source: The file that the task names; None: it names none.

    Raises:
        Refused: The environment has errors.
    """
    task = setting.task
    if task is None or task.proof is None:
        return setting
    if source is not None:
        found, said = read_environment(source)
        environment = accepted(found, said)
        both = hashlib.sha256(f"{task.digest} {environment.digest}".encode()).hexdigest()
        task = replace(task, digest=both)
    elif task.proof.inline:
        found, said = read_inner(task.proof.span.source, IN_TASK)
        environment = accepted(found, said)
    else:
        environment, said = Environment(), ()
    told, sources = (*setting.diagnostics, *said), setting.sources._replace(environment=source)
    return replace(setting, task=task, diagnostics=told, environment=environment, sources=sources)
