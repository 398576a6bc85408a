"""What of a bundle a controller holds already, and what is left to be done."""

from typing import NamedTuple

from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.steps import Steps, first_difference
from vrts.dispatch.transfer.cargo import Cargo
from vrts.dispatch.transfer.held import asking
from vrts.dispatch.transfer.held.fetch import Fetched, fetched_text
from vrts.dispatch.transfer.held.read_back import where
from vrts.dispatch.transfer.listed import Place
from vrts.dispatch.transfer.locations import is_nowhere, same_place
from vrts.dispatch.transfer.problems import LISTING_UNREADABLE, THERE_ALREADY, stop
from vrts.dispatch.transfer.talk import Says

States = dict[str, str]
"""What is known of each program and location on the controller, in words."""


class Options(NamedTuple):
    """What may be done with what is on the controller already."""

    replace: bool = False
    resume: bool = False


class Entry(NamedTuple):
    """A program that has to be entered."""

    program: Steps
    first: int = 1  # step
    old: Steps | None = None  # deleted before


class Work(NamedTuple):
    """What is left to be done."""

    programs: tuple[Entry, ...]
    places: tuple[Place, ...]
    old_places: tuple[Place, ...] = ()  # that get other values

    @property
    def old_programs(self) -> tuple[Steps, ...]:
        """Those that are deleted."""
        return tuple(entry.old for entry in self.programs if entry.old is not None)


def look(talk: Says, profile: Profile, cargo: Cargo, options: Options, states: States) -> Work:
    """Return what has to be entered; what is found is noted in `states`.

    Raises:
        Refused: Something else stands there under the same name, and may not be replaced.
    """
    looking = _Looking(talk, profile, options, states)
    entries = [entry for each in cargo.programs if (entry := looking.at_program(each)) is not None]
    present = asking.all_places(talk, profile) if cargo.places else {}
    wanted = [place for place in cargo.places if looking.at_place(place, present.get(place.name))]
    if looking.conflicts:
        raise stop(
            THERE_ALREADY,
            "the controller holds something else under the same name",
            *looking.conflicts,
            remedy="`--replace` keeps a copy of it in a file and replaces it",
        )
    there = [present[place.name] for place in wanted if place.name in present]
    old = [place for place in there if not is_nowhere(place, profile.language)]
    return Work(tuple(entries), tuple(wanted), tuple(old))


def copy_of_old(talk: Says, profile: Profile, work: Work) -> str:
    """Return what is about to be replaced as a file has it; empty when there is nothing.

    It is listed a second time: a listing has no check sum.

    Raises:
        Refused: It was not listed alike.
    """
    again = [asking.program_on(talk, profile, old.name) for old in work.old_programs]
    present = asking.all_places(talk, profile) if work.old_places else {}
    places = [present.get(old.name) for old in work.old_places]
    if again != list(work.old_programs) or places != list(work.old_places):
        raise stop(
            LISTING_UNREADABLE,
            "what is about to be replaced was listed twice, and not alike",
            "nothing was changed on the controller",
            remedy="check the line, and try again",
        )
    return fetched_text(Fetched(work.old_programs, work.old_places))


def key(each: Steps | Place) -> str:
    """Return the name of a program or a location among all of them."""
    return f"{'program' if isinstance(each, Steps) else 'location'} {each.name}"


class _Looking:
    def __init__(self, talk: Says, profile: Profile, options: Options, states: States) -> None:
        self.talk = talk
        self.profile = profile
        self.options = options
        self.states = states
        self.conflicts: list[str] = []

    def at_program(self, program: Steps) -> Entry | None:
        """Return how a program has to be entered; None: it is there."""
        found = asking.program_on(self.talk, self.profile, program.name)
        if found is None:
            self.states[key(program)] = "not there"
            return Entry(program)
        differs = first_difference(program, found, self.profile.language)
        if differs is None:
            self.states[key(program)] = "there already, the same"
            return None
        steps, name = len(found.rows), program.name
        begun = differs.found is None and differs.step == steps + 1
        if begun:
            self.states[key(program)] = f"steps 1 to {steps} of {len(program.rows)}"
        else:
            count = f"{steps} step{'' if steps == 1 else 's'}"
            self.states[key(program)] = f"another program ({count})"
        if begun and self.options.resume:
            return Entry(program, steps + 1)
        if not self.options.replace:
            first = f"has the first {steps} of {len(program.rows)} steps: `--resume` goes on"
            other = f"is another one: {where(differs)}"
            self.conflicts.append(f"program `{name}` {first if begun else other}")
        return Entry(program, 1, found)

    def at_place(self, place: Place, found: Place | None) -> bool:
        """Return whether a location has to be entered."""
        if found is None:
            self.states[key(place)] = "not there"
            return True
        if same_place(place, found, self.profile):
            self.states[key(place)] = "there already, the same"
            return False
        self.states[key(place)] = "there, with another value"
        begun = is_nowhere(found, self.profile.language)  # POINT, and no numbers yet
        if not self.options.replace and not (self.options.resume and begun):
            there, here = " ".join(found.values), " ".join(place.values)
            self.conflicts.append(f"location `{place.name}` is {there} there, and {here} here")
        return True
