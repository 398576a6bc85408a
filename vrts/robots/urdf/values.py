"""Numbers, vectors and poses as attributes of a URDF file write them."""

from vrts.base.pose import (
    IDENTITY,
    X_AXIS,
    Y_AXIS,
    Z_AXIS,
    Pose,
    Vector,
    multiply,
    rotation_about,
)
from vrts.robots.urdf.description import UrdfFault
from vrts.robots.urdf.xml_tree import Element

QUARTER = 1e-9  # [rad] an angle this near to quarter turns is one: files write 12 digits
FARTHEST = 100.0  # [m] any length


def number(element: Element, key: str, default: float | None) -> float:
    """Return an attribute that is one number; the default, or a fault, where it is missing."""
    text = element.attributes.get(key)
    if text is None:
        if default is None:
            raise UrdfFault(f"a `{element.tag}` has no `{key}`", element.line)
        return default
    return _numbers(text, 1, element, key)[0]


def vector(element: Element, key: str, default: Vector | None) -> Vector:
    """Return an attribute that is three numbers; the default, or a fault, where it is missing."""
    text = element.attributes.get(key)
    if text is None:
        if default is None:
            raise UrdfFault(f"a `{element.tag}` has no `{key}`", element.line)
        return default
    x, y, z = _numbers(text, 3, element, key)
    return (x, y, z)


def _numbers(text: str, count: int, element: Element, key: str) -> tuple[float, ...]:
    words = text.split()
    try:
        values = tuple(float(word) for word in words)
    except ValueError:
        values = ()
    if len(values) != count or not all(abs(value) <= FARTHEST for value in values):
        wanted = "a number" if count == 1 else f"{count} numbers"
        raise UrdfFault(f"`{key}` of a `{element.tag}` is not {wanted}", element.line)
    return values


def origin(element: Element) -> Pose:
    """Return the pose that the child `origin` gives; the identity where there is none."""
    given = element.first("origin")
    if given is None:
        return IDENTITY
    roll, pitch, yaw = vector(given, "rpy", (0.0, 0.0, 0.0))
    turn = multiply(
        rotation_about(Z_AXIS, yaw),
        multiply(rotation_about(Y_AXIS, pitch), rotation_about(X_AXIS, roll)),
    )
    return clean(Pose(turn, vector(given, "xyz", (0.0, 0.0, 0.0))))


def clean(X: Pose) -> Pose:
    """Return a pose, its quarter turns exact: files write them with 12 digits."""
    nearest = [float(round(entry)) for entry in X.rotation]
    if any(abs(a - b) > QUARTER for a, b in zip(X.rotation, nearest, strict=True)):
        return X
    r0, r1, r2, r3, r4, r5, r6, r7, r8 = (entry + 0.0 for entry in nearest)
    return Pose((r0, r1, r2, r3, r4, r5, r6, r7, r8), X.translation)
