"""Joint-interpolated motion: all joints start and stop together."""

from vrts.engine.profile import Profile, profile
from vrts.robots.model import Configuration, SphericalWristArm

Piece = tuple[float, float, tuple[tuple[float, ...], ...]]
"""Start and end [s] from the motion's start; six rows of coefficients from the piece's start."""


def joint_profile(
    arm: SphericalWristArm, start: Configuration, goal: Configuration, speed_fraction: float
) -> Profile:
    """Return the time scaling: the joint that needs longest sets the time."""
    needed = max(
        abs(b - a) / (v * speed_fraction) for a, b, v in zip(start, goal, arm.speed, strict=True)
    )
    return profile(needed, arm.acceleration_time, arm.tick)


def joint_pieces(start: Configuration, goal: Configuration, scaling: Profile) -> list[Piece]:
    """Return the polynomials of the six joints."""
    pieces: list[Piece] = []
    change = [b - a for a, b in zip(start, goal, strict=True)]
    for phase in scaling.phases():
        c0, c1, c2 = phase.coefficients
        rows = tuple((a + d * c0, d * c1, d * c2) for a, d in zip(start, change, strict=True))
        pieces.append((phase.start_s, phase.start_s + phase.length_s, rows))
    return pieces
