"""Options that mean the same in several commands of `vrts grade`."""

from typing import Any

import click

from vrts.cli.shared.options import Option, file_option

ALL = "all"  # in place of reasons
DESPITE = (
    *("crashed", "resource", "ambiguous", "unread", "conflict", "lapsed", "variant", "altered"),
    *("version", "hidden", "unchecked", "undetermined", "late", ALL),
)  # a test holds them against the reasons, which are imported when they are used
SETTLED = tuple(name for name in DESPITE if name not in ("conflict", "lapsed"))  # by `change`

results_option = file_option("-o", "--output", "folder", help="Folder for results.")
marking_option = file_option(
    "--from", "folder", required=True, metavar="OUT", help="The folder that the marking wrote."
)
table_option = file_option(
    "--intake", "table", help="The table of `vrts grade intake`, with edits."
)
again_option = click.option("--again", is_flag=True, help="Mark again what is marked already.")
zone_option = click.option(
    "--zone",
    metavar="ZONE",
    help="Zone of times that name none: Europe/Vienna, +01:00; without it that of the deadline.",
)


def corpus_option() -> Option[Any]:
    """Return `--corpus`."""
    return file_option(
        "--corpus",
        "others",
        multiple=True,
        metavar="OTHER",
        help="Compare also with an earlier output of `vrts grade`, or programs. Repeatable.",
    )


def no_pages_option(says: str = "Write results only, no pages.") -> Option[Any]:
    """Return `--no-pages`."""
    return click.option("--no-pages", is_flag=True, help=says)


def recordings_option(says: str = "Write a Rerun recording of every run.") -> Option[Any]:
    """Return `--recordings`."""
    return click.option("--recordings", is_flag=True, help=says)


def mend_option() -> Option[Any]:
    """Return `--mend`."""
    return click.option(
        "--mend",
        type=click.IntRange(0, 5000),
        default=0,
        metavar="N",
        help="Look for what would earn the full mark: try N changes of each program, such as 300.",
    )


def roster_option(also: str = "") -> Option[Any]:
    """Return `--roster`; `also` is what else a command takes from it."""
    says = "Moodle's grading worksheet, or the grade book of Canvas: names, ids, who is missing"
    return file_option("--roster", "class_list", help=f"{says}{also}.")


variants_key_option = file_option(
    "--key",
    "variants_key",
    help="The key of a task with variants; without it variants.key beside TASK.",
)


def despite_option() -> Option[Any]:
    """Return `--despite`."""
    return click.option(
        "--despite",
        type=click.Choice(DESPITE),
        multiple=True,
        metavar="REASON",
        help="Accept marks that are unsafe for this reason; `all` for any. Repeatable.",
    )


def settles_option() -> Option[Any]:
    """Return `--settles`."""
    return click.option(
        "--settles",
        type=click.Choice(SETTLED),
        multiple=True,
        metavar="REASON",
        help="What made the mark unsafe and is decided now; `--mark` settles all. Repeatable.",
    )
