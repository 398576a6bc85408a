"""What HERE must show at three places of the run: the operator's check of TOOL, BASE and zeros."""

from typing import NamedTuple

from vrts.base.oat import components, plain_angles
from vrts.base.pose import Pose
from vrts.engine.run import Run
from vrts.lang.dialect import Angles, Dialect
from vrts.robots.model import Configuration

PLACES = 3
NOT_TRIED = "not tried on a controller"


class Check(NamedTuple):
    """A place where the arm stops in the run."""

    motion: int  # from 1
    words: str  # of the step that leads there
    program: str
    here: Pose  # as HERE counts, under BASE
    goal: Configuration


def checks(run: Run) -> tuple[Check, ...]:
    """Return the first place where the arm stops, the last, and one between them."""
    stops = [k for k, motion in enumerate(run.motions) if motion.arrives and not motion.blended]
    if len(stops) > PLACES:
        stops = [stops[0], stops[len(stops) // 2], stops[-1]]
    return tuple(_check(run, k) for k in stops)


def _check(run: Run, number: int) -> Check:
    motion = run.motions[number]
    span = motion.cause.span
    here = run.at(motion.start_s).base @ motion.X_WT
    return Check(number + 1, span.text, motion.cause.program, here, motion.goal)


def here_text(check: Check, dialect: Dialect) -> str:
    """Return what HERE shows: X, Y, Z in mm and the angles of a language in degrees."""
    x, y, z, *angles = components(check.here)
    if dialect.angles is Angles.ZYZ:
        angles = list(plain_angles(*angles))
    return " ".join(f"{round(value, 2) + 0.0:.2f}" for value in (x, y, z, *angles))


def with_checks(text: str, entry: str, found: tuple[Check, ...], dialect: Dialect) -> str:
    """Return a text with the checks as comments at the top of the program that is executed."""
    rows = [f"; {NOT_TRIED}; the arm stops where HERE shows (mm, degrees):"]
    rows += [
        f";   motion {c.motion}, {c.words} in {c.program}: {here_text(c, dialect)}" for c in found
    ]
    lines = text.split("\n")
    at = next(k for k, line in enumerate(lines) if _begins(line, entry))
    return "\n".join((*lines[: at + 1], *rows, *lines[at + 1 :]))


def _begins(line: str, entry: str) -> bool:
    return line.lower().startswith(".program") and line.split("(")[0].split()[1].lower() == entry
