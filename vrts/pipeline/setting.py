"""What a program is verified in: scene, task and scenario, read and found right."""

from dataclasses import dataclass, replace
from typing import NamedTuple, TypeVar

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.check.task.task import Task
from vrts.pipeline.refused import Refused
from vrts.prove.environment.environment import Environment
from vrts.scene.model import Scenario, Scene
from vrts.scene.planned import ScenarioFile

Value = TypeVar("Value")


class Sources(NamedTuple):
    """The files that a setting was read from, beside that of its scene; None: there is none."""

    task: SourceFile | None = None
    environment: SourceFile | None = None  # that the task names
    scenario: SourceFile | None = None


NO_SOURCES = Sources()


@dataclass(frozen=True, slots=True)
class Setting:
    """A scene, and the task and scenario set in it if there are, read and found right.

    Where a task has a scenario, the digest of the task covers both: marks are valid for this
    scenario only, as they are for this scene only.
    """

    scene: Scene
    task: Task | None
    diagnostics: tuple[Diagnostic, ...]  # warnings
    scenario: ScenarioFile | None = None
    scene_source: SourceFile | None = None  # None: a robot alone
    stamps: tuple[Diagnostic, ...] = ()  # why marks do not count; part of every assessment
    hidden: int = 0  # checks that are in `task` for marking only
    more: int = 0  # checks that are not in `task` but will be at marking
    variants: tuple["Setting", ...] = ()  # the task in hidden scenes; the lowest mark counts
    environment: Environment | None = None  # in which the task asks for every future
    sources: Sources = NO_SOURCES


def scenario_of(setting: Setting) -> Scenario:
    """Return the scenario of a run.

    Where there is a task, it is stopped at its longest time and may set only what the task allows.
    """
    scenario = Scenario() if setting.scenario is None else setting.scenario.scenario
    if setting.task is None:
        return scenario
    limits = replace(scenario.limits, time_s=min(scenario.limits.time_s, setting.task.t_max))
    return replace(scenario, limits=limits, locks=setting.task.locks)


def accepted(value: Value | None, found: tuple[Diagnostic, ...]) -> Value:
    """Return what was read from a file, if it could be.

    Raises:
        Refused: It could not; what was found says why.
    """
    if value is None:
        raise Refused(found)
    return value
