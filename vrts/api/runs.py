"""A program that was executed: the whole run, at any time."""

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.api.curves import curves
from vrts.api.errors import VrtsError, public, reason_of, refusal, refuse, text_of, wrong_call
from vrts.api.given import File, Program, given, number, path_of, reading, word
from vrts.api.requests import run_request_beside
from vrts.api.scenes import Location, Scene, Task, location_of
from vrts.api.settings import setting_read, where_of
from vrts.base.units import DEG, MM, deg, mm
from vrts.engine.batch import batch_of
from vrts.engine.run import Run as Inner
from vrts.engine.state import State
from vrts.engine.storage.recognise import is_saved_run
from vrts.pipeline.request import Request
from vrts.report.event_words import event_text
from vrts.report.formats.run_csv import run_csv
from vrts.report.plain import plain_text
from vrts.report.poses.tool import oat_deg, tool_frames
from vrts.report.screen.state_text import state_text
from vrts.robots.built import shown_off
from vrts.run_files.loading import load_run
from vrts.run_files.saving import saved_bytes
from vrts.run_files.simulated import Simulated, simulate

Array = npt.NDArray[np.float64]
Times = npt.ArrayLike
"""Times in s: a number, or a list or an array of them."""

JOINTS = 6
SLOWEST_HZ, FASTEST_HZ = 0.001, 1000.0  # rows of a table: their times have three decimals
SHOWN = 600  # points of a curve
ROUNDED_S = 0.0005  # half of the last decimal of a time that is printed


class Joints(NamedTuple):
    """The six joints at times, joint 1 first, as the controller shows them."""

    deg: Array  # shape (n, 6)
    rad: Array  # shape (n, 6)
    deg_s: Array  # speeds, shape (n, 6)


class Tool(NamedTuple):
    """The tool at times, in the frame of the robot's shoulder: X forward, Y left, Z up."""

    mm: Array  # X, Y and Z, shape (n, 3)
    oat_deg: Array  # VAL's angles O, A and T, shape (n, 3)
    rotation: Array  # from the tool's frame to the robot's, shape (n, 3, 3)


class Event(NamedTuple):
    """Something that happened."""

    time_s: float
    kind: str  # "motion", "hand", "grasp", "signal", "output", "program", "fault" or "note"
    words: str  # "can1 grasped"
    line: int | None  # of the program; None: no line caused it


class Instant:
    """A run at one instant. Made by `Run.at`."""

    def __init__(self, run: Inner, state: State) -> None:
        """Remember the instant."""
        self._run = run
        self._state = state

    @property
    def time_s(self) -> float:
        """The time, in s."""
        return self._state.time_s

    @property
    def joints_deg(self) -> tuple[float, ...]:
        """The six joints as the controller shows them, in degrees."""
        off = shown_off(self._run.scene.robot.arm)
        return tuple(deg(q + by) for q, by in zip(self._state.configuration, off, strict=True))

    @property
    def tool(self) -> Location:
        """The tool, in the frame of the robot's shoulder."""
        return location_of(self._state.X_WT)

    @property
    def hand_mm(self) -> float:
        """Opening of the hand, in mm."""
        return mm(self._state.hand_opening)

    @property
    def held(self) -> str | None:
        """Name of the object in the hand; None: it holds nothing."""
        return self._state.held

    @property
    def objects(self) -> Mapping[str, Location]:
        """Where every object of the scene is, by name."""
        poses = self._state.poses
        return MappingProxyType({name: location_of(pose) for name, pose in poses.items()})

    @property
    def signals(self) -> frozenset[int]:
        """Numbers of the signals that are on."""
        return self._state.signals

    @property
    def variables(self) -> Mapping[str, object]:
        """Real and string variables that have a value, and locations, by name."""
        found = self._state.variables
        return MappingProxyType(
            {
                name: value if isinstance(value, float | str) else str(value)
                for name, value in found.items()
            }
        )

    @property
    def line(self) -> int | None:
        """Line of the program that moves the arm, else the one that the program is at."""
        return None if self._state.span is None else self._state.span.line

    @property
    def output(self) -> str:
        """What the program has printed so far."""
        return plain_text(self._state.output.replace("\r\n", "\n"))

    def __str__(self) -> str:
        """Return the state as `vrts run --at` prints it."""
        return state_text(self._run, self._state)

    def __repr__(self) -> str:
        """Return the instant in a line."""
        return f"<vrts run at {self.time_s:g} s, line {self.line}>"


