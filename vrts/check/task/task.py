"""What an assignment asks for."""

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from vrts.base.pose import Vector
from vrts.base.source import Span
from vrts.check.rules.hints import Hints
from vrts.check.rules.proof_demand import EVERY_FUTURE, ProofDemand
from vrts.check.rules.scheme import MarkScheme
from vrts.check.rules.settings import USUAL_LOCKS
from vrts.check.task.demands import Demand
from vrts.check.task.goals import Goal, Relation
from vrts.check.task.late_rules import Keep, LateRules
from vrts.check.variants.model import Variants
from vrts.scene.model import Locks


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


class Cost(NamedTuple):
    """What it costs when a demand is not kept."""

    name: str  # as shown
    points: Fraction


@dataclass(frozen=True, slots=True)
class Task:
    """An assignment: scene, goals, via points, times and weights."""

    name: str
    title: str
    scene: str  # as written in the file: a name or a relative path
    program: str | None  # program to EXECUTE; None: the main one of the file
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
    relations: tuple[Relation, ...] = ()
    locks: Locks = USUAL_LOCKS  # what programs may not set
    proof: ProofDemand | None = None  # what is asked about every future; None: nothing
    hints: Hints = Hints.EDIT  # what authors of programs may be told of what would mend them
    description: str = ""  # what is to be done, in the words of who set the task
    variants: Variants | None = None  # of which each student gets one; None: all have this task
    offline: bool = False  # an exam in which students are to work without a network

    @property
    def targets(self) -> tuple[Goal | Relation, ...]:
        """Goals and relations: they share the points of targets by their weights."""
        return (*self.goals, *self.relations)

    @property
    def costs(self) -> tuple[Cost, ...]:
        """What every demand costs, in the order of their verdicts: every future comes last."""
        found = [Cost(demand.name, demand.points) for demand in self.demands]
        if self.proof is not None:
            found.append(Cost(EVERY_FUTURE, self.proof.points))
        return tuple(found)
