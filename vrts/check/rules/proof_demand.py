"""What a task asks about every future of a program, as data: what is proven is not known here."""

from dataclasses import dataclass
from fractions import Fraction

from vrts.base.source import Span

EVERY_FUTURE = "every future"  # name of the demand
USUAL_STATES = 20_000  # a budget that does not depend on how fast a machine is
COSTS = Fraction(3, 10)  # of all points, where a task does not say


@dataclass(frozen=True, slots=True)
class ProofDemand:
    """That nothing goes wrong, whatever comes from outside; and what it costs if it does."""

    points: Fraction  # lost when something can go wrong
    states: int  # most that are looked at; if more are left, nobody can tell
    span: Span  # of `[prove]`
    environment: str | None = None  # file beside the task that says what may come from outside
    inline: bool = False  # whether the task itself says it, in `[prove.environment]`
    hidden: bool = False  # whether it counts at marking only
