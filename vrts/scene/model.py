"""What stands in the workspace, as data.

Frame W is the robot's base frame: z up, origin in the shoulder.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from types import MappingProxyType
from typing import NamedTuple

from vrts.base.pose import Pose, Vector
from vrts.base.source import Span
from vrts.controllers.model import ControllerModel
from vrts.controllers.models import USUAL
from vrts.geometry.shapes import Piece
from vrts.robots.model import Configuration, Robot
from vrts.robots.timed import timed
from vrts.scene.colors import Color

NO_FILES: Mapping[str, bytes] = MappingProxyType({})
NO_PLACES: Mapping[str, Pose | None] = MappingProxyType({})


class Mobility(Enum):
    """Whether a body can be carried."""

    FIXED = "fixed"
    MOVABLE = "movable"


@dataclass(frozen=True, slots=True)
class Body:
    """A named thing in the scene."""

    name: str  # as in the file: "can1"
    title: str  # in words: "the red can"
    kind: str  # "can", "base", "table", "floor", ...: what it looks like
    mobility: Mobility
    pieces: tuple[Piece, ...]  # in the body's frame O
    X_WO: Pose  # at the start of a run
    color: Color
    centre_of_mass: Vector  # in O [m]
    symmetry_axis: Vector | None = None  # in O: turning about it changes nothing (a can's z)
    rests_on: str | None = None  # name of the support at the start; None for fixed bodies
    span: Span | None = None  # of its name in the file
    paint: tuple[Color, ...] = ()  # of each piece; empty: all are of `color`
    grips: tuple[Pose, ...] = ()  # X_OP of the pads, where the file says how it is held

    @property
    def painted(self) -> tuple[tuple[Piece, Color], ...]:
        """Every piece with its colour."""
        colors = self.paint or (self.color,) * len(self.pieces)
        return tuple(zip(self.pieces, colors, strict=True))


@dataclass(frozen=True, slots=True)
class Scene:
    """The frozen description of a workspace."""

    name: str
    title: str
    robot: Robot
    X_FT: Pose  # VAL's TOOL when a run starts: the pad centre, unless the file says otherwise
    bodies: tuple[Body, ...]
    locations: Mapping[
        str, Pose
    ]  # named tool poses X_WT for students: "can1_grip", "base2_put", "safe"
    digest: str  # sha256 of the file: marks are valid for this scene only
    controller: ControllerModel = USUAL  # by which runs go
    # files that it names, by name, as read
    files: Mapping[str, bytes] = field(default_factory=lambda: NO_FILES)
    # names that are not in `locations`: students find these places; None: vrts works out none
    withheld: Mapping[str, Pose | None] = field(default_factory=lambda: NO_PLACES)

    def body(self, name: str) -> Body:
        """Return the body of a name. Raises KeyError when there is none."""
        for body in self.bodies:
            if body.name == name:
                return body
        raise KeyError(name)


@dataclass(frozen=True, slots=True)
class Limits:
    """Deterministic bounds of a run, so that an endless program is a result like any other."""

    statements: int = 2_000_000
    time_s: float = 600.0  # simulated [s]
    motions: int = 20_000
    call_depth: int = 200  # [assumed, manual language/programs#call-depth]
    output_characters: int = 1_000_000


class Region(NamedTuple):
    """A box of the workspace, edges along the world's axes."""

    lower: Vector  # in W [m]
    upper: Vector


class Sensor(NamedTuple):
    """An input that is on while something is inside a region."""

    signal: int  # an input, 1001 and above
    region: Region
    sees: tuple[str, ...] = ()  # names of bodies, or "tool"; empty: every movable body
    inverted: bool = False  # on while nothing is inside


class FaultKind(Enum):
    """What goes wrong on purpose."""

    INPUT_STUCK = "input stuck"  # the input `signal` keeps the state `on`
    GRIPPER_SLIPS = "gripper slips"  # what is held then, or grasped next, drops out of the hand
    PART_MISSING = "part missing"  # what the hand closes on then or next is not there
    EMERGENCY_STOP = "emergency stop"  # the arm stops, arm power goes off, the program ends


class PlannedFault(NamedTuple):
    """A fault that a scenario brings about."""

    time_s: float
    kind: FaultKind
    signal: int = 0
    on: bool = False


class Deed(Enum):
    """What an operator does."""

    STOP = "stop"  # ABORT: the arm slows down, the motion is given up
    PROCEED = "proceed"  # go on with the next step
    RETRY = "retry"  # go on with the motion that was given up
    EXECUTE = "execute"  # the same program once more


class Parts(Enum):
    """What becomes of the parts before the program is executed again."""

    PUT_BACK = "put back"  # everything stands where it stood at first, the hand is empty
    LEFT = "left"  # everything stays as it is
    TAKEN = "taken"  # what stands on another support than at first is gone


class Act(NamedTuple):
    """Something that an operator does in the tick that follows."""

    time_s: float
    deed: Deed
    parts: Parts = Parts.LEFT  # of EXECUTE only


FASTEST_ACCELERATION = 1000.0  # [%] that ACCEL may ask for


@dataclass(frozen=True, slots=True)
class Locks:
    """What a program may not set in a run; a step that sets it has no effect but a finding."""

    names: tuple[str, ...] = ()  # parameters and switches, upper case
    acceleration: float = FASTEST_ACCELERATION  # the most that ACCEL may ask for [%]


@dataclass(frozen=True, slots=True)
class Scenario:
    """Initial state, inputs, answers, faults, seed and limits of one run."""

    configuration: Configuration | None = None  # None: the arm's ready configuration
    hand_opening: float = 0.0  # closed [m]
    seed: int = 0
    inputs: tuple[tuple[float, int, bool], ...] = ()  # (time [s], signal number, state), by time
    limits: Limits = field(default_factory=Limits)
    parameters: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    sensors: tuple[Sensor, ...] = ()
    answers: tuple[str, ...] = ()  # lines that PROMPT reads, in order
    faults: tuple[PlannedFault, ...] = ()  # by time
    monitor_speed: float = 100.0  # operator's speed [%]
    locks: Locks = Locks()
    operator: tuple[Act, ...] = ()  # by time
    draws: tuple[float, ...] = ()  # what RANDOM draws first; then the seed decides
    process_first: tuple[float, ...] = ()  # times [s]; see `MidTick.process_first`
    analog: tuple[tuple[float, int, int], ...] = ()  # (time [s], analog input, counts), by time


def controlled(scene: Scene, model: ControllerModel) -> Scene:
    """Return a scene under a controller model."""
    if scene.controller == model:
        return scene
    return replace(scene, controller=model, robot=timed(scene.robot, model))
