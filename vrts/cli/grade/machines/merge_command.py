"""`vrts grade merge`."""

import os
import sys
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.grade.mark_command import write_lists
from vrts.cli.grade.options import corpus_option
from vrts.cli.grade.what_to_mark import require_folder
from vrts.cli.shared.console import FAULT, HOLDS, WRONG, fail, guarded, out, say, show_diagnostics
from vrts.cli.shared.options import color_option, file_option

if TYPE_CHECKING:
    from vrts.marking.about import About
    from vrts.marking.layout import Layout
    from vrts.marking.remote.at_home import AtHome
    from vrts.marking.remote.plan import Key
    from vrts.marking.similarity.corpus import Corpora

EPILOG = """\b
Examples:
  vrts grade merge plan results -o out
  vrts grade merge plan shard-01.zip shard-02.zip -o out
  vrts grade merge plan results -o out --corpus out-2025

\b
What no other machine has marked can be marked here; what was merged is not marked again:
  vrts grade lab1-staff.zip download.zip -o out
"""


@click.command(name="merge", epilog=EPILOG)
@click.argument("plan", type=click.Path(path_type=Path))
@click.argument("results", nargs=-1, type=click.Path(path_type=Path))
@file_option(
    "-o",
    "--output",
    "folder",
    required=True,
    help="Folder of the marking.",
)
@click.option(
    "--unsigned",
    is_flag=True,
    help="Take results of a plan of an earlier vrts, which nothing signed.",
)
@corpus_option()
@color_option
@guarded
def command(
    plan: Path,
    results: tuple[Path, ...],
    folder: Path,
    unsigned: bool,
    others: tuple[Path, ...],
    color: str,
) -> None:
    """Put RESULTS of shards where marking puts them, under the students' own ids.

    PLAN is the folder of `vrts grade plan`, or its key.json; RESULTS are zips of `vrts grade run`,
    or folders of them. Every shard signs its results: what was changed on the way is refused, and
    so is a result whose parts do not give its mark, or that is not about the program that was sent.
    Each is named, with the shard to run again; the others are taken. You can call it again with
    more results. When every submission has one, it writes the lists of marks, the overview and the
    pages, as `vrts grade` does; --corpus is that of `vrts grade`. Exit status 1 when results are
    refused or missing.

    A signature shows that results come from who had the shard, not that this machine told the
    truth: mark on machines that you trust.
    """
    from vrts.marking.about import NAME
    from vrts.marking.class_files import begin_class
    from vrts.marking.layout import Layout
    from vrts.marking.privacy.pseudonyms import require_names
    from vrts.marking.remote.merge import merge, require_secret
    from vrts.marking.remote.plan import read_key
    from vrts.marking.similarity.corpus import read_corpora

    require_folder(folder)
    require_names(Layout(folder))
    key = read_key(plan)
    require_secret(key, unsigned=unsigned)
    corpora = read_corpora(others, folder)  # first: what is wrong with one is told at once
    about = _about(key)
    if not (Layout(folder).staff / NAME).exists():
        begin_class(about, Layout(folder))
    merged = merge(key, list(_zips(results)), Layout(folder), unsigned=unsigned)
    show_diagnostics((*merged.findings, *corpora.findings), color)
    if key.secret is None:
        say("note: the plan is of an earlier vrts: nothing shows whether its results were changed")
    total = sum(len(sent.entries) for sent in key.shards) + len(key.others)
    out(f"{folder}: {total - len(merged.missing)} of {total} submissions have results")
    fault = False
    if merged.missing:
        say("note: lists of marks are written when every submission has a result")
    elif key.home is None:
        say("note: mark the class into the same folder to write the lists of marks")
    else:
        fault = _lists(key, key.home, about, Layout(folder), corpora, color)
    sys.exit(FAULT if fault else WRONG if merged.findings else HOLDS)


def _lists(
    key: "Key",
    home: "AtHome",
    about: "About",
    layout: "Layout",
    corpora: "Corpora",
    color: str,
) -> bool:
    """Write what `vrts grade` writes of a class; return whether vrts failed on one of it."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy: threads do not fork
    from vrts.marking.class_plan import merged_class, planned_marker

    marker = planned_marker(key, home)
    marked = merged_class(marker, home, layout)
    show_diagnostics((*marker.whole.stamps, *marked.warnings), color)
    for remark in marked.remarks:
        say(f"note: {remark}")
    write_lists(marker, marked, layout, about, color, corpora)
    return any(done.result.is_fault for done in marked.done)


def _about(key: "Key") -> "About":
    """Return what is known of a marking whose lists are still to be made."""
    from vrts import __version__
    from vrts.marking.about import About
    from vrts.marking.submission.one import Wanted
    from vrts.marking.submission.setting import Place

    task, home = key.staff.task, key.home
    return About(
        "vrts.marking/1",
        task.title,
        Place(task.name) if home is None else home.place,
        () if home is None else home.submissions,
        Wanted() if home is None else home.wanted,
        __version__,
        tuple(sys.argv),
        None,
        begun=datetime.now(UTC),
    )


def _zips(places: Iterable[Path]) -> Iterator[Path]:
    for place in places:
        if not place.exists():
            fail(f"there is no `{place}`")
        yield from sorted(place.glob("*.zip")) if place.is_dir() else (place,)
