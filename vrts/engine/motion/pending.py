"""A motion that is on the timeline already but may still be taken back."""

from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.engine.motion.corner import Corner
from vrts.engine.motion.given import CutOff
from vrts.engine.motion.plan import Intent


class Pending(NamedTuple):
    """Such a motion, and what it stands in for."""

    start_s: float  # in path time
    corner: Corner
    target: Pose | None  # X_VT
    intent: Intent
    replaced: CutOff  # by its pieces
