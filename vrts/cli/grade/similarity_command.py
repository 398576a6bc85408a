"""`vrts grade similarity`."""

import os
from pathlib import Path

import click

from vrts.cli.grade.options import corpus_option
from vrts.cli.shared.console import guarded, say, show_diagnostics
from vrts.cli.shared.options import color_option

EPILOG = """\b
Examples:
  vrts grade similarity out
  vrts grade similarity out --corpus out-2025 --corpus old-downloads.zip
"""


@click.command(name="similarity", epilog=EPILOG)
@click.argument("out", type=click.Path(path_type=Path))
@corpus_option()
@color_option
@guarded
def command(out: Path, others: tuple[Path, ...], color: str) -> None:
    """Compare the programs of the marking OUT again, without marking.

    OUT is the folder that `vrts grade` wrote with -o. It keeps what is compared in
    staff/similarity/programs.zip. Each --corpus is another such folder, that zip of one, or a
    folder or zip of programs. Runs can be compared only with an output of `vrts grade`: programs in
    a plain folder have not been run. Groups, pairs and pages in OUT/staff are written again. No
    mark changes.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy: threads do not fork
    from vrts.marking.layout import Layout
    from vrts.marking.similarity.corpus import read_corpora
    from vrts.marking.similarity.files import PAGE
    from vrts.marking.similarity.redo import redo

    layout = Layout(out)
    corpora = read_corpora(others, out)
    show_diagnostics(corpora.findings, color)
    ranking = redo(layout, corpora)
    strong = sum(one.strength == "strong" for one in ranking.groups)
    groups = "1 group" if len(ranking.groups) == 1 else f"{len(ranking.groups)} groups"
    programs = "1 program" if ranking.compared == 1 else f"{ranking.compared} programs"
    say(f"{programs} compared: {groups}, {strong} strong")
    say(f"wrote {layout.staff / PAGE}")
