"""Locations compared as a controller prints them."""

import math

from vrts.base.oat import rotation_from_oat
from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.transfer.listed import Place
from vrts.lang.dialect import Angles, Dialect

_REST = 1e-9  # what is left of a difference of decimals


def same_place(wanted: Place, found: Place, profile: Profile) -> bool:
    """Return whether two locations are the same within what the controller prints.

    Positions and joints have to agree within half a unit of the last decimal: a controller may
    round a half either way. The angles of a pose may be others as long as they turn the same: they
    do not tell turns apart where the tool is vertical.
    """
    if wanted.is_joints != found.is_joints:
        return False
    ours, theirs = _numbers(wanted.values), _numbers(found.values)
    fine = 0.5 * 10.0**-profile.angle_decimals
    if wanted.is_joints:
        return _near(ours, theirs, fine)
    coarse = 0.5 * 10.0**-profile.length_decimals
    return _near(ours[:3], theirs[:3], coarse) and (
        _near(ours[3:], theirs[3:], fine)
        or _turn_deg(ours[3:], theirs[3:], profile.language) <= 3.0 * fine
    )


def is_nowhere(place: Place, dialect: Dialect) -> bool:
    """Return whether a location is what POINT begins with: no displacement, no turn."""
    numbers = _numbers(place.values)
    turned = dialect.angles is Angles.OAT and not place.is_joints
    return numbers == ((0.0, 0.0, 0.0, 90.0, -90.0, 0.0) if turned else (0.0,) * 6)


def _numbers(values: tuple[str, ...]) -> tuple[float, ...]:
    return tuple(float(value) + 0.0 for value in values)


def _near(ours: tuple[float, ...], theirs: tuple[float, ...], within: float) -> bool:
    return all(abs(a - b) <= within + _REST for a, b in zip(ours, theirs, strict=True))


def _turn_deg(ours: tuple[float, ...], theirs: tuple[float, ...], dialect: Dialect) -> float:
    """Return by how much two orientations differ [deg]."""
    shift = (90.0, -90.0) if dialect.angles is Angles.ZYZ else (0.0, 0.0)
    one, other = (rotation_from_oat(o + shift[0], a + shift[1], t) for o, a, t in (ours, theirs))
    trace = sum(a * b for a, b in zip(one, other, strict=True))
    distance = math.sqrt(max(3.0 - trace, 0.0))  # 2 sin(angle/2), exact for small angles
    return math.degrees(2.0 * math.asin(min(distance / 2.0, 1.0)))
