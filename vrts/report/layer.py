"""The pixels of a picture that show solids: their light, before what moves throws shadows on them.

A pixel has several samples a side. Where all show one smooth face one of them, in the middle, is
shaded for all: only edges cost more than a pixel.
"""

from typing import NamedTuple, TypeVar

import numpy as np
import numpy.typing as npt

from vrts.report.camera import Camera
from vrts.report.lighting import SUN_FRAME, ShadowMap, shade
from vrts.report.outlines import Mask, outlines
from vrts.report.projection import NO_SOLID, Projected, focal_length
from vrts.report.raster import Array, Array32, Indices, Numbers, numbers

Number = TypeVar("Number", bound=np.generic)

OFFSET_M = 0.006  # before its surface a place is looked up in a shadow map
AT_ONCE = 8192  # samples shaded: what is worked on stays near the processor


class Layer(NamedTuple):
    """Light by pixel, linear; means over its samples."""

    ambient: Array32  # (height, width, 3) what does not come from the sun
    direct: Array32  # (height, width, 3) what does, past what never moves
    share: Array32  # (height, width) how much of the pixel shows solids
    along: Array32  # (height, width, 3) a place before it, in the frame of the sun [m]

    def copy(self) -> "Layer":
        """Return a layer to draw on."""
        return Layer(*(values.copy() for values in self))


class Screen(NamedTuple):
    """Where a layer is drawn."""

    camera: Camera
    width: int  # pixels
    height: int  # pixels
    samples: int  # a side of a pixel


def empty_layer(screen: Screen) -> Layer:
    """Return a layer without solids."""
    shape = (screen.height, screen.width)
    light, direct, along = (np.zeros((*shape, 3), np.float32) for _ in range(3))
    return Layer(light, direct, np.zeros(shape, np.float32), along)


def draw(
    layer: Layer,
    screen: Screen,
    buffer: Indices,
    seen: Projected,
    colors: Array32,
    shadows: ShadowMap,
    wanted: Mask,
) -> None:
    """Draw the wanted pixels into a layer.

    Args:
        layer: What is drawn on.
        screen: Its screen.
        buffer: Of all samples, shape (height * samples, width * samples).
        seen: The triangles in it.
        colors: Of every solid, linear RGB.
        shadows: Of what never moves.
        wanted: Shape (height, width).
    """
    rows, columns = np.nonzero(wanted.any(1))[0], np.nonzero(wanted.any(0))[0]
    if not len(rows):
        return
    n = screen.samples
    # a pixel more on each side: the line of a solid can come from its neighbour
    top, left = max(int(rows[0]) - 1, 0), max(int(columns[0]) - 1, 0)
    bottom, right = int(rows[-1]) + 2, int(columns[-1]) + 2
    part = buffer[top * n : bottom * n, left * n : right * n]
    number = numbers(part)
    solid = seen.solid[number]
    keep = outlines(part, number, solid, seen, (left * n, top * n))
    row, column = np.nonzero(wanted[top:bottom, left:right])
    owners, kept = _by_sample(solid, n, row, column), _by_sample(keep, n, row, column)
    chosen = _chosen(owners, kept, n)
    place = np.stack([(column + left)[chosen.pixel], (row + top)[chosen.pixel]], axis=1)
    place = (place * n + chosen.within).astype(np.float32)
    triangle = _by_sample(number, n, row, column)[chosen.sample, chosen.pixel]
    lit = [
        _shaded(screen, seen, colors, shadows, triangle[k : k + AT_ONCE], place[k : k + AT_ONCE])
        for k in range(0, len(triangle), AT_ONCE)
    ]
    ambient, direct, along = (np.concatenate(values) for values in zip(*lit, strict=True))
    at = row + top, column + left
    layer.ambient[at] = _means(ambient, chosen, len(row))
    layer.direct[at] = _means(direct, chosen, len(row))
    layer.share[at] = (owners != NO_SOLID).mean(0, dtype=np.float32)
    layer.along[at[0][chosen.pixel], at[1][chosen.pixel]] = along


class _Chosen(NamedTuple):
    """The samples that are shaded: first one for each whole pixel, then those of the others."""

    pixel: Indices  # (k,) which one they belong to
    sample: Indices  # (k,) whose triangle they show
    within: Array  # (k, 2) column and row in the pixel, in samples
    whole: int  # how many stand for a whole pixel
    weight: Array32  # (k - whole,) of the others


def _chosen(owners: Numbers, kept: Array32, n: int) -> _Chosen:
    """Choose samples of pixels from their solids and outlines, shape (n * n, pixels)."""
    shown = owners != NO_SOLID
    whole = (owners == owners[0]).all(0) & shown[0] & (kept == 1).all(0)
    pixel = np.nonzero(whole)[0]
    sample, edge = np.nonzero(shown & ~whole)
    middle = np.full((len(pixel), 2), n / 2)
    return _Chosen(
        np.concatenate([pixel, edge]),
        np.concatenate([np.zeros(len(pixel), np.int64), sample]),
        np.concatenate([middle, np.stack([sample % n, sample // n], axis=1) + 0.5]),
        len(pixel),
        kept[sample, edge] * np.float32(1 / n**2),
    )


def _means(values: Array32, chosen: _Chosen, count: int) -> Array32:
    """Return the light of pixels, shape (count, 3), from that of their samples."""
    edge = chosen.pixel[chosen.whole :]
    total = np.empty((count, 3), np.float32)
    for k in range(3):
        total[:, k] = np.bincount(edge, values[chosen.whole :, k] * chosen.weight, count)
    total[chosen.pixel[: chosen.whole]] = values[: chosen.whole]
    return total


def _by_sample(
    values: npt.NDArray[Number], n: int, row: Indices, column: Indices
) -> npt.NDArray[Number]:
    """Return the samples of pixels, shape (n * n, len(row))."""
    return np.stack([values[i::n, j::n][row, column] for i in range(n) for j in range(n)])


def _shaded(
    screen: Screen,
    seen: Projected,
    colors: Array32,
    shadows: ShadowMap,
    triangle: Numbers,
    place: Array32,
) -> tuple[Array32, Array32, Array32]:
    """Return ambient and direct light and the place in the sun's frame.

    Places on the screen are column and row in samples, shape (n, 2).
    """
    width, height = screen.width * screen.samples, screen.height * screen.samples
    focal = np.float32(focal_length(screen.camera, height))
    frame = screen.camera.axes().astype(np.float32)
    x, y = place[:, 0], place[:, 1]
    planes = seen.planes[triangle]
    values = planes[:, 0] * x[:, None]
    values += planes[:, 1] * y[:, None]
    values += planes[:, 2]
    facing, near = values[:, :3], values[:, 3:]
    facing /= np.sqrt(np.einsum("ij,ij->i", facing, facing))[:, None]
    ray = np.empty((len(x), 3), np.float32)
    ray[:, 0] = (x - np.float32(width / 2)) / focal
    ray[:, 1] = (y - np.float32(height / 2)) / focal
    ray[:, 2] = 1
    ray = ray @ frame
    to_sun = SUN_FRAME.T.astype(np.float32)
    before = ray / near
    before += facing * np.float32(OFFSET_M)
    along = before @ to_sun + np.array(screen.camera.eye, np.float32) @ to_sun
    ray /= -np.sqrt(np.einsum("ij,ij->i", ray, ray))[:, None]
    sunlight = shadows.lit(along)
    ambient, direct = shade(colors[seen.solid[triangle]], facing, ray, sunlight)
    return ambient, direct, along
