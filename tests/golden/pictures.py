"""Draw the stills of the examples anew: `python -m tests.golden.pictures`.

The moments are found in the runs of the solutions and of one submission each, so the pictures stay
true when times change.
"""

from collections.abc import Callable, Collection
from pathlib import Path

from tests.golden.examples import ROOT
from vrts.base.pose import Vector
from vrts.check.verdict import ContactEvent
from vrts.check.verdicts.vias import visits_of
from vrts.engine.memory.events import Event, Grasped, Released
from vrts.engine.run import Run
from vrts.pipeline.assess import assess
from vrts.pipeline.requesting import request_for
from vrts.pipeline.where import Where
from vrts.report.assessment import Assessment
from vrts.report.picture.camera import Camera
from vrts.report.picture.still import still

CANS = ROOT / "examples" / "01-cans-on-bases"
DISH = ROOT / "examples" / "02-dish-on-stand"
OBSTACLES = ROOT / "examples" / "03-around-obstacles"
PROJECT = ROOT / "examples" / "04-final-project"
SIZE = (1200, 760)
ROOM = Camera(eye=(3.35, -2.75, 1.2), look_at=(0.5, -0.02, 0.1))
TABLE = Camera(eye=(2.6, -1.75, 0.75), look_at=(0.88, -0.16, -0.13))
ABOVE = Camera(eye=(2.75, -1.5, 1.75), look_at=(0.72, 0.02, -0.12))
STAND = Camera(eye=(2.2, -0.7, 0.75), look_at=(0.9, 0.2, -0.12))
RIM = Camera(eye=(1.75, -1.35, 0.45), look_at=(0.86, -0.25, -0.14))
FAR_END = Camera(eye=(2.55, -1.35, 1.1), look_at=(0.86, 0.0, -0.17))
KITCHEN = Camera(eye=(0.05, -1.7, 0.95), look_at=(0.95, -0.12, -0.22))
MOUTH = Camera(eye=(0.3, -1.0, 0.45), look_at=(1.08, -0.02, -0.15))
BEFORE_S = 0.05  # an instant before the fingers open


def main() -> None:
    """Draw every picture."""
    _draw_cans()
    _draw_dish()
    _draw_obstacles()
    _draw_project()


def _draw_cans() -> None:
    pictures = CANS / "pictures"
    solution = _assessed(CANS / "solution.v2")
    fetched = _grasped(solution, "can1")
    let_go = _released(solution, "can1")
    placed = _released(solution, "can2")
    _draw(pictures / "put.png", solution, placed - BEFORE_S, ROOM)
    _draw(pictures / "grip.png", solution, fetched + BEFORE_S, TABLE)
    _draw(pictures / "carry.png", solution, (fetched + let_go) / 2, TABLE)
    _draw_contact(pictures / "touch.png", CANS / "submissions" / "hits-base.v2", TABLE)


def _draw_dish() -> None:
    pictures = DISH / "pictures"
    solution = _assessed(DISH / "solution.v2")
    _draw(pictures / "grip.png", solution, _grasped(solution, "dish") + BEFORE_S, RIM)
    _draw(pictures / "put.png", solution, _released(solution, "dish") - BEFORE_S, STAND)


def _draw_obstacles() -> None:
    pictures = OBSTACLES / "pictures"
    solution = _assessed(OBSTACLES / "solution.v2")
    assert solution.task is not None
    visits = visits_of(_run(solution), solution.task.vias)
    first, second = (visit.intervals[0][0] for visit in visits)
    _draw(pictures / "setting.png", solution, 0.0, ABOVE)
    _draw(pictures / "gap1.png", solution, first, FAR_END)
    _draw(pictures / "gap2.png", solution, second, FAR_END)
    _draw_contact(pictures / "touch.png", OBSTACLES / "submissions" / "hits-post.v2", FAR_END)


def _draw_project() -> None:
    pictures = PROJECT / "pictures"
    solution = _assessed(PROJECT / "solution.v2")
    assert solution.task is not None
    door = visits_of(_run(solution), solution.task.vias)[0].intervals[0][0]
    _draw(pictures / "setting.png", solution, 0.0, KITCHEN)
    _draw(pictures / "dish.png", solution, _released(solution, "dish") - BEFORE_S, KITCHEN)
    _draw(pictures / "door.png", solution, door, MOUTH)
    _draw(pictures / "baked.png", solution, _run(solution).horizon_s, KITCHEN)
    wrong = PROJECT / "submissions"
    _draw_contact(pictures / "touch.png", wrong / "down-into-the-oven.v2", MOUTH)


def _draw_contact(path: Path, program: Path, camera: Camera) -> None:
    """Draw the first contact of a program, where it is deepest."""
    touching = _assessed(program)
    contact = _first_contact(touching)
    _draw(
        path,
        touching,
        contact.deepest_s,
        camera,
        highlight=contact.parts,
        marker=contact.point,
    )


def _first_contact(a: Assessment) -> ContactEvent:
    assert a.judgement is not None
    collisions = a.judgement.collisions
    assert collisions is not None
    return collisions.contacts[0]


def _grasped(a: Assessment, body: str) -> float:
    return _time(a, lambda e: isinstance(e, Grasped) and e.body == body)


def _released(a: Assessment, body: str) -> float:
    return _time(a, lambda e: isinstance(e, Released) and e.body == body)


def _assessed(program: Path) -> Assessment:
    folder = program.parent.parent if program.parent.name == "submissions" else program.parent
    return assess(request_for(program, Where(task=folder / "task.toml")))


def _run(a: Assessment) -> Run:
    assert a.run is not None
    return a.run


def _time(a: Assessment, wanted: Callable[[Event], bool]) -> float:
    return next(event.time_s for event in _run(a).events if wanted(event))


def _draw(
    path: Path,
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
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(picture)
    print(f"{path.relative_to(ROOT)}  {a.title} at {time_s:.3f} s  {len(picture) / 1000:.0f} kB")


if __name__ == "__main__":
    main()
