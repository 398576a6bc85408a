"""Exact distance between two convex pieces, by the engine there is.

Coal is a hundred times more exact and is taken where it can be imported; where it has no wheel,
python-fcl answers.
"""

from functools import cache
from importlib.util import find_spec

from vrts.base.pose import Pose
from vrts.geometry.nearest import Array, Engine, Nearest, Pair, Transform
from vrts.geometry.shapes import Piece, Shape

COAL, FCL = "coal", "fcl"
ENGINES = (COAL, FCL)


@cache
def engine(name: str | None = None) -> Engine:
    """Return an engine by its name; None: coal where there is one, else python-fcl.

    Raises:
        ImportError: The engine asked for is not installed.
    """
    if name is None:
        name = COAL if find_spec("coal") is not None else FCL
    if name == COAL:
        from vrts.geometry import coal_engine  # optional: there is no wheel for Windows

        return coal_engine.ENGINE
    from vrts.geometry import fcl_engine  # only where there is no coal, or it is asked for

    return fcl_engine.ENGINE


def pair(first: Shape, second: Shape) -> Pair:
    """Return the `Pair` of two shapes; equal shapes share one."""
    return engine().pair(first, second)


def transform(rotation: Array, translation: Array) -> Transform:
    """Return a placement from arrays of shape (3, 3) and (3,)."""
    return engine().transform(rotation, translation)


def nearest(first: Piece, X_WA: Pose, second: Piece, X_WB: Pose) -> Nearest:
    """Return the signed distance of two pieces of bodies A and B, and its points in W."""
    asked = engine()
    return asked.pair(first.shape, second.shape).nearest(
        asked.placed(X_WA @ first.X_OP), asked.placed(X_WB @ second.X_OP)
    )


def distance(first: Piece, X_WA: Pose, second: Piece, X_WB: Pose) -> float:
    """Return the signed distance [m] of two pieces of bodies A and B."""
    asked = engine()
    return asked.pair(first.shape, second.shape).distance(
        asked.placed(X_WA @ first.X_OP), asked.placed(X_WB @ second.X_OP)
    )
