"""A map of a scene: top and side view on a millimetre grid, as SVG."""

from collections.abc import Sequence
from html import escape

from vrts.base.pose import X_AXIS, Y_AXIS, Z_AXIS, Pose, Vector, scale
from vrts.base.units import mm
from vrts.geometry.shapes import Piece
from vrts.report.plain import visible
from vrts.robots.kinematics.kinematics import link_poses
from vrts.scene.colors import hex_code
from vrts.scene.model import Body, Scene
from vrts.scene.outline import outline

STEP = 100  # [mm] between thin grid lines; every fifth is thick and labelled
MARGIN = 90.0  # [mm] round each view
WORK_RINGS = (650.0, 1400.0)  # [mm] where the hand works well [assumed]
LEFT, UP = Y_AXIS, Z_AXIS
GAP = 160.0  # [mm] between the views

NAME = "vrts-scene"  # class of the drawing: where it stands in a page, all else keeps its looks
STYLE = f"""
.{NAME} text {{ font: 26px system-ui, sans-serif; fill: #243040 }}
.{NAME} .name {{ font-weight: 600; paint-order: stroke; stroke: #ffffffd0; stroke-width: 7px }}
.{NAME} .tick {{ font-size: 20px; fill: #6b7787 }}
.{NAME} .title {{ font-size: 32px; font-weight: 700 }}
.{NAME} .thin {{ stroke: #e3e7ec; stroke-width: 1 }}
.{NAME} .thick {{ stroke: #c9d0d9; stroke-width: 1.6 }}
.{NAME} .body {{ stroke: #1d2733; stroke-width: 2.5; stroke-linejoin: round }}
.{NAME} .robot {{ fill: #d8d2c6; stroke: #5d574c; stroke-width: 2; fill-opacity: .75 }}
.{NAME} .ring {{ fill: none; stroke: #2f7d5b; stroke-width: 2.5; stroke-dasharray: 12 8 }}
.{NAME} .ringname {{ fill: #2f7d5b; font-size: 21px }}
.{NAME} .place {{ fill: #b4232f }}
.{NAME} .placename {{ fill: #b4232f; font-size: 21px; paint-order: stroke; stroke: #ffffffd0;
 stroke-width: 6px }}
"""


class View:
    """One projection: which axis points right and which up, and what part of it is shown [mm]."""

    def __init__(
        self, title: str, right: Vector, up: Vector, box: tuple[float, float, float, float]
    ) -> None:
        """Take the axes in W and left, right, bottom, top."""
        self.title, self.right, self.up = title, right, up
        self.left, self.end, self.bottom, self.top = box

    @property
    def width(self) -> float:
        """Width of the picture [mm]."""
        return self.end - self.left

    @property
    def height(self) -> float:
        """Height of the picture [mm]."""
        return self.top - self.bottom

    def at(self, point: tuple[float, float]) -> tuple[float, float]:
        """Return where a point of the plane [mm] lies in the picture."""
        return (point[0] - self.left, self.top - point[1])

    def polygon(self, pieces: Sequence[Piece], X_WO: Pose) -> str:
        """Return the outline of a body as an SVG points attribute."""
        corners = outline(pieces, X_WO, self.right, self.up)
        placed = (self.at((mm(u), mm(v))) for u, v in corners)
        return " ".join(f"{x:.1f},{y:.1f}" for x, y in placed)


def scene_svg(scene: Scene) -> str:
    """Return the drawing."""
    lowest = -mm(scene.robot.arm.shoulder_height)
    top = View("seen from above", scale(LEFT, -1.0), X_AXIS, (-950.0, 950.0, -420.0, 1600.0))
    side = View("seen from its right side", X_AXIS, UP, (-420.0, 1600.0, lowest - 60.0, 700.0))
    width = MARGIN * 4 + top.width + GAP + side.width
    height = MARGIN * 2 + 60.0 + max(top.height, side.height)
    body = [
        _view(scene, top, MARGIN * 1.5, MARGIN + 60.0),
        _view(scene, side, MARGIN * 2.5 + top.width + GAP, MARGIN + 60.0),
    ]
    title = f'<text class="title" x="{MARGIN}" y="{MARGIN * 0.7}">{_escaped(scene.title)}</text>'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="{NAME}" '
        f'viewBox="0 0 {width:.0f} {height:.0f}" role="img" '
        f'aria-label="{_escaped(scene.title)}, {top.title} and {side.title}">'
        f"<style>{STYLE}</style>"
        f'<rect width="100%" height="100%" fill="#ffffff"/>{title}{"".join(body)}</svg>\n'
    )


def _view(scene: Scene, view: View, x: float, y: float) -> str:
    above = view.up == X_AXIS
    parts = [f'<g transform="translate({x:.0f} {y:.0f})">']
    parts.append(f'<text class="name" x="0" y="-34">{view.title}</text>')
    parts.append(_grid(view))
    if above:
        parts += [_ring(view, radius) for radius in WORK_RINGS]
    parts.append(_robot(scene, view, above=above))
    bodies = sorted(
        (b for b in scene.bodies if b.name != "floor"),
        key=lambda b: b.X_WO.translation[2] if above else -b.X_WO.translation[1],
    )
    taken: list[tuple[float, float]] = []
    parts += [_body(view, body) for body in bodies]
    parts += [_name(view, body, taken) for body in bodies]
    parts += [_place(view, name, X, taken) for name, X in scene.locations.items()]
    parts.append(_frame(view))
    parts.append("</g>")
    return "".join(parts)


