"""`vrts dispatch profile`."""

import click

from vrts.cli.shared.console import guarded, out

EPILOG = """\b
Examples:
  vrts dispatch profile
  vrts dispatch profile mark2-val2 > mine.toml
"""


@click.command(name="profile", epilog=EPILOG)
@click.argument("name", required=False)
@guarded
def command(name: str | None) -> None:
    """List the profiles of controllers, or print the file of one, to copy and correct.

    A corrected copy keeps its `name`, ends in .toml, and is given with `--profile`.
    """
    from vrts.dispatch.profile import NOT_TRIED, find_profile, profile_names, profile_text

    if name is not None:
        out(profile_text(name), end=False)
        return
    for each in profile_names():
        profile = find_profile(each)
        out(f"{each:<16}{profile.title}{'' if profile.tried else f', {NOT_TRIED}'}")
