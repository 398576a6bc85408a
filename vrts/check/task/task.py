"""What an assignment asks for."""

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from vrts.base.pose import Pose, Vector
from vrts.base.source import Span
from vrts.check.task.demands import Demand
from vrts.check.task.late_rules import Keep, LateRules


class Goal(NamedTuple):
    """An object that must end at rest in a pose."""

    body: str
    X_WG: Pose
    position_tolerance: float  # [m]
    orientation_tolerance: float  # [rad], about axes that are not the body's symmetry axis
    weight: Fraction
    title: str  # "can1 on base2"
    span: Span | None


class ViaPoint(NamedTuple):
    """A point the tool must pass; all that is asked for has to be true at one instant."""

    name: str
    point: Vector  # in W [m]
    radius: float  # [m]
    span: Span | None
    approach: Vector | None = None  # where the tool is to point, in W, of length 1; None: anywhere
    cone: float = math.pi  # angle [rad] from there that is allowed
    slowest: float = 0.0  # [m/s] of the tool, at an instant within the radius
    fastest: float = math.inf


@dataclass(frozen=True, slots=True)
class MarkScheme:
    """The numbers of `[mark]`; defaults are those of the published system's successor."""

    targets: Fraction = Fraction(6)
    vias: Fraction = Fraction(5, 2)
    first_contact: Fraction = Fraction(3, 2)
    further_contact: Fraction = Fraction(1)
    contact_cap: Fraction = Fraction(5)
    time_bonus: Fraction = Fraction(3, 2)
    zero_at: Fraction = Fraction(3)  # a goal earns nothing from this multiple of its tolerance


@dataclass(frozen=True, slots=True)
class Task:
    """An assignment: scene, goals, via points, times and weights."""

    name: str
    title: str
    scene: str  # as written in the file: a name or a relative path
    program: str | None  # program to EXECUTE; None: the first of the file
    goals: tuple[Goal, ...]
    vias: tuple[ViaPoint, ...]
    ordered: bool  # via points in the order of the file
    t_par: float  # [s]
    t_max: float  # [s]
    mark: MarkScheme
    digest: str  # sha256 of the file
    demands: tuple[Demand, ...] = ()  # zones, limits, rules
    near_miss: float | None = None  # nearer than this is a near miss [m]; None: as usual
    late: LateRules | None = None  # what lateness costs; None: nothing
    keep: Keep = Keep.LATEST  # which of several hand-ins counts
