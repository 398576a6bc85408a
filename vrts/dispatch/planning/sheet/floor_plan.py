"""The workspace from above, drawn to scale: where everything stands, and where the hand goes."""

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple, TypeAlias

from vrts.base.pose import Pose
from vrts.base.units import mm
from vrts.engine.run import Run
from vrts.geometry.shapes import Box, Cylinder, Piece
from vrts.report.page.html import Markup, element, joined
from vrts.scene.model import Body, Mobility, Scene

WIDTH, HEIGHT = 340.0, 236.0  # of the drawing
EDGE = 18.0  # free round it
RING = 24  # corners of a round outline
LINE = 7.5  # height of a line of text
MOST_POINTS = 400  # of the way of the hand
GRIDS_MM = (100.0, 200.0, 500.0, 1000.0)

Point: TypeAlias = tuple[float, float]


class _Paper(NamedTuple):
    """From mm in front of the robot to the drawing: X goes up, Y goes left, as in front of it."""

    scale: float
    left: float  # Y at x = 0 of the drawing
    top: float  # X at y = 0 of the drawing

    def at(self, x: float, y: float) -> Point:
        """Return where a place is drawn, rounded so that the same drawing has the same bytes."""
        return (
            round((self.left - y) * self.scale, 1) + 0.0,
            round((self.top - x) * self.scale, 1) + 0.0,
        )


def floor_plan(scene: Scene, run: Run) -> Markup:
    """Return the drawing as an SVG element; lengths in mm."""
    bodies = [(body, outline(body)) for body in scene.bodies if body.kind != "floor"]
    bodies.sort(key=lambda drawn: -_extent(drawn[1]))  # what is small lies on top
    way = list(_way(run))
    paper = _paper([point for _, corners in bodies for point in corners] + [*way, (0.0, 0.0)])
    shapes = [_body(paper, body, corners) for body, corners in bodies]
    labels = _labels(paper, bodies)
    points = " ".join(f"{x},{y}" for x, y in (paper.at(*point) for point in way))
    return element(
        "svg",
        *_grid(paper),
        *shapes,
        element("polyline", points=points, class_="way"),
        _robot(paper),
        *labels,
        viewBox=f"0 0 {WIDTH:g} {HEIGHT:g}",
        class_="plan",
        role="img",
        aria_label="the workspace from above",
    )


def outline(body: Body) -> tuple[Point, ...]:
    """Return the corners of a body seen from above [mm], in order."""
    found = [point for piece in body.pieces for point in _corners(piece, body.X_WO)]
    return tuple(_hull(sorted(set(found))))


def _corners(piece: Piece, X_WO: Pose) -> Iterator[Point]:
    X_WP = X_WO @ piece.X_OP
    shape = piece.shape
    if isinstance(shape, Box):
        a, b, c = shape.half_extents
        points = [(x, y, z) for x in (-a, a) for y in (-b, b) for z in (-c, c)]
    elif isinstance(shape, Cylinder):
        turns = (math.tau * k / RING for k in range(RING))
        ring = [(shape.radius * math.cos(t), shape.radius * math.sin(t)) for t in turns]
        points = [(x, y, z) for x, y in ring for z in (-shape.half_length, shape.half_length)]
    else:
        points = list(shape.points)
    for point in points:
        x, y, _ = X_WP.apply(point)
        yield round(mm(x), 2), round(mm(y), 2)


def _hull(points: Sequence[Point]) -> list[Point]:
    """Return the convex hull of points in order [Andrew's monotone chain]."""
    lower, upper = _half(points), _half(list(reversed(points)))
    return [*lower[:-1], *upper[:-1]] or list(points)


def _half(points: Sequence[Point]) -> list[Point]:
    found: list[Point] = []
    for x, y in points:
        while len(found) > 1:
            (ax, ay), (bx, by) = found[-2:]
            if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0.0:
                break
            found.pop()
        found.append((x, y))
    return found


