"""Names that options had before, which go on working for two minor versions with a notice."""

from typing import NamedTuple

from vrts.cli.shared.console import note

GONE_WITH = "0.4"  # the version of vrts that knows them no more


class Renamed(NamedTuple):
    """An option, or a value of one, that has another name now."""

    old: str
    new: str
    of: tuple[str, ...] = ()  # the commands in which; none: wherever there is the new name


OPTIONS = (
    Renamed("--out", "--output"),
    Renamed("--program", "--entry"),
    Renamed("--force", "--overwrite", ("intake", "plan")),
    Renamed("--with", "--viewer", ("view",)),
    Renamed("--for", "--seconds", ("watch",)),
)
VALUES = (Renamed("text", "full", ("--format",)),)


def options_before(command: str, names: set[str]) -> tuple[Renamed, ...]:
    """Return what options of a command had as names, except where they name something else now.

    Args:
        command: Its name.
        names: Of all its options, each with its dashes.
    """
    return tuple(
        one
        for one in OPTIONS
        if one.new in names and one.old not in names and (not one.of or command in one.of)
    )


def tell(one: Renamed) -> None:
    """Say that a name is old; what is to be typed instead; until when it works."""
    note(f"`{one.old}` is now `{one.new}`; the old name works until vrts {GONE_WITH}")
