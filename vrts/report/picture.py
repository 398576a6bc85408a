"""The picture of the moment that the first screen tells about."""

from vrts.report.assessment import Assessment
from vrts.report.first_screen import first_screen

SIZE = (960, 640)


def moment_picture(
    a: Assessment, size: tuple[int, int] = SIZE, *, samples: int = 2
) -> bytes | None:
    """Return a PNG of the costliest moment, else of the end; None when nothing ran."""
    if a.run is None or a.scene is None:
        return None
    from vrts.report.still import still

    moment = first_screen(a).moment
    time_s = a.run.horizon_s if moment is None else min(moment.time_s, a.run.horizon_s)
    contacts = a.judgement.collisions.contacts if a.judgement and a.judgement.collisions else ()
    contact = next((c for c in contacts if moment and c.start_s <= time_s <= c.end_s), None)
    if contact is not None:
        time_s = contact.deepest_s
    state = a.run.at(time_s)
    return still(
        a.scene,
        state.configuration,
        hand_opening=state.hand_opening,
        poses=state.poses,
        size=size,
        samples=samples,
        highlight=contact.parts if contact else (moment.bodies if moment else ()),
        marker=contact.point if contact else None,
    )
