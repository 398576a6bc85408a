"""Programs and locations from a controller, as a file of programs.

A listing has no check sum, so everything is listed twice and has to be alike.
"""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.steps import Steps
from vrts.dispatch.transfer.held import asking
from vrts.dispatch.transfer.listed import Place
from vrts.dispatch.transfer.problems import CONTROLLER_REFUSES, LISTING_UNREADABLE, stop
from vrts.dispatch.transfer.talk import Says, Talk
from vrts.lang.dialect import Dialect
from vrts.lang.writing.layout import NAME_WIDTH, layout


class Fetched(NamedTuple):
    """What a controller holds."""

    programs: tuple[Steps, ...]
    places: tuple[Place, ...]


def fetch(talk: Talk, profile: Profile, names: Sequence[str] = ()) -> Fetched:
    """Return programs, all of them where none is named, and all locations.

    Raises:
        Refused: The controller does not wait for commands, has no program of a name, or lists
            something else the second time.
    """
    talk.begin()
    asking.refuse_unless_at_commands(talk.at)
    found = _listed(talk, profile, names)
    if _listed(talk, profile, names) != found:
        headline = "the controller was asked twice, and has not listed the same"
        remedy = "check the line, and let nobody type at the controller meanwhile"
        raise stop(LISTING_UNREADABLE, headline, remedy=remedy)
    return found


def fetched_text(fetched: Fetched, dialect: Dialect | None = None) -> str:
    """Return a file with programs and locations; in canonical layout where a dialect is given."""
    text = "".join(program.text for program in fetched.programs)
    if fetched.places:
        width = NAME_WIDTH - 1
        rows = (f"{place.name:<{width}} {' '.join(place.values)}\n" for place in fetched.places)
        text += f".LOCATIONS\n{''.join(rows)}.END\n"
    return text if dialect is None else layout(SourceFile("fetched", text), dialect)


def _listed(talk: Says, profile: Profile, names: Sequence[str]) -> Fetched:
    programs = tuple(_named(talk, profile, name) for name in names)
    if not names:
        programs = asking.all_programs(talk, profile)
    return Fetched(programs, tuple(asking.all_places(talk, profile).values()))


def _named(talk: Says, profile: Profile, name: str) -> Steps:
    found = asking.program_on(talk, profile, name)
    if found is None:
        raise stop(CONTROLLER_REFUSES, f"the controller has no program `{name}`")
    return found
