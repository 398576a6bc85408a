"""What a controller lists, against what was sent."""

from collections.abc import Sequence

from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.steps import Difference, Steps, first_difference
from vrts.dispatch.transfer.held.asking import all_places, program_on
from vrts.dispatch.transfer.listed import Place
from vrts.dispatch.transfer.locations import same_place
from vrts.dispatch.transfer.problems import READ_BACK_DIFFERS, stop, visible
from vrts.dispatch.transfer.talk import Says

_SINGLE = 1e-6  # relative: numbers are printed with seven digits
_REMEDY = "`vrts dispatch diff` lists it again; do not execute it as it is"


def verify_program(talk: Says, profile: Profile, program: Steps) -> None:
    """Compare a program with what the controller lists.

    Raises:
        Refused: It differs, or is not there.
    """
    found = program_on(talk, profile, program.name)
    if found is None:
        raise stop(READ_BACK_DIFFERS, f"`{program.name}` is not on the controller", remedy=_REMEDY)
    differs = first_difference(program, found, profile.language)
    if differs is not None:
        headline = f"`{program.name}` on the controller is not what was sent"
        raise stop(READ_BACK_DIFFERS, headline, where(differs), remedy=_REMEDY)


def verify_places(talk: Says, profile: Profile, places: Sequence[Place]) -> None:
    """Compare locations with what the controller lists.

    Raises:
        Refused: One differs, or is not there.
    """
    found = all_places(talk, profile)
    wrong = [
        f"`{place.name}`: sent {' '.join(place.values)}, "
        + (f"listed {' '.join(there.values)}" if there is not None else "not listed")
        for place in places
        if (there := found.get(place.name)) is None or not same_place(place, there, profile)
    ]
    if wrong:
        headline = "locations on the controller are not what was sent"
        raise stop(READ_BACK_DIFFERS, headline, *wrong[:20], remedy=_REMEDY)


def same_value(wanted: str, found: str) -> bool:
    """Return whether a number or a string is the same as printed."""
    if wanted.startswith('"'):
        return wanted == found
    try:
        ours, theirs = float(wanted), float(found)
    except ValueError:
        return False
    return abs(ours - theirs) <= _SINGLE * abs(ours)


def where(differs: Difference) -> str:
    """Return a difference in words."""
    if differs.step == 0:
        return f"its arguments are {differs.found or '()'}, not {differs.wanted or '()'}"
    if differs.found is None:
        return f"it ends before step {differs.step}"
    if differs.wanted is None:
        return f"it goes on with step {differs.step}: {visible(differs.found)}"
    return f"step {differs.step} is {visible(differs.found)}, not {visible(differs.wanted)}"
