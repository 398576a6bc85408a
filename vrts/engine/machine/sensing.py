"""Sensors of a scenario: inputs that are on while something is in a region of the workspace."""

from vrts.base.pose import Pose
from vrts.engine.memory.records import pose_of
from vrts.engine.programs.system import System
from vrts.robots.kinematics.kinematics import hand_pose
from vrts.scene.model import Scenario, Scene
from vrts.scene.sensors import is_on, movable_centres


class Sensing:
    """Looks at the regions while anything moves. Holds no state."""

    def __init__(self, scene: Scene, scenario: Scenario) -> None:
        """Take the sensors of a scenario."""
        self.sensors = scenario.sensors
        self._centres = movable_centres(scene)

    def next_s(self, system: System, now: float, tick: float) -> float | None:
        """Return when the sensors have to be looked at next; None when nothing moves."""
        if not self.sensors:
            return None
        moves = system.planner.motion_end > now
        falls = any(
            track[-1].start_s > now - tick or (len(track) > 1 and track[-1].start_s > now)
            for track in system.hand.placements.values()
        )
        return now + tick if moves or falls or now == 0.0 else None

    def sample(self, system: System, now: float) -> list[tuple[int, bool]]:
        """Set the inputs; return those that changed."""
        if not self.sensors:
            return []
        planner = system.planner
        X_WF = hand_pose(planner.arm, planner.configuration_at(now))
        where: dict[str, Pose] = {}
        for name, track in system.hand.placements.items():
            placement = next(p for p in reversed(track) if p.start_s <= now)
            where[name] = pose_of(placement, now, X_WF)
        changed: list[tuple[int, bool]] = []
        for sensor in self.sensors:
            on = is_on(sensor, where, self._centres, X_WF @ planner.tool)
            if system.signals.turn(sensor.signal, on=on):
                changed.append((sensor.signal, on))
        return changed
