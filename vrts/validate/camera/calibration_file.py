"""Reads what was marked in calibration pictures: points in W, and where they were seen."""

from typing import NamedTuple

import numpy as np

from vrts.base.diagnostic import Rule
from vrts.base.source import SourceFile, Span
from vrts.base.toml.reading import Problems, Table, read_toml
from vrts.base.units import DEG, MM
from vrts.pipeline.refused import Refused
from vrts.validate.camera.model import Array, View

UNKNOWN_POINT = Rule("V900", "unknown-point")
TOO_FEW_POINTS = Rule("V901", "too-few-points")

LEAST_POINTS = 6  # that are seen, in all pictures together [Tsai's problem without a plane]
SIZES = (16, 16384)  # pixels a side
ZOOMS = (0.01, 1000.0)


class Picture(NamedTuple):
    """One picture with marks."""

    view: View
    names: tuple[str, ...]  # of the points seen
    pixels: Array  # (n, 2)
    span: Span


class Marked(NamedTuple):
    """Everything that was marked."""

    size_px: tuple[int, int]
    focal_px: float | None  # a guess of it at zoom 1, if there is one
    fit_centre: bool  # whether the optical axis may lie elsewhere than in the middle
    fit_distortion: bool
    points: dict[str, Array]  # in W [m]
    pictures: tuple[Picture, ...]


def read_marked(source: SourceFile) -> Marked:
    """Return what a calibration file holds.

    Raises:
        Refused: The file has errors.
    """
    top, problems = read_toml(source)
    if top is None:
        raise Refused(problems.in_order())
    camera = top.table("camera", required=True)
    named = top.table("points_mm", required=True)
    pictures = top.tables("pictures", required=True)
    top.finish()
    size, focal, centre, lens = (0, 0), None, False, True
    if camera is not None:
        low, high = SIZES
        width, height = camera.numbers(
            "size_px", count=2, minimum=low, maximum=high, required=True
        ) or (0, 0)
        size = (int(width), int(height))
        focal = camera.number("focal_px", above=0.0)
        centre = camera.boolean("fit_centre", False)
        lens = camera.boolean("fit_distortion", True)
        camera.finish()
    points: dict[str, Array] = {}
    if named is not None:
        for name in named.keys:
            place = named.numbers(name, count=3, required=True)
            if place is not None:
                points[name] = np.array(place) * MM
        named.finish()
    found = [_picture(table, points, problems, known=named is not None) for table in pictures]
    marks = sum(len(picture.names) for picture in found)
    if not problems.any_error and marks < LEAST_POINTS:
        problems.error(
            TOO_FEW_POINTS,
            f"{marks} marks do not tell where a camera stands",
            top.span_of("pictures"),
            notes=(f"at least {LEAST_POINTS} are wanted, not all in one plane",),
            help=("mark more points, also above the table, in one picture or in several",),
        )
    if problems.any_error:
        raise Refused(problems.in_order())
    return Marked(size, focal, centre, lens, points, tuple(found))


def _picture(table: Table, points: dict[str, Array], problems: Problems, *, known: bool) -> Picture:
    pan = table.number("pan_deg", 0.0, minimum=-360.0, maximum=360.0)
    tilt = table.number("tilt_deg", 0.0, minimum=-180.0, maximum=180.0)
    zoom = table.number("zoom", 1.0, minimum=ZOOMS[0], maximum=ZOOMS[1])
    seen = table.table("seen_px", required=True)
    table.finish()
    names: list[str] = []
    pixels: list[tuple[float, ...]] = []
    if seen is not None:
        for name in seen.keys:
            place = seen.numbers(name, count=2, required=True)
            if name not in points and known:
                problems.error(
                    UNKNOWN_POINT,
                    f"there is no point `{name}`",
                    seen.span_of(name),
                    help=(f"add it to `[points_mm]`: {', '.join(list(points)[:8]) or 'none'}",),
                )
            elif place is not None and known:
                names.append(name)
                pixels.append(place)
        seen.finish()
    view = View(pan * DEG, tilt * DEG, zoom)
    return Picture(view, tuple(names), np.array(pixels).reshape(-1, 2), table.span)
