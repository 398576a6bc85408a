"""Scenes and tasks, read and found right."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

from vrts.api.errors import public
from vrts.api.given import File, optional_path, path_of, word
from vrts.assignments.packed import is_packed, load_zip
from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.check.task.task import Task as Inner
from vrts.pipeline.controllers import with_controller
from vrts.pipeline.files import find_example
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import load_task
from vrts.report.scene_drawing import scene_svg
from vrts.report.screen.scene_text import scene_text

DECIMALS = 6  # of mm and degrees


class Location(NamedTuple):
    """Where a tool or a thing is, as VAL-II says it: in the frame of the robot's shoulder."""

    x_mm: float
    y_mm: float
    z_mm: float
    o_deg: float
    a_deg: float
    t_deg: float


def location_of(X_WT: Pose) -> Location:
    """Return a pose as VAL-II says it, to the nanometre."""
    return Location(*(round(number, DECIMALS) + 0.0 for number in components(X_WT)))


@dataclass(frozen=True, slots=True)
class Scene:
    """What stands around the robot. Made by `vrts.scene`."""

    setting: Setting

    @property
    def name(self) -> str:
        """Name of the scene."""
        return self.setting.scene.name

    @property
    def title(self) -> str:
        """What the scene is called on pages."""
        return self.setting.scene.title

    @property
    def robot(self) -> str:
        """What the arm is called."""
        return self.setting.scene.robot.arm.title

    @property
    def objects(self) -> Mapping[str, Location]:
        """Where every object of the scene stands at first, by its name."""
        bodies = self.setting.scene.bodies
        return MappingProxyType({body.name: location_of(body.X_WO) for body in bodies})

    @property
    def locations(self) -> Mapping[str, Location]:
        """The locations that programs may use without teaching them, by name."""
        known = self.setting.scene.locations
        return MappingProxyType({name: location_of(pose) for name, pose in known.items()})

    def __repr__(self) -> str:
        """Return the scene in a line."""
        return f"<vrts.Scene {self.name}: {len(self.objects)} objects, {self.robot}>"

    def __str__(self) -> str:
        """Return the scene as `vrts scene show` prints it."""
        return scene_text(self.setting.scene)

    def _repr_html_(self) -> str:
        """Return the scene as a drawing, from above and from the side."""
        return scene_svg(self.setting.scene)


@dataclass(frozen=True, slots=True)
class Task:
    """What an assignment asks for. Made by `vrts.task`."""

    setting: Setting

    @property
    def title(self) -> str:
        """What the assignment is called."""
        return self._task.title

    @property
    def scene(self) -> Scene:
        """The scene that it is set in."""
        own = self.setting
        return Scene(Setting(own.scene, None, own.diagnostics, scene_source=own.scene_source))

    @property
    def goals(self) -> tuple[str, ...]:
        """What has to be where in the end, in words."""
        goals = tuple(goal.title for goal in self._task.goals)
        return goals + tuple(relation.title for relation in self._task.relations)

    @property
    def points(self) -> float:
        """All points that there are."""
        return float(self._task.mark.total)

    @property
    def good_time_s(self) -> float:
        """How long a good solution takes: up to this time all points for speed are given, in s."""
        return self._task.t_par

    @property
    def _task(self) -> Inner:
        assert self.setting.task is not None
        return self.setting.task

    def __repr__(self) -> str:
        """Return the task in a line."""
        return f"<vrts.Task {self.title}: {self.points:g} points, scene {self.scene.name}>"


def task_path(name: File) -> Path:
    """Return the place of a task by its path, or by the name of an example."""
    path = path_of(name)
    return path if path.exists() else find_example(str(path)) or path


@public
def scene(name: File, *, lab: File | None = None, controller: str | None = None) -> Scene:
    """Read a scene.

    Args:
        name: A name of the library (`vrts scene list` shows them), or a path.
        lab: A file with your own robot, hand and table, laid over the scene.
        controller: A controller model; None: that of the lab or the scene.

    Raises:
        VrtsError: There is no such scene, or a file has errors.

    >>> import vrts
    >>> cans = vrts.scene("cans-on-bases")
    >>> cans.robot
    'Unimation PUMA 761'
    >>> cans.objects["can1"].x_mm
    800.0
    """
    setting = load_scene(str(path_of(name)), lab=optional_path(lab))
    return Scene(with_controller(setting, word(controller, "controller")))


@public
def task(
    name: File,
    *,
    scenario: File | None = None,
    lab: File | None = None,
    controller: str | None = None,
    staff: bool = False,
) -> Task:
    """Read a task.

    Args:
        name: `task.toml`, its folder, a zip of `vrts task pack`, or the name of an example.
        scenario: A scenario in place of the task's own.
        lab: A lab in place of the task's own; marks in it do not count.
        controller: A controller model in place of the task's own; marks under it do not count.
        staff: Whether to add the hidden part, which only those who mark have.

    Raises:
        VrtsError: There is no such task, or a file has errors.

    >>> import vrts
    >>> vrts.task("01-cans-on-bases").goals
    ('can1 on base2', 'can2 on base1')
    """
    path = task_path(name)
    read = load_zip if is_packed(path) else load_task
    found = read(path, scenario=optional_path(scenario), staff=staff, lab=optional_path(lab))
    return Task(with_controller(found, word(controller, "controller")))
