"""The collision elements of the links of a URDF file."""

from vrts.base.pose import Pose
from vrts.robots.urdf.description import Part, Shape, UrdfFault
from vrts.robots.urdf.frames import Placed
from vrts.robots.urdf.values import clean, number, origin, vector
from vrts.robots.urdf.xml_tree import Element

MOST_SHAPES = 100  # of all links


def read_parts(links: dict[str, Element], placed: dict[str, Placed]) -> tuple[Part, ...]:
    """Return the collision shapes of every link, in the frame that it moves with."""
    found = [
        Part(
            name,
            placed[name].joint,
            tuple(_shape(element, placed[name].X_LU) for element in link.all("collision")),
        )
        for name, link in links.items()
    ]
    if sum(len(part.shapes) for part in found) > MOST_SHAPES:
        raise UrdfFault(f"more than {MOST_SHAPES} shapes; simplify them")
    return tuple(sorted(found, key=lambda part: part.joint))


def _shape(collision: Element, X_LU: Pose) -> Shape:
    X_LP = clean(X_LU @ origin(collision))
    geometry = collision.first("geometry")
    for element in [] if geometry is None else geometry.children:
        line = element.line
        match element.tag:
            case "box":
                size = vector(element, "size", None)
                return Shape("box", _positive(size, element), "", X_LP, line)
            case "cylinder":
                size = (number(element, "radius", None), number(element, "length", None))
                return Shape("cylinder", _positive(size, element), "", X_LP, line)
            case "sphere":
                size = (number(element, "radius", None),)
                return Shape("sphere", _positive(size, element), "", X_LP, line)
            case "mesh":
                factors = vector(element, "scale", (1.0, 1.0, 1.0))
                return Shape("mesh", factors, element.attributes.get("filename", ""), X_LP, line)
            case _:
                pass
    raise UrdfFault("a collision has no box, cylinder, sphere or mesh", collision.line)


def _positive(size: tuple[float, ...], element: Element) -> tuple[float, ...]:
    if min(size) <= 0.0:
        raise UrdfFault(f"a `{element.tag}` has no size", element.line)
    return size
