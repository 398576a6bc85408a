"""Pictures of moments of a run."""

from collections.abc import Collection

from vrts.base.pose import Vector
from vrts.report.assessment import Assessment
from vrts.report.first_screen import first_screen
from vrts.report.picture.still import still

SIZE = (480, 360)


def moment_picture(
    a: Assessment, size: tuple[int, int] = SIZE, *, samples: int = 2
) -> bytes | None:
    """Return a PNG of the moment on the first screen, else of the end; None without a run."""
    if a.run is None:
        return None
    moment = first_screen(a).moment
    time_s = a.run.horizon_s if moment is None else min(moment.time_s, a.run.horizon_s)
    contacts = a.judgement.collisions.contacts if a.judgement and a.judgement.collisions else ()
    contact = next((c for c in contacts if moment and c.start_s <= time_s <= c.end_s), None)
    if contact is None:
        bodies = [body for body in moment.bodies if body != "robot"] if moment else []
        return picture_at(a, time_s, size, samples=samples, highlight=bodies)
    return picture_at(
        a,
        contact.deepest_s,
        size,
        samples=samples,
        highlight=contact.parts,
        marker=contact.point,
    )


def picture_at(
    a: Assessment,
    time_s: float,
    size: tuple[int, int] = (1200, 800),
    *,
    samples: int = 2,
    highlight: Collection[str] = (),
    marker: Vector | None = None,
) -> bytes:
    """Return a PNG of a run at a time [s].

    Raises:
        ValueError: Nothing ran.
    """
    if a.run is None or a.scene is None:
        raise ValueError("nothing ran")
    state = a.run.at(time_s)
    return still(
        a.scene,
        state.configuration,
        hand_opening=state.hand_opening,
        poses=state.poses,
        size=size,
        samples=samples,
        highlight=highlight,
        marker=marker,
    )