class Run:
    """A program that was executed. Made by `vrts.run`; an assessment has one, too.

    Any time can be asked, in any order, also backward.
    """

    def __init__(self, simulated: Simulated) -> None:
        """Take a run, and what a file of it has to tell."""
        if simulated.run is None:
            raise refusal(simulated.diagnostics)
        self._simulated = simulated
        self._run = simulated.run

    @property
    def duration_s(self) -> float:
        """How long it takes, in s."""
        return self._run.horizon_s

    @property
    def ending(self) -> str:
        """How it ends, such as "completed", "halted" or "error"."""
        return self._run.ending.value

    @property
    def ok(self) -> bool:
        """Whether nothing was found to be wrong. Contacts and goals are for `vrts.verify`."""
        return not any(one.is_error for one in self._simulated.diagnostics)

    @property
    def output(self) -> str:
        """What the program printed."""
        return plain_text(self._run.output.replace("\r\n", "\n"))

    @property
    def problems(self) -> tuple[str, ...]:
        """What the compiler and the run have to say, each as the commands show it."""
        return tuple(text_of(one) for one in self._simulated.diagnostics)

    @property
    def events(self) -> tuple[Event, ...]:
        """What happened, by time."""
        found: list[Event] = []
        for event in self._run.events:
            said = event_text(event)
            if said is not None:
                cause = getattr(event, "cause", None)
                line = None if cause is None else cause.span.line
                found.append(Event(event.time_s, said[0], said[1], line))
        return tuple(found)

    @public
    def at(self, time_s: float) -> Instant:
        """Return the run at a time, in s, from 0 to `duration_s`.

        Raises:
            VrtsError: The run does not last so long, or it is not one time.
        """
        times = self._times(time_s)
        if times.size != 1:
            raise wrong_call("`at` takes one time", "`joints` and `tool` take many at once")
        return Instant(self._run, self._run.at(float(times[0])))

    @public
    def joints(self, times_s: Times) -> Joints:
        """Return the joints at many times at once.

        Args:
            times_s: n times, in s, from 0 to `duration_s`.

        Returns:
            Angles and speeds of the six joints, each of shape (n, 6); the unit is in the name.

        Raises:
            VrtsError: A time is outside the run, or they are no numbers.
        """
        times = self._times(times_s)
        batch = batch_of(self._run.timeline)
        q = batch.values(times)[:, :JOINTS] + np.array(shown_off(self._run.scene.robot.arm))
        return Joints(q / DEG, q, batch.rates(times)[:, :JOINTS] / DEG)

    @public
    def tool(self, times_s: Times) -> Tool:
        """Return the tool at many times at once.

        Args:
            times_s: n times, in s, from 0 to `duration_s`.

        Returns:
            Place in mm, shape (n, 3), O, A, T in degrees, shape (n, 3), and rotation, shape
            (n, 3, 3), in the frame of the robot's shoulder.

        Raises:
            VrtsError: A time is outside the run, or they are no numbers.
        """
        times = self._times(times_s)
        q = batch_of(self._run.timeline).values(times)[:, :JOINTS]
        rotations, origins = tool_frames(self._run, times, q)
        return Tool(origins / MM, oat_deg(rotations), rotations)

    @public
    def to_csv(self, path: File | None = None, *, rate_hz: float = 50.0) -> str:
        """Return a table of arm, tool, hand, program and signals over time.

        Args:
            path: A file to write it to as well; one that is there is replaced.
            rate_hz: Rows a second.

        Raises:
            VrtsError: The file cannot be written, or the rate is not from 0.001 to 1000 Hz.
        """
        if not SLOWEST_HZ <= number(rate_hz, "rate_hz") <= FASTEST_HZ:
            raise wrong_call(f"`rate_hz` goes from {SLOWEST_HZ:g} to {FASTEST_HZ:g} Hz")
        text = "".join(run_csv(self._run, rate_hz))
        if path is not None:
            written(path_of(path), text.encode())
        return text

    @public
    def save(self, path: File) -> Path:
        """Write the run to a file, which `vrts.run` reads; return its path.

        Raises:
            VrtsError: The file cannot be written, or the run cannot be saved.
        """
        place = path_of(path)
        written(place, saved_bytes(self._simulated))
        return place

    def _times(self, times_s: Times) -> Array:
        """Return times as an array of one axis; the end may be given rounded, as it is printed."""
        try:
            times = np.atleast_1d(np.asarray(times_s, dtype=float))
        except (TypeError, ValueError) as problem:
            raise wrong_call("times are numbers, in s") from problem
        if times.ndim != 1:
            raise wrong_call("times are a list, or an array of one axis")
        inside = (times >= 0.0) & (times <= self.duration_s + ROUNDED_S)
        if not inside.all():
            first = float(times[~inside][0])
            raise VrtsError(f"the run goes from 0 to {self.duration_s:.3f} s, not to {first:g} s")
        return np.minimum(times, self.duration_s)

    def __repr__(self) -> str:
        """Return the run in a line."""
        name = self._run.scene.name
        return f"<vrts.Run {self.ending} after {self.duration_s:.3f} s, scene {name}>"

    def _repr_html_(self) -> str:
        """Return the curves of the run for a notebook."""
        times = np.linspace(0.0, self.duration_s, SHOWN)
        words = f"{self.ending} after {self.duration_s:.3f} s"
        return curves(words, times, self.joints(times).deg, self.tool(times).mm)


