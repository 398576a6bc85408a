"""Draw the stills of the first example anew: `python -m tests.golden.pictures`.

The moments are found in the runs of `solution.v2` and `submissions/hits-base.v2`, so the pictures
stay true when times change.
"""

from collections.abc import Callable, Collection
from pathlib import Path

from tests.golden.example_01 import EXAMPLE
from vrts.base.pose import Vector
from vrts.engine.events import Event, Grasped, Released
from vrts.engine.run import Run
from vrts.pipeline import assess
from vrts.report.assessment import Assessment
from vrts.report.camera import Camera
from vrts.report.still import still

PICTURES = EXAMPLE / "pictures"
SIZE = (1200, 760)
ROOM = Camera(eye=(3.35, -2.75, 1.2), look_at=(0.5, -0.02, 0.1))
TABLE = Camera(eye=(2.6, -1.75, 0.75), look_at=(0.88, -0.16, -0.13))
BEFORE_S = 0.05  # an instant before the fingers open


def main() -> None:
    """Draw every picture."""
    solution = _assessed(EXAMPLE / "solution.v2")
    fetched = _time(solution, lambda e: isinstance(e, Grasped) and e.body == "can1")
    let_go = _time(solution, lambda e: isinstance(e, Released) and e.body == "can1")
    placed = _time(solution, lambda e: isinstance(e, Released) and e.body == "can2")
    _draw("put.png", solution, placed - BEFORE_S, ROOM)
    _draw("grip.png", solution, fetched + BEFORE_S, TABLE)
    _draw("carry.png", solution, (fetched + let_go) / 2, TABLE)
    touching = _assessed(EXAMPLE / "submissions" / "hits-base.v2")
    assert touching.judgement is not None
    collisions = touching.judgement.collisions
    assert collisions is not None
    contact = collisions.contacts[0]
    _draw(
        "touch.png",
        touching,
        contact.deepest_s,
        TABLE,
        highlight=contact.parts,
        marker=contact.point,
    )


def _assessed(path: Path) -> Assessment:
    return assess(path, task=EXAMPLE / "task.toml")


def _run(a: Assessment) -> Run:
    assert a.run is not None
    return a.run


def _time(a: Assessment, wanted: Callable[[Event], bool]) -> float:
    return next(event.time_s for event in _run(a).events if wanted(event))


def _draw(
    name: str,
    a: Assessment,
    time_s: float,
    camera: Camera,
    *,
    highlight: Collection[str] = (),
    marker: Vector | None = None,
) -> None:
    assert a.scene is not None
    state = _run(a).at(time_s)
    picture = still(
        a.scene,
        state.configuration,
        hand_opening=state.hand_opening,
        poses=state.poses,
        camera=camera,
        size=SIZE,
        highlight=highlight,
        marker=marker,
    )
    (PICTURES / name).write_bytes(picture)
    print(f"{name}  {a.title} at {time_s:.3f} s  {len(picture) / 1000:.0f} kB")


if __name__ == "__main__":
    main()
