"""Marks that were mistaken: which those are, and with which other they were exchanged."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.base.diagnostic import Diagnostic, Label, Rule, warning
from vrts.validate.camera.calibration_file import LEAST_POINTS, Marked
from vrts.validate.camera.model import Array, PtzCamera

WRONG_MARK = Rule("V908", "wrong-mark")

LEAST_PX = 3.0  # a mark that is nearer is never called wrong
FAR = 6.0  # times what is usual for the marks of this camera
USUAL = 1.4826  # standard deviations in the median of distances from it [Gauss]
MOST_WRONG = 1 / 3  # of all marks: with more nobody can tell which are wrong

Mask = npt.NDArray[np.bool_]


class LeftOut(NamedTuple):
    """A mark that does not count."""

    picture: int  # 0 is the first
    name: str
    miss_px: float  # from where the camera sees the point
    exchanged_with: str | None  # the point of the same picture that was marked in its place


def agreeing(misses: Array, kept: Mask | None = None) -> Mask:
    """Return which marks are as near to where they belong as the others.

    Args:
        misses: Of every mark, shape (n,) [pixels].
        kept: Marks that the camera was fitted to; None: all. What is usual is taken from them.
    """
    usual = USUAL * float(np.median(misses if kept is None else misses[kept]))
    return np.asarray(misses <= max(LEAST_PX, FAR * usual))


def enough(kept: Mask) -> bool:
    """Return whether those that are kept can say that the others are wrong."""
    wrong = int((~kept).sum())
    return len(kept) - wrong >= LEAST_POINTS and wrong <= MOST_WRONG * len(kept)


def left_out(camera: PtzCamera, marked: Marked, kept: Sequence[Mask]) -> tuple[LeftOut, ...]:
    """Return the marks that are not kept, and which of them were exchanged."""
    found: list[LeftOut] = []
    for number, (picture, own) in enumerate(zip(marked.pictures, kept, strict=True)):
        names = [name for name, keeps in zip(picture.names, own.tolist(), strict=True) if not keeps]
        if not names:
            continue
        pixels = picture.pixels[~own]
        seen = camera.seen(np.array([marked.points[name] for name in names]), picture.view)
        apart = np.linalg.norm(pixels[:, None] - seen[None], axis=2)  # of mark i from point j
        for i, name in enumerate(names):
            j = int(np.nanargmin(np.where(np.isnan(apart[i]), np.inf, apart[i])))
            there = j != i and apart[i, j] < 0.5 * apart[i, i] and apart[i, j] <= 4.0 * LEAST_PX
            found.append(LeftOut(number, name, float(apart[i, i]), names[j] if there else None))
    return tuple(found)


def told(marked: Marked, wrong: Sequence[LeftOut]) -> list[Diagnostic]:
    """Return a warning for each mark that was left out; for two that were exchanged, one."""
    found: list[Diagnostic] = []
    said: set[tuple[int, str]] = set()
    for one in wrong:
        if (one.picture, one.name) in said:
            continue
        other = one.exchanged_with
        both = other is not None and any(
            (each.picture, each.name, each.exchanged_with) == (one.picture, other, one.name)
            for each in wrong
        )
        where = f"in picture {one.picture + 1}"
        if both:
            said.add((one.picture, str(other)))
            headline = f"the marks of `{one.name}` and `{other}` {where} are exchanged"
            remedy = "exchange the two in `seen_px`"
        elif other is not None:
            headline = f"`{one.name}` {where} was marked where `{other}` is"
            remedy = "mark it again in the picture, or take it out"
        else:
            headline = (
                f"the mark of `{one.name}` {where} is {one.miss_px:.0f} px from where the camera "
                "sees the point"
            )
            remedy = "mark it again in the picture, or measure the point again"
        span = marked.pictures[one.picture].span
        notes = ("it is left out: all that is told of the camera is without it",)
        found.append(warning(WRONG_MARK, headline, Label(span), notes=notes, help=(remedy,)))
    return found