def written(path: Path, data: bytes) -> None:
    """Write a file.

    Raises:
        VrtsError: It cannot be written.
    """
    try:
        path.write_bytes(data)
    except OSError as problem:
        raise VrtsError(f"cannot write `{path}`: {reason_of(problem)}") from problem


@public
def run(
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
) -> Run:
    r"""Execute a program; nothing is checked or marked. A saved run is read instead.

    Args:
        program: A path; the text of a program, which has several lines; or a saved run.
        scene: Where it runs. Without scene and task: as the task beside the file has it, else a
            robot alone.
        task: Where it runs.
        scenario: How the run begins, and what happens in it: a file.
        lab: A file with your own robot, hand and table, laid over the scene.
        controller: A controller model.
        entry: Program of the file to execute; None: the task's, else the main one.
        dialect: `val2`, `val2+`, `val`, `vplus` or `as`; None: as name and content tell.
        files: Compiled together with the program.

    Raises:
        VrtsError: The program does not compile, a file is not there or has errors, or more is given
            than a saved run.

    >>> import vrts
    >>> spin = vrts.run(".PROGRAM spin()\nDRIVE 1, 30, 100\nTYPE \"there\"\n.END\n")
    >>> spin.output
    'there\n'
    >>> [round(q) for q in spin.at(spin.duration_s).joints_deg]
    [30, -90, 90, 0, 0, 0]
    >>> spin.joints([0.0, spin.duration_s]).deg.shape
    (2, 6)
    """
    file = given(program)
    if is_saved_run(file.program.data):
        refuse(
            "a saved run has its own scene, scenario and programs",
            scene=scene,
            task=task,
            scenario=scenario,
            lab=lab,
            controller=controller,
            entry=entry,
            dialect=dialect,
            files=files or None,
        )
        return Run(load_run(*file.program, file.folder))
    where = where_of(scene, task, scenario, lab, controller)
    entry = word(entry, "entry")
    how = reading(dialect, files, "auto")
    setting = setting_read(file, scene, task, where)
    if setting is not None:
        return Run(simulate(Request(file.program, setting, how, entry)))
    return Run(simulate(run_request_beside(file, where, how, entry)))
