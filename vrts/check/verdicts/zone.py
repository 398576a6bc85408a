"""Does any part of the robot, or what it holds, enter a zone?"""

from dataclasses import replace

from vrts.base.pose import translation
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.pairs.pairs import ROBOT
from vrts.check.curves.certified import Peak
from vrts.check.task.demands import Demand
from vrts.engine.run import Run
from vrts.geometry.proposing.proposer import Proposer
from vrts.geometry.shapes import Box, Piece
from vrts.scene.model import Body, Mobility

GREY = (0.5, 0.5, 0.5)


def robot_in(run: Run, demand: Demand, proposer: Proposer | None) -> tuple[Peak, str]:
    """Return when the robot is in a zone, and which part of it enters first.

    The certified collision check is asked, with the zone as one more body.
    """
    a, b, c = (0.5 * (high - low) for low, high in zip(demand.lower, demand.upper, strict=True))
    x, y, z = (0.5 * (high + low) for low, high in zip(demand.lower, demand.upper, strict=True))
    name = f"zone {demand.name}"
    piece = Piece(Box((a, b, c)), translation(0.0, 0.0, 0.0))
    zone = Body(
        name, name, "box", Mobility.FIXED, (piece,), translation(x, y, z), GREY, (0.0, 0.0, 0.0)
    )
    scene = replace(run.scene, bodies=(*run.scene.bodies, zone))
    report = check_collisions(scene, run, clearance=False, proposer=proposer)
    entered = [e for e in report.contacts if e.first == ROBOT and e.second == name]
    doubtful = [e for e in report.undetermined if e.first == ROBOT and e.second == name]
    found = Peak(
        entered[0].start_s if entered else None,
        doubtful[0].start_s if doubtful else None,
        max((e.depth_m for e in entered), default=0.0),
        entered[0].deepest_s if entered else 0.0,
        report.statistics.get("intervals", 0),
    )
    return found, entered[0].parts[0] if entered else ""
