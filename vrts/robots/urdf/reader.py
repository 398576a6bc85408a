"""A six-axis arm from a URDF description: its joints, limits and the shapes of its links.

Reads text only; meshes are asked for by the name the file gives them.
"""

from vrts.robots.urdf.collision_shapes import read_parts
from vrts.robots.urdf.description import JOINTS, Description, UrdfFault
from vrts.robots.urdf.frames import placed_links
from vrts.robots.urdf.joints import flange_of, in_a_row, read_joints, root_first
from vrts.robots.urdf.xml_tree import Element, XmlFault, read_xml


def read_urdf(data: bytes, flange: str | None = None) -> Description:
    """Return the arm that a URDF file describes.

    Args:
        data: The file.
        flange: Name of the link whose frame is the flange: z out of it. None: `tool0` or
            `flange`, else the link behind the last joint.

    Raises:
        UrdfFault: The file is not URDF, or the arm does not have six turning joints in a row.
    """
    try:
        root = read_xml(data)
    except XmlFault as fault:
        raise UrdfFault(fault.message, fault.line) from fault
    if root.tag != "robot":
        raise UrdfFault(f"the file describes a `{root.tag}`, not a `robot`", root.line)
    links = _links(root)
    joints = root_first(read_joints(root, links))
    name = flange or flange_of(links, joints)
    if name not in links:
        raise UrdfFault(f"there is no link `{name}`")
    moving = in_a_row(joints, name)
    placed, frames = placed_links(links, joints, moving)
    if placed[name].joint != JOINTS:
        raise UrdfFault(f"`{name}` is not behind the sixth joint")
    return Description(
        root.attributes.get("name") or "robot",
        frames,
        placed[name].X_LU,
        tuple(joint.lower for joint in moving),
        tuple(joint.upper for joint in moving),
        tuple(joint.speed for joint in moving),
        tuple(joint.name for joint in moving),
        read_parts(links, placed),
    )


def _links(root: Element) -> dict[str, Element]:
    found: dict[str, Element] = {}
    for link in root.all("link"):
        name = link.attributes.get("name", "")
        if not name or name in found:
            fault = f"another link is called `{name}`" if name else "a link has no name"
            raise UrdfFault(fault, link.line)
        found[name] = link
    if not found:
        raise UrdfFault("there are no links", root.line)
    return found
