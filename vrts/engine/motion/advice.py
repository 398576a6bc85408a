"""Slower motions tried, to tell which SPEED would do: for so many motions of a run and no more."""

from collections.abc import Sequence

from vrts.base.pose import Pose
from vrts.base.units import DEG
from vrts.engine.faults import RuntimeFault
from vrts.engine.motion.lines.set_points import Piece
from vrts.engine.motion.overspeed import Planning, overspeed, past_singularity
from vrts.engine.motion.plan import Intent, from_rest
from vrts.engine.motion.remarks import Overspeed
from vrts.robots.model import Arm

MOST_ADVISED = 50  # motions of a run for which slower ones are tried: each costs like several


class Advice:
    """What would do instead of a motion that is too fast."""

    def __init__(self, arm: Arm, advised: int = 0) -> None:
        """Start with the motions for which slower ones were tried already."""
        self.arm = arm
        self.advised = advised

    def copy(self) -> "Advice":
        """Return one that goes on counting by itself."""
        return Advice(self.arm, self.advised)

    def on_overspeed(
        self,
        intent: Intent,
        pieces: Sequence[Piece],
        rate_of_time: float,
        plannings: Sequence[Planning],
    ) -> Overspeed | None:
        """Return what is too fast in a motion and what would do; arguments as for `overspeed`."""
        tried = plannings if self.advised < MOST_ADVISED else ()
        found = overspeed(self.arm, pieces, rate_of_time, intent, tried)
        self.advised += found is not None
        return found

    def past(
        self, intent: Intent, fault: RuntimeFault, rate_of_time: float, X_FT: Pose
    ) -> int | None:
        """Return the SPEED at which a line gets past the singularity that stops it, if known."""
        needed = fault.data.get("needed_deg_s")
        if not isinstance(needed, float) or self.advised >= MOST_ADVISED:
            return None
        self.advised += 1
        share = needed * DEG / self.arm.speed[fault.joint - 1]
        planning = self.whole(X_FT)
        return past_singularity(self.arm, rate_of_time, intent, planning, share)

    def whole(self, X_FT: Pose) -> Planning:
        """Return what plans motions from rest that get to their ends."""

        def planning(intent: Intent) -> list[Piece] | None:
            planned = from_rest(self.arm, X_FT, intent)
            return planned.pieces if planned.fault is None else None

        return planning

    def as_far_as_it_goes(self, X_FT: Pose) -> Planning:
        """Return what plans motions from rest, of those that are stopped the first part."""

        def planning(intent: Intent) -> list[Piece] | None:
            return from_rest(self.arm, X_FT, intent).pieces

        return planning
