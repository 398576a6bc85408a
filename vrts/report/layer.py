"""The pixels of a picture that show solids: their light, before what moves throws shadows on them.

A pixel has several samples a side. Where all show one smooth face one of them, in the middle, is
shaded for all: only edges cost more than a pixel.
"""

from typing import NamedTuple

import numpy as np

from vrts.report.camera import Camera
from vrts.report.lighting import SUN_FRAME, ShadowMap, shade
from vrts.report.outlines import Mask, outlines
from vrts.report.projection import NO_SOLID, Projected, focal_length
from vrts.report.raster import Array32, Indices, Numbers, numbers

OFFSET_M = 0.006  # before its surface a place is looked up in a shadow map
AT_ONCE = 8192  # samples shaded: what is worked on stays near the processor


class Layer(NamedTuple):
    """Light by pixel, linear; means over its samples."""

    ambient: Array32  # (height, width, 3) what does not come from the sun
    direct: Array32  # (height, width, 3) what does, past what never moves
    share: Array32  # (height, width) how much of the pixel shows solids
    along: Array32  # (3, height, width) a place before it, in the frame of the sun [m]

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
    light, direct = (np.zeros((*shape, 3), np.float32) for _ in range(2))
    return Layer(light, direct, np.zeros(shape, np.float32), np.zeros((3, *shape), np.float32))


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
    bottom = min(int(rows[-1]) + 2, screen.height)
    right = min(int(columns[-1]) + 2, screen.width)
    part = buffer[top * n : bottom * n, left * n : right * n]
    number = numbers(part)
    solid = seen.solid.take(number)
    keep = outlines(part, number, solid, seen, (left * n, top * n))
    chosen = _chosen(solid, keep, wanted[top:bottom, left:right], n)
    place = chosen.place + np.array([left * n, top * n], np.float32)
    triangle = number.take(chosen.shown)
    lit = [
        _shaded(screen, seen, colors, shadows, triangle[k : k + AT_ONCE], place[k : k + AT_ONCE])
        for k in range(0, len(triangle), AT_ONCE)
    ]
    ambient, direct, along = (np.concatenate(values) for values in zip(*lit, strict=True))
    whole, rest = (
        (pixel // (right - left) + top) * screen.width + pixel % (right - left) + left
        for pixel in (chosen.whole, chosen.rest)
    )
    for target, values in ((layer.ambient, ambient), (layer.direct, direct)):
        flat = target.reshape(-1, 3)
        flat[whole] = values[: len(whole)]
        flat[rest] = _means(values[len(whole) :], chosen)
    layer.share.reshape(-1)[whole] = 1
    layer.share.reshape(-1)[rest] = np.bincount(chosen.owner, minlength=len(rest)) / n**2
    at = np.concatenate([whole, rest[chosen.owner]])
    for target, values in zip(layer.along, along.T, strict=True):
        target.reshape(-1)[at] = values


class _Chosen(NamedTuple):
    """The samples that are shaded: one for each whole pixel, then those of the others."""

    whole: Indices  # (w,) pixels that show one smooth face
    rest: Indices  # (r,) other pixels
    owner: Indices  # (k,) in `rest`, of the samples of these
    shown: Indices  # (w + k,) samples whose triangles are shaded
    place: Array32  # (w + k, 2) column and row where, in samples
    weight: Array32  # (k,)


def _chosen(solid: Numbers, keep: Array32, wanted: Mask, n: int) -> _Chosen:
    """Choose samples of wanted pixels from the solids and outlines of all samples."""
    first = solid[::n, ::n]
    same = wanted & (first != NO_SOLID)
    plain = keep == 1
    for i in range(n):
        for j in range(n):
            same &= (solid[i::n, j::n] == first) & plain[i::n, j::n]
    whole, rest = np.flatnonzero(same), np.flatnonzero(wanted & ~same)
    width, columns = solid.shape[1], wanted.shape[1]
    begin = whole // columns * (n * width) + whole % columns * n
    corners = np.array([[i * width + j] for i in range(n) for j in range(n)])
    index = rest // columns * (n * width) + rest % columns * n + corners
    owners = solid.reshape(-1)[index]
    sample, owner = np.nonzero(owners != NO_SOLID)
    others = index[sample, owner]
    at = np.concatenate([begin, others])
    place = np.empty((len(at), 2), np.float32)
    place[:, 0], place[:, 1] = at % width, at // width
    place[: len(whole)] += n / 2
    place[len(whole) :] += 0.5
    return _Chosen(whole, rest, owner, at, place, keep.take(others) * np.float32(1 / n**2))


def _means(values: Array32, chosen: _Chosen) -> Array32:
    """Return the light of the pixels that are not whole, from that of their samples."""
    count = len(chosen.rest)
    sums = [np.bincount(chosen.owner, values[:, k] * chosen.weight, count) for k in range(3)]
    return np.stack(sums, axis=1).astype(np.float32)


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
    planes = seen.planes.take(triangle, axis=0)
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
    sunlight = shadows.lit(along.T)
    ambient, direct = shade(colors.take(seen.solid.take(triangle), axis=0), facing, ray, sunlight)
    return ambient, direct, along
