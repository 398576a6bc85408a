"""`vrts grade diff`."""

import getpass
import sys
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import HOLDS, WRONG, fail, guarded, out, say, show_diagnostics, warn
from vrts.cli.shared.options import color_option, form_option

if TYPE_CHECKING:
    from vrts.marking.appeals.moves import Diff
    from vrts.marking.by_hand.by_hand import ByHand
    from vrts.marking.row import Class

EPILOG = """\b
Examples:
  vrts grade diff out-before out-after
  vrts grade diff out-before out-after --never-lower --who "R. Huber"
  vrts grade diff before/results.json after/results.json --format json
"""

RESULTS = "results.json"


@click.command(name="diff", epilog=EPILOG)
@click.argument("old", type=click.Path(path_type=Path))
@click.argument("new", type=click.Path(path_type=Path))
@click.option(
    "--never-lower",
    is_flag=True,
    help="For everybody whose mark falls, write a change by hand into NEW/staff/overrides.toml.",
)
@click.option("--who", help="Who decides that; without it the name of the user.")
@form_option("full", "json")
@color_option
@guarded
def command(
    old: Path, new: Path, never_lower: bool, who: str | None, form: str, color: str
) -> None:
    """Say whose mark differs between the marking OLD and the marking NEW, and why.

    OLD and NEW are folders that `vrts grade` wrote with -o, or their staff/results.json. When you
    have repaired a task, mark into another folder, compare, and hand out the marks of the new one.
    The marks compared are final: after lateness and changes by hand. For NEW those changes are read
    from its overrides.toml as it is now. First copy the overrides.toml of OLD to NEW, or its
    changes are missing there.

    With --never-lower nobody ends below the old mark. Mark NEW again afterwards; that takes
    moments. Exit status 1 when a mark falls, or when somebody has no mark any more.
    """
    from vrts.marking.appeals.moves import diff
    from vrts.marking.appeals.moves_text import diff_text

    before, after = _rows(old), _rows(new)
    known = [row.id for row in after.rows]
    by_hand = _by_hand(new, after)
    if by_hand is not None:
        from vrts.marking.by_hand.by_hand import all_lapses, rows_by_hand

        show_diagnostics(by_hand.diagnostics, color)
        after = rows_by_hand(after, by_hand)
        show_diagnostics(all_lapses(after.rows, by_hand), color)
        changed = {row.id for row in before.rows if row.change is not None}
        decided = {row.id for row in after.rows if row.change or row.decided}
        lacking = sorted(changed & set(known) - decided)
        if lacking:
            warn(f"note: {len(lacking)} changed by hand in OLD and not in NEW, as `{lacking[0]}`")
    found = diff(before, after)
    out(_json(found) if form == "json" else diff_text(found))
    lowered = any(move.falls or move.new is None for move in found.moves)
    if never_lower:
        if by_hand is None:
            fail("with `--never-lower` NEW is a folder that `vrts grade` wrote")
        _raise(found, after, new, who or getpass.getuser())
        lowered = any(move.new is None for move in found.moves)
    sys.exit(WRONG if lowered else HOLDS)


def _rows(place: Path) -> "Class":
    from vrts.marking.appeals.written import read_class
    from vrts.marking.layout import Layout

    return read_class(Layout(place).results if place.is_dir() else place, place)


def _by_hand(place: Path, after: "Class") -> "ByHand | None":
    """Return what is decided by hand in a folder; None for a file."""
    from vrts.marking.appeals.written import late_rules
    from vrts.marking.by_hand.by_hand import load_by_hand
    from vrts.marking.layout import Layout

    if not place.is_dir():
        return None
    layout = Layout(place)
    known = [row.id for row in after.rows]
    return load_by_hand(layout, known, after.total, late_rules(layout))


def _raise(found: "Diff", after: "Class", new: Path, who: str) -> None:
    """Write changes for everybody who falls."""
    from vrts.marking.appeals.moves import never_lower
    from vrts.marking.by_hand.override_text import add_overrides
    from vrts.marking.layout import Layout

    added = never_lower(found, after, who, date.today().isoformat())
    if not added:
        say("nobody falls: nothing was written")
        return
    path = Layout(new).overrides
    add_overrides(path, added, [row.id for row in after.rows], after.total)
    one = "1 change" if len(added) == 1 else f"{len(added)} changes"
    say(f"wrote {one} into {path}; mark the class again")


def _json(found: "Diff") -> str:
    import msgspec

    return msgspec.json.format(msgspec.json.encode(found), indent=1).decode()
