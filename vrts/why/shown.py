"""Values, places and directions in words: X Y Z in mm as programs write them."""

from vrts.base.oat import components
from vrts.base.pose import Pose, Vector
from vrts.base.units import deg, mm
from vrts.engine.memory.cells import Content, Undefined

LEAST = 0.5e-3  # [m] less than this is not told as an offset
STRAIGHT_DOWN = -0.9998  # of the hand's axis along Z: within a degree


def length(value_m: float) -> str:
    """Return a length in mm without decimals that say nothing: "340", "2.5"."""
    value = mm(value_m)
    return (
        f"{value:.0f}" if abs(value) >= 10 or abs(value - round(value)) < 0.05 else f"{value:.1f}"
    )


def point(at: Vector) -> str:
    """Return a point as X, Y and Z in mm."""
    return "X {} Y {} Z {}".format(*(_whole(x) for x in at))


def value(content: Content) -> str:
    """Return a value of the language."""
    match content:
        case Undefined():
            return "without a value"
        case Pose():
            turned = " ".join(
                f"{angle:g}" for angle in (round(a, 2) + 0.0 for a in _angles(content))
            )
            return f"{point(content.translation)}, angles {turned}"
        case str():
            return f'"{content}"'
        case float() | int():
            return f"{content:.7g}"
        case tuple():
            joints = " ".join(f"{round(deg(x), 2) + 0.0:g}" for x in content)
            return f"joints {joints} degrees"


def where_of(content: Content) -> str:
    """Return a value without the angles of a location at which the hand points down."""
    down = isinstance(content, Pose) and content.rotation[8] < STRAIGHT_DOWN
    return point(content.translation) if isinstance(content, Pose) and down else value(content)


def offset(apart: Vector, least: float = LEAST) -> tuple[str, str]:
    """Return in which direction something is off, and how far: both "" where it is not.

    Args:
        apart: From where it should be to where it is, in W [m].
        least: What counts.
    """
    names = (("too far in +X", "too far in -X"), ("too far in +Y", "too far in -Y"))
    found: list[tuple[float, str]] = []
    for axis in (0, 1):
        found.append((abs(apart[axis]), names[axis][apart[axis] < 0]))
    found.append((abs(apart[2]), "too low" if apart[2] < 0 else "too high"))
    told = sorted((one for one in found if one[0] >= least), reverse=True)
    largest = told[0][0] if told else 0.0
    told = [one for one in told if one[0] >= 0.05 * largest]
    direction = " and ".join(words for _, words in told)
    amount = " and ".join(f"{length(size)} mm {words}" for size, words in told)
    return direction, amount


def _whole(x: float) -> str:
    return f"{round(mm(x), 1) + 0.0:g}"


def _angles(pose: Pose) -> tuple[float, ...]:
    return tuple(components(pose)[3:])
