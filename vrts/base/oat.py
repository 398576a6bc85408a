"""VAL's orientation angles O, A, T, and locations as VAL prints them.

`R(O, A, T) = Rz(O) M0 Ry(A) Rz(T)`, where M0 is the hand level along -Y with its fingers along X
[UNI2V1977]_. Equal to Z-Y'-Z'' Euler angles (O - 90, A + 90, T) in degrees.
"""

import math
from typing import TypeAlias

from vrts.base.pose import Pose, Rotation
from vrts.base.units import DEG, MM

# below this hypot(a_x, a_y) the tool is vertical [manual language/locations#vertical-tolerance]
VERTICAL_TOLERANCE = 1e-7
LAST_BIT = 2.0**-24  # of a number in single precision, as a share of it

Components: TypeAlias = tuple[float, float, float, float, float, float]


def rotation_from_oat(o: float, a: float, t: float) -> Rotation:
    """Return the rotation of the angles O, A, T in degrees. Exact at multiples of 90 degrees."""
    so, co = _sine_cosine(o)
    sa, ca = _sine_cosine(a)
    st, ct = _sine_cosine(t)
    return (
        co * st - so * sa * ct,
        co * ct + so * sa * st,
        so * ca,
        so * st + co * sa * ct,
        so * ct - co * sa * st,
        -co * ca,
        -ca * ct,
        ca * st,
        -sa,
    )


def oat_from_rotation(rotation: Rotation) -> tuple[float, float, float]:
    """Return O, A, T in degrees with A in [-90, 90].

    With the tool vertical only O - T or O + T is defined; T is then 0 [assumed, manual
    language/locations#vertical].
    """
    _, r12, r13, _, r22, r23, r31, r32, r33 = rotation
    level = math.hypot(r13, r23)
    a = math.atan2(-r33, level)
    if level < VERTICAL_TOLERANCE:
        return (_tidy(math.atan2(r22, r12)), _tidy(a), 0.0)
    return (_tidy(math.atan2(r13, -r23)), _tidy(a), _tidy(math.atan2(r32, -r31)))


def pose_from_components(x: float, y: float, z: float, o: float, a: float, t: float) -> Pose:
    """Return the pose that VAL writes as X Y Z (mm) and O A T (degrees)."""
    return Pose(rotation_from_oat(o, a, t), (x * MM, y * MM, z * MM))


def components(pose: Pose) -> Components:
    """Return X Y Z in mm and O A T in degrees."""
    x, y, z = pose.translation
    return (x / MM, y / MM, z / MM, *oat_from_rotation(pose.rotation))


def known_components(pose: Pose) -> Components:
    """Return the same as single precision knows them [manual language/locations#noise].

    Beside the largest length, or beside half a turn, what is smaller than its last bit is 0.
    """
    found = components(pose)
    least = max(map(abs, found[:3])) * LAST_BIT
    x, y, z = (0.0 if abs(length) < least else length for length in found[:3])
    o, a, t = (0.0 if abs(angle) < 180.0 * LAST_BIT else angle for angle in found[3:])
    return x, y, z, o, a, t


def plain_angles(o: float, a: float, t: float) -> tuple[float, float, float]:
    """Return yaw, pitch and roll in degrees, as V+ and AS print them: Z-Y'-Z'' angles.

    With the tool vertical yaw is 0 and roll has all the turn [manual
    language/locations#vertical].
    """
    yaw, pitch = _within(o - 90.0), a + 90.0
    if 90.0 - abs(a) <= VERTICAL_TOLERANCE / DEG:
        return 0.0, pitch, _within(t + yaw if pitch < 90.0 else t - yaw)
    return yaw, pitch, t


def _within(degrees: float) -> float:
    """Return an angle in (-180, 180]."""
    turned = degrees - 360.0 * math.ceil((degrees - 180.0) / 360.0)
    return turned + 0.0


def _sine_cosine(degrees: float) -> tuple[float, float]:
    quarter = round(degrees / 90.0)
    rest = (degrees - 90.0 * quarter) * DEG
    s, c = math.sin(rest), math.cos(rest)
    match quarter % 4:
        case 0:
            return (s, c)
        case 1:
            return (c, -s)
        case 2:
            return (-s, -c)
        case _:
            return (-c, s)


def _tidy(radians: float) -> float:
    degrees = radians / DEG
    return 180.0 if degrees == -180.0 else degrees + 0.0
