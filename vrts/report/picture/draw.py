"""The pixels of a picture: what they show, with the light of sun and sky on it.

A pixel has several samples a side. Where all show one smooth face one of them, in the middle, is
shaded for all, elsewhere one for those that show one triangle. Values stand in rows, a column for
every sample.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from vrts.report.picture.camera import Camera
from vrts.report.picture.ground import ground
from vrts.report.picture.lighting import SUN_FRAME, ShadowMap, shade, sunlight
from vrts.report.picture.outlines import outlines
from vrts.report.picture.projection import NO_SOLID, Projected, focal_length
from vrts.report.picture.raster import Array32, Indices, Mask, Numbers, numbers

OFFSET_M = 0.006  # before its surface a place is looked up in a shadow map
AT_ONCE = 8192  # samples shaded: what is worked on stays near the processor
BAND = 72  # rows of pixels


class Screen(NamedTuple):
    """Where a picture is drawn."""

    camera: Camera
    width: int  # pixels
    height: int  # pixels
    samples: int  # a side of a pixel


class Shown(NamedTuple):
    """What a screen shows."""

    seen: Projected  # the triangles on it
    colors: Array32  # (3, solids) of every solid, linear RGB
    floor_m: float  # z of the floor in W
    shadows: tuple[ShadowMap, ...]  # of everything that throws one


class Places(NamedTuple):
    """Where the light of pixels comes from, in the frame of the sun [m]; nan: from nowhere."""

    solid: Array32  # (3, height, width) a little before what is seen
    floor: Array32  # (2, height, width)


class Band(NamedTuple):
    """Rows of pixels that are drawn together: what is worked on stays near the processor."""

    rows: slice  # with a row more on each side, whose solids can draw lines here
    own: slice  # the rows of the band itself
    inner: slice  # the same, counted from the first of `rows`

    def whole(self, width: int) -> Mask:
        """Return the pixels of the band itself among those of `rows`."""
        wanted = np.zeros((self.rows.stop - self.rows.start, width), np.bool_)
        wanted[self.inner] = True
        return wanted


def bands(height: int) -> Iterator[Band]:
    """Yield the bands of a picture, from top to bottom."""
    for top in range(0, height, BAND):
        bottom = min(top + BAND, height)
        first = max(top - 1, 0)
        rows = slice(first, min(bottom + 1, height))
        yield Band(rows, slice(top, bottom), slice(top - first, bottom - first))


def draw(
    picture: Array32,
    screen: Screen,
    shown: Shown,
    buffer: Indices,
    wanted: Mask,
    row: int,
    places: Places | None = None,
) -> None:
    """Draw pixels into some rows of a picture.

    Args:
        picture: Linear light, shape (3, rows, width).
        screen: Where it is drawn.
        shown: What it shows.
        buffer: The triangles that are seen, shape (rows * samples, width * samples).
        wanted: Shape (rows, width): which pixels are drawn.
        row: The first of the rows.
        places: Where to note from where their light comes, of the same rows.
    """
    rows, columns = np.nonzero(wanted.any(1))[0], np.nonzero(wanted.any(0))[0]
    if not len(rows):
        return
    n = screen.samples
    # a pixel more on each side: the line of a solid can come from its neighbour
    top, left = max(int(rows[0]) - 1, 0), max(int(columns[0]) - 1, 0)
    bottom, right = min(int(rows[-1]) + 2, len(wanted)), min(int(columns[-1]) + 2, screen.width)
    part = buffer[top * n : bottom * n, left * n : right * n]
    number = numbers(part)
    solid = shown.seen.solid.take(number)
    pixels = wanted[top:bottom, left:right]
    fine = None if pixels.all() else pixels.repeat(n, axis=0).repeat(n, axis=1)
    keep = outlines(part, number, solid, shown.seen, (left * n, (row + top) * n), fine)
    chosen = _chosen(number, solid, keep, pixels)
    whole, rest = (
        (pixel // (right - left) + top) * screen.width + pixel % (right - left) + left
        for pixel in (chosen.whole, chosen.rest)
    )
    at = np.concatenate([whole, rest[chosen.owner]])
    triangle = number.take(chosen.shown)
    place = chosen.place + np.array([[left * n], [(row + top) * n]], np.float32)
    light = np.empty((3, len(at)), np.float32)
    for k in range(0, len(at), AT_ONCE):
        now = slice(k, k + AT_ONCE)
        light[:, now], before = _shaded(screen, shown, triangle[now], place[:, now])
        if places is not None:
            places.solid.reshape(3, -1)[:, at[now]] = before
    open_to = np.flatnonzero(chosen.share < 1)
    floor = ground(
        screen.camera,
        (screen.width, screen.height),
        shown.floor_m,
        rest[open_to] + row * screen.width,
        shown.shadows,
    )
    if places is not None:
        places.floor.reshape(2, -1)[:, rest[open_to]] = floor.along
    free = 1 - chosen.share[open_to]
    for k, flat in enumerate(picture.reshape(3, -1)):
        flat[whole] = light[k, : len(whole)]
        weighted = light[k, len(whole) :] * chosen.weight
        mixed = np.bincount(chosen.owner, weighted, len(rest)).astype(np.float32)
        mixed[open_to] += floor.light[k] * free
        flat[rest] = mixed


class _Chosen(NamedTuple):
    """The samples that are shaded: one for each whole pixel, then those of the others.

    Of the samples of a pixel that show one triangle, one is shaded for all.
    """

    whole: Indices  # (w,) pixels that show one smooth face
    rest: Indices  # (r,) other pixels
    owner: Indices  # (k,) in `rest`, of the samples of these
    shown: Indices  # (w + k,) samples whose triangles are shaded
    place: Array32  # (2, w + k) column and row where, in samples
    weight: Array32  # (k,)
    share: Array32  # (r,) of the other pixels, that solids cover


def _chosen(number: Numbers, solid: Numbers, keep: Array32, wanted: Mask) -> _Chosen:
    """Choose samples of wanted pixels from triangles, solids and outlines of all samples."""
    n = len(solid) // len(wanted)
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
    there = solid.reshape(-1)[index] != NO_SOLID
    share: Array32 = there.mean(axis=0, dtype=np.float32)
    triangle = number.reshape(-1)[index]
    weight = keep.reshape(-1)[index] * np.float32(1 / n**2)
    for later in range(1, n**2):
        for sooner in range(later):
            alike = there[sooner] & there[later] & (triangle[sooner] == triangle[later])
            weight[sooner] += weight[later] * alike
            there[later] &= ~alike
    sample, owner = np.nonzero(there)
    others = index[sample, owner]
    at = np.concatenate([begin, others])
    place = np.empty((2, len(at)), np.float32)
    place[0], place[1] = at % width, at // width
    place[:, : len(whole)] += n / 2
    place[:, len(whole) :] += 0.5
    return _Chosen(whole, rest, owner, at, place, weight[there], share)


def _shaded(
    screen: Screen, shown: Shown, triangle: Numbers, place: Array32
) -> tuple[Array32, Array32]:
    """Return light and place in the sun's frame of samples, each of shape (3, n).

    Places on the screen are column and row in samples, shape (2, n).
    """
    width, height = screen.width * screen.samples, screen.height * screen.samples
    focal = focal_length(screen.camera, height)
    to_sun = SUN_FRAME @ screen.camera.axes().T  # of right, down, forward of the camera
    slants = (to_sun[:, :2] / focal).astype(np.float32)
    middle = to_sun @ (-width / 2 / focal, -height / 2 / focal, 1.0)
    eye = SUN_FRAME @ screen.camera.eye
    planes = shown.seen.planes.take(triangle, axis=2)
    facing = planes[:, 0]
    facing *= place[0]
    facing += planes[:, 1] * place[1]
    facing += planes[:, 2]
    near, normal = facing[3], facing[:3]
    normal *= 1 / np.sqrt(np.einsum("ij,ij->j", normal, normal))
    ray = slants @ place
    ray += middle.astype(np.float32)[:, None]
    before = ray / near
    before += normal * np.float32(OFFSET_M)
    before += eye.astype(np.float32)[:, None]
    ray *= -1 / np.sqrt(np.einsum("ij,ij->j", ray, ray))
    color = shown.colors.take(shown.seen.solid.take(triangle), axis=1)
    return shade(color, normal, ray, sunlight(shown.shadows, before)), before
