"""What of a bundle goes over the line, as it is typed."""

from typing import NamedTuple

from vrts.dispatch.bundle import Bundle, rows
from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.steps import Steps, steps_of
from vrts.dispatch.transfer.listed import Place
from vrts.dispatch.transfer.problems import OTHER_PROFILE, stop


class Cargo(NamedTuple):
    """Programs and locations to be entered, and values that only an operator can enter."""

    programs: tuple[Steps, ...]
    places: tuple[Place, ...]
    values: tuple[tuple[str, str], ...]  # numbers and strings: name, and value as a file has it


def cargo_of(bundle: Bundle, profile: Profile) -> Cargo:
    """Return what of a bundle goes to a controller.

    Raises:
        Refused: It was planned for a controller of another kind, or does not fit this one.
    """
    if bundle.profile != profile.name:
        raise stop(
            OTHER_PROFILE,
            f"this bundle was planned for `{bundle.profile}`, not for `{profile.name}`",
            remedy="plan it for this controller, or take the profile that it was planned for",
        )
    cargo = Cargo(
        tuple(steps_of(text) for text in bundle.programs.values()),
        tuple(Place(name, tuple(values.split())) for name, values in rows(bundle.locations)),
        (*rows(bundle.reals), *rows(bundle.strings)),
    )
    misfit = next(filter(None, (*_long(cargo, profile), *_fine(cargo, profile))), None)
    if misfit is not None:
        headline = f"this bundle does not fit the profile `{profile.name}`: {misfit}"
        raise stop(OTHER_PROFILE, headline, remedy="plan it again with this profile")
    return cargo


def _long(cargo: Cargo, profile: Profile) -> list[str | None]:
    names = [program.name for program in cargo.programs]
    names += [place.name.lstrip("#").partition("[")[0] for place in cargo.places]
    found = [
        f"the name `{name}` is longer than {profile.name_length} characters"
        for name in names
        if len(name) > profile.name_length
    ]
    lines = [
        (f"step {number} of `{program.name}`", row)
        for program in cargo.programs
        for number, row in enumerate(program.rows, 1)
    ]
    lines += [(f"`{place.name}`", ",".join(place.values)) for place in cargo.places]
    return [
        *found,
        *(
            f"{what} has {len(line)} characters, a line at most {profile.line_length}"
            for what, line in lines
            if len(line) > profile.line_length
        ),
    ]


def _fine(cargo: Cargo, profile: Profile) -> list[str | None]:
    return [_misfit(place, profile) for place in cargo.places]


def _misfit(place: Place, profile: Profile) -> str | None:
    if len(place.values) != len(_LETTERS):
        return f"`{place.name}` has {len(place.values)} numbers, not six"
    lengths = 0 if place.is_joints else 3
    for at, value in enumerate(place.values):
        most = profile.length_decimals if at < lengths else profile.angle_decimals
        if len(value.partition(".")[2]) > most:
            return f"`{place.name}` has more decimals than the {most} that are listed"
    return None


_LETTERS = "XYZOAT"