def _way(run: Run) -> Iterator[Point]:
    X_FP = run.scene.robot.gripper.X_FP
    count = min(int(run.horizon_s / 0.05) + 2, MOST_POINTS)
    for k in range(count):
        time_s = min(run.horizon_s * k / (count - 1), run.horizon_s)
        x, y, _ = (run.at(time_s).X_WF @ X_FP).translation
        yield mm(x), mm(y)


def _paper(points: Sequence[Point]) -> _Paper:
    xs, ys = [x for x, _ in points], [y for _, y in points]
    tall, wide = max(max(xs) - min(xs), 1.0), max(max(ys) - min(ys), 1.0)
    scale = min((WIDTH - 2 * EDGE) / wide, (HEIGHT - 2 * EDGE) / tall)
    left = 0.5 * (max(ys) + min(ys)) + 0.5 * WIDTH / scale
    top = 0.5 * (max(xs) + min(xs)) + 0.5 * HEIGHT / scale
    return _Paper(scale, left, top)


def _grid(paper: _Paper) -> Iterator[Markup]:
    """Yield lines of whole distances from the robot's axes, with their numbers at the edge."""
    step = next((s for s in GRIDS_MM if s * paper.scale >= 24.0), GRIDS_MM[-1])
    for k in range(-40, 41):
        x, _ = paper.at(0.0, k * step)
        if 0.0 < x < WIDTH:
            yield element("path", d=f"M{x} 0V{HEIGHT:g}", class_="grid")
            yield element("text", f"Y {k * step:g}", x=x, y=HEIGHT - 3, class_="scale")
        _, y = paper.at(k * step, 0.0)
        if 0.0 < y < HEIGHT - 12:
            yield element("path", d=f"M0 {y}H{WIDTH:g}", class_="grid")
            yield element("text", f"X {k * step:g}", x=2, y=y - 2, class_="scale side")


def _body(paper: _Paper, body: Body, corners: Sequence[Point]) -> Markup:
    points = " ".join(f"{x},{y}" for x, y in (paper.at(*point) for point in corners))
    kind = "carried" if body.mobility is Mobility.MOVABLE else "fixed"
    return element("polygon", points=points, class_=kind)


def _labels(paper: _Paper, bodies: Sequence[tuple[Body, Sequence[Point]]]) -> list[Markup]:
    """Return the names of bodies: in or below them, on the corner of what others stand on."""
    supports = {body.rests_on for body, _ in bodies}
    taken: list[tuple[float, float, float]] = []  # left, right and height of what is written
    found: list[Markup] = []
    for body, corners in bodies:
        drawn = [paper.at(*point) for point in corners]
        left, right = min(x for x, _ in drawn), max(x for x, _ in drawn)
        top, bottom = min(y for _, y in drawn), max(y for _, y in drawn)
        if body.name in supports and right - left > WIDTH / 4:
            found.append(element("text", body.name, x=left + 3, y=top + 9, class_="name side"))
            continue
        half = 2.0 * len(body.name)
        middle, inside = round(0.5 * (left + right), 1), right - left > 2.2 * half
        y = 0.5 * (top + bottom) + 3.0 if inside else bottom + 8.0
        while any(
            middle - half < r and before < middle + half and abs(y - h) < LINE
            for before, r, h in taken
        ):
            y += LINE
        taken.append((middle - half, middle + half, y))
        found.append(element("text", body.name, x=middle, y=round(y, 1), class_="name"))
    return found


def _robot(paper: _Paper) -> Markup:
    x, y = paper.at(0.0, 0.0)
    ring = element("circle", cx=x, cy=y, r=7, class_="robot")
    cross = element("path", d=f"M{x - 3} {y}h6M{x} {y - 3}v6", class_="robot")
    name = element("text", "robot", x=x, y=y - 10, class_="name")
    return joined([ring, cross, name])


def _extent(corners: Sequence[Point]) -> float:
    xs, ys = [x for x, _ in corners], [y for _, y in corners]
    return (max(xs) - min(xs)) * (max(ys) - min(ys))
