"""A mesh split into nearly convex parts, by CoACD in a process of its own."""

import json
import subprocess
import sys
from importlib.util import find_spec
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.scene.meshes.triangles import MeshFault, Triangles

Array: TypeAlias = npt.NDArray[np.float64]

DOOR = "vrts.pipeline.pieces.coacd_door"
NEEDED = ("coacd", "scipy")
LONGEST_S = 600.0  # that the library may take


class NoLibrary(Exception):  # noqa: N818 -- names what it is
    """A package that splitting needs is not installed."""


class Split(NamedTuple):
    """The parts of a mesh."""

    library: str  # with its version
    parts: tuple[Array, ...]  # corners of each, shape (n, 3), in mm


def check_installed() -> None:
    """Raise NoLibrary unless the packages of `vrts[mesh]` are there."""
    missing = [name for name in NEEDED if find_spec(name) is None]
    if missing:
        raise NoLibrary(" and ".join(missing))


def split(mesh: Triangles, closeness: float, most: int) -> Split:
    """Return a mesh in nearly convex parts.

    Args:
        mesh: In mm.
        closeness: The concavity that a part may have, as CoACD measures it.
        most: Parts at most.

    Raises:
        MeshFault: The library took too long, or failed.
    """
    asked = {
        "vertices": mesh.vertices.tolist(),
        "faces": mesh.faces.tolist(),
        "closeness": closeness,
        "most": most,
    }
    remedy = "repair the mesh, save it with fewer triangles, or allow more with `--closeness`"
    try:
        done = subprocess.run(  # noqa: S603 -- our own module
            [sys.executable, "-m", DOOR],
            input=json.dumps(asked).encode(),
            capture_output=True,
            timeout=LONGEST_S,
            check=False,
        )
    except subprocess.TimeoutExpired as late:
        raise MeshFault(
            f"splitting the mesh took longer than {LONGEST_S:.0f} s and was ended", remedy
        ) from late
    if done.returncode != 0 or not done.stdout:
        lines = done.stderr.decode("utf-8", "replace").strip().splitlines() or ["no word of why"]
        raise MeshFault(f"CoACD could not split the mesh: {lines[-1][:200]}", remedy)
    told = json.loads(done.stdout)
    parts = tuple(np.array(points, dtype=np.float64).reshape(-1, 3) for points in told["parts"])
    return Split(f"coacd {told['version']}", parts)
