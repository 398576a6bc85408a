"""Splits a mesh with CoACD, in a process of its own: `python -m vrts.pipeline.pieces.coacd_door`.

In: JSON of vertices, faces, closeness and most pieces on standard input. Out: JSON of the version
and the corners of the parts on standard output; what the library prints goes to standard error.
"""

import json
import os
import sys
from importlib import import_module
from importlib.metadata import version
from typing import Any

import numpy as np

MOST_CORNERS = 256  # of a part; it is simplified afterwards


def main() -> None:
    """Read a mesh, write its parts."""
    answer = os.dup(1)
    os.dup2(2, 1)
    asked = json.load(sys.stdin)
    coacd: Any = import_module("coacd")  # it brings no types
    coacd.set_log_level("error")
    mesh = coacd.Mesh(np.array(asked["vertices"]), np.array(asked["faces"]))
    parts = coacd.run_coacd(
        mesh,
        threshold=asked["closeness"],
        max_convex_hull=asked["most"],
        max_ch_vertex=MOST_CORNERS,
        seed=0,
    )
    told = {"version": version("coacd"), "parts": [points.tolist() for points, _ in parts]}
    with os.fdopen(answer, "w", encoding="utf-8") as out:
        json.dump(told, out)


if __name__ == "__main__":
    main()
