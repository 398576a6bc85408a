"""What a controller holds, beside a bundle: as text, line by line."""

from collections.abc import Mapping
from difflib import unified_diff

from vrts.base.source import SourceFile
from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.steps import Steps, first_difference
from vrts.dispatch.transfer.cargo import Cargo
from vrts.dispatch.transfer.held import asking
from vrts.dispatch.transfer.held.read_back import same_value
from vrts.dispatch.transfer.listed import Place
from vrts.dispatch.transfer.locations import same_place
from vrts.dispatch.transfer.talk import Talk
from vrts.lang.dialect import Dialect
from vrts.lang.writing.layout import layout


def differences(talk: Talk, profile: Profile, cargo: Cargo) -> list[str]:
    """Return rows that tell in what a controller differs from a bundle; none: in nothing.

    Raises:
        Refused: The controller does not wait for commands, or answers unlike its profile.
    """
    talk.begin()
    asking.refuse_unless_at_commands(talk.at)
    found: list[str] = []
    for program in cargo.programs:
        found += _of_program(program, asking.program_on(talk, profile, program.name), profile)
    if cargo.places:
        found += _of_places(cargo.places, asking.all_places(talk, profile), profile)
    for name, value in cargo.values:
        there = asking.value_on(talk, profile, name)
        if there is None or not same_value(value, there):
            found += [f"-{name} {value}", *([] if there is None else [f"+{name} {there}"])]
    return found


def _of_program(program: Steps, found: Steps | None, profile: Profile) -> list[str]:
    if found is None:
        return [f"-.PROGRAM {program.name}{program.formals}  (not on the controller)"]
    if first_difference(program, found, profile.language) is None:
        return []
    here, there = (_canonical(each, profile.language) for each in (program, found))
    names = (f"{program.name} in the bundle", f"{program.name} on the controller")
    return list(unified_diff(here, there, *names, lineterm=""))


def _canonical(program: Steps, dialect: Dialect) -> list[str]:
    return layout(SourceFile(program.name, program.text), dialect).splitlines()


def _of_places(
    places: tuple[Place, ...], present: Mapping[str, Place], profile: Profile
) -> list[str]:
    rows: list[str] = []
    for place in places:
        there = present.get(place.name)
        if there is None or not same_place(place, there, profile):
            rows.append(f"-{place.name} {' '.join(place.values)}")
        if there is not None and not same_place(place, there, profile):
            rows.append(f"+{there.name} {' '.join(there.values)}")
    return rows
