"""What a sensor of the scenario sees: the centres of mass of bodies, or the tip of the tool.

A body is inside a region when its centre of mass is: one point, which anybody can work out from
the scene, and no size or orientation counts. The tool is inside when the origin of the tool frame
is, which is the middle between the pads unless the program sets TOOL. The faces of a region belong
to it. The engine asks at every tick, so what crosses a region within one tick is not seen.
"""

from collections.abc import Mapping
from types import MappingProxyType

from vrts.base.pose import Pose, Vector
from vrts.scene.model import Mobility, Region, Scene, Sensor

TOOL = "tool"  # in `Sensor.sees`: the tip of the tool, not a body


def movable_centres(scene: Scene) -> Mapping[str, Vector]:
    """Return the centre of mass, in O [m], of every body that can be carried, by name."""
    return MappingProxyType(
        {
            body.name: body.centre_of_mass
            for body in scene.bodies
            if body.mobility is Mobility.MOVABLE
        }
    )


def is_on(
    sensor: Sensor, where: Mapping[str, Pose], centres: Mapping[str, Vector], X_WT: Pose
) -> bool:
    """Return the state that a sensor gives its input: what it sees, turned round if inverted."""
    return sees(sensor, where, centres, X_WT) is not sensor.inverted


def sees(
    sensor: Sensor, where: Mapping[str, Pose], centres: Mapping[str, Vector], X_WT: Pose
) -> bool:
    """Return whether anything that a sensor looks for is inside its region.

    Args:
        sensor: The sensor. It looks for every body of `centres` when it names nothing.
        where: Pose X_WO of every body.
        centres: Centre of mass, in O [m], of every body that can be carried: `movable_centres`.
        X_WT: Pose of the tool.

    Raises:
        KeyError: The sensor names a body that `centres` or `where` does not hold.
    """
    for name in sensor.sees or centres:
        point = X_WT.translation if name == TOOL else where[name].apply(centres[name])
        if holds(sensor.region, point):
            return True
    return False


def holds(region: Region, point: Vector) -> bool:
    """Return whether a point of W [m] is inside a region, faces included."""
    x, y, z = point
    (x0, y0, z0), (x1, y1, z1) = region
    return x0 <= x <= x1 and y0 <= y <= y1 and z0 <= z <= z1