def _grid(view: View) -> str:
    lines: list[str] = []
    flip = -1 if view.right == scale(LEFT, -1.0) else 1
    names = ("Y", "X") if flip < 0 else ("X", "Z")
    for value in range(_first(view.left), int(view.end) + 1, STEP):
        x, _ = view.at((value, 0))
        kind = "thick" if value % 500 == 0 else "thin"
        lines.append(f'<line class="{kind}" x1="{x}" x2="{x}" y1="0" y2="{view.height:.0f}"/>')
        if value % 500 == 0:
            label = f"{names[0]} {flip * value}"
            lines.append(
                f'<text class="tick" x="{x}" y="{view.height + 28:.0f}" '
                f'text-anchor="middle">{label}</text>'
            )
    for value in range(_first(view.bottom), int(view.top) + 1, STEP):
        _, y = view.at((0, value))
        kind = "thick" if value % 500 == 0 else "thin"
        lines.append(f'<line class="{kind}" y1="{y}" y2="{y}" x1="0" x2="{view.width:.0f}"/>')
        if value % 500 == 0:
            lines.append(
                f'<text class="tick" x="-10" y="{y + 7:.0f}" text-anchor="end">'
                f"{names[1]} {value}</text>"
            )
    return "".join(lines)


def _first(lowest: float) -> int:
    return int(-(-lowest // STEP)) * STEP


def _ring(view: View, radius: float) -> str:
    x, y = view.at((0.0, 0.0))
    half = min(radius, view.width / 2 - 4)
    up = (radius * radius - half * half) ** 0.5
    label_x, label_y = x + radius * 0.6428, y - radius * 0.766
    inside = label_x < view.width - 80
    text = (
        f'<text class="ringname" x="{label_x + 8:.0f}" y="{label_y:.0f}">{radius:.0f} mm</text>'
        if inside
        else ""
    )
    return (
        f'<path class="ring" d="M{x - half:.1f} {y - up:.1f} '
        f'A{radius} {radius} 0 0 1 {x + half:.1f} {y - up:.1f}"/>{text}'
    )


def _robot(scene: Scene, view: View, *, above: bool) -> str:
    """Return the base and turret from above; from the side the whole arm as it stands at READY."""
    arm = scene.robot.arm
    poses = link_poses(arm, arm.ready)
    links = arm.links[:2] if above else arm.links[:3]
    drawn = [
        f'<polygon class="robot" points="{view.polygon((piece,), poses[link.joint])}"/>'
        for link in links
        for piece in link.pieces
    ]
    clip = f"{NAME}-{view.width:.0f}-{view.height:.0f}"  # of one size wherever it has one name
    return (
        f'<clipPath id="{clip}"><rect width="{view.width:.0f}" height="{view.height:.0f}"/>'
        f'</clipPath><g clip-path="url(#{clip})">{"".join(drawn)}</g>'
    )


def _body(view: View, body: Body) -> str:
    return "".join(
        f'<polygon class="body" fill="{hex_code(color)}" '
        f'points="{view.polygon((piece,), body.X_WO)}"/>'
        for piece, color in body.painted
    )


def _name(view: View, body: Body, taken: list[tuple[float, float]]) -> str:
    corners = outline(body.pieces, body.X_WO, view.right, view.up)
    x, y = view.at((mm(min(u for u, _ in corners)), mm(max(v for _, v in corners))))
    right, _ = view.at((mm(max(u for u, _ in corners)), 0.0))
    place = _free(((x + right) / 2, y - 10), taken)
    return (
        f'<text class="name" x="{place[0]:.0f}" y="{place[1]:.0f}" '
        f'text-anchor="middle">{_escaped(body.name)}</text>'
    )


def _place(view: View, name: str, X_WT: Pose, taken: list[tuple[float, float]]) -> str:
    px, py, pz = X_WT.translation
    point = (-mm(py), mm(px)) if view.up == X_AXIS else (mm(px), mm(pz))
    x, y = view.at(point)
    tx, ty = _free((x + 14, y + 30), taken)
    return (
        f'<circle class="place" cx="{x:.0f}" cy="{y:.0f}" r="7"/>'
        f'<text class="placename" x="{tx:.0f}" y="{ty:.0f}">{_escaped(name)}</text>'
    )


def _free(place: tuple[float, float], taken: list[tuple[float, float]]) -> tuple[float, float]:
    """Return a place for a name that lies over no other, moved down as far as it takes."""
    x, y = place
    while any(abs(x - a) < 120 and abs(y - b) < 26 for a, b in taken):
        y += 27
    taken.append((x, y))
    return x, y


def _frame(view: View) -> str:
    """Return the axes of the base frame."""
    x, y = view.at((0.0, 0.0))
    above = view.up == X_AXIS
    across = (-220.0, "Y", "#2e8540") if above else (220.0, "X", "#c62828")
    upward = (220.0, "X", "#c62828") if above else (220.0, "Z", "#1f5fbf")
    length, name, color = across
    drawn = (
        f'<line x1="{x}" y1="{y}" x2="{x + length}" y2="{y}" stroke="{color}" stroke-width="7"/>'
        f'<text class="name" x="{x + length * 1.14:.0f}" y="{y + 9}" fill="{color}" '
        f'text-anchor="middle">{name}</text>'
    )
    length, name, color = upward
    return (
        f'{drawn}<line x1="{x}" y1="{y}" x2="{x}" y2="{y - length}" stroke="{color}" '
        f'stroke-width="7"/><text class="name" x="{x}" y="{y - length - 12}" '
        f'text-anchor="middle">{name}</text><circle cx="{x}" cy="{y}" r="9" fill="#243040"/>'
    )


def _escaped(text: str) -> str:
    """Return foreign text as character data; a control character would break the document."""
    return escape(visible(text))
