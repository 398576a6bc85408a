"""The pictures in a page: the moment of the first screen, then the worst contacts."""

from collections.abc import Sequence

from vrts.check.verdict import ContactEvent
from vrts.report.assessment import Assessment
from vrts.report.first_screen import first_screen
from vrts.report.picture.moments import SIZE, moment_picture, picture_at

MOMENT = "moment"
MOST_STILLS = 4  # in a page


def page_stills(a: Assessment) -> dict[str, bytes]:
    """Return PNG pictures by name: "moment", and `contact_name` of the deepest other contacts.

    Empty where nothing ran. The page's viewer draws the contacts that have no still.
    """
    picture = moment_picture(a)
    if picture is None:
        return {}
    stills = {MOMENT: picture}
    shown = shown_first(a)
    for number, contact in worst_first(contacts_of(a)):
        if len(stills) == MOST_STILLS:
            break
        if number != shown:
            stills[contact_name(number)] = picture_at(
                a,
                contact.deepest_s,
                SIZE,
                highlight=contact.parts,
                marker=contact.point,
            )
    return stills


def contacts_of(a: Assessment) -> tuple[ContactEvent, ...]:
    """Return the contacts of a run, in time order; none where they were not checked."""
    report = a.judgement.collisions if a.judgement else None
    return report.contacts if report else ()


def worst_first(contacts: Sequence[ContactEvent]) -> list[tuple[int, ContactEvent]]:
    """Return contacts with their places in time order, deepest first."""
    return sorted(enumerate(contacts), key=lambda entry: (-entry[1].depth_m, entry[0]))


def contact_name(number: int) -> str:
    """Return the name of the still of a contact, by its place in time order."""
    return f"contact {number}"


def shown_first(a: Assessment) -> int | None:
    """Return the contact that the picture on the first screen shows; None when it shows none."""
    moment = first_screen(a).moment
    if moment is None:
        return None
    under_way = (
        number for number, c in enumerate(contacts_of(a)) if c.start_s <= moment.time_s <= c.end_s
    )
    return next(under_way, None)
