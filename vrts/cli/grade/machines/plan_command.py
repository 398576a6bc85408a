"""`vrts grade plan`."""

import os
from pathlib import Path

import click

from vrts.cli.grade.options import (
    mend_option,
    no_pages_option,
    recordings_option,
    roster_option,
    table_option,
    variants_key_option,
    zone_option,
)
from vrts.cli.grade.what_to_mark import require_folder, what_to_mark
from vrts.cli.shared.console import fail, guarded, out, say, show_diagnostics
from vrts.cli.shared.options import (
    color_option,
    engine_option,
    file_option,
    lab_option,
    no_collisions_option,
)
from vrts.cli.shared.zones import zone_named

EPILOG = """\b
Examples:
  vrts grade plan lab1-staff.zip download.zip --shards 20 -o plan

\b
Then, on one machine:
  ls plan/shards | xargs -P 4 -I{} vrts grade run plan/shards/{} -o results
with GNU parallel, on several:
  parallel -S node1,node2 --transfer --return {/.}.zip vrts grade run {} -o {/.}.zip \\
      ::: plan/shards/*.json
as a SLURM array, on machines that share this folder:
  sbatch --array=1-20 --mem=4G --wrap \\
      'vrts grade run plan/shards/shard-$(printf %02d $SLURM_ARRAY_TASK_ID).json -o results'
and then on your own machine:
  vrts grade merge plan results -o out
"""


@click.command(name="plan", epilog=EPILOG)
@click.argument("task")
@click.argument("submissions", nargs=-1, type=click.Path(path_type=Path))
@click.option("--shards", type=click.IntRange(1, 10_000), default=10, show_default=True)
@file_option(
    "-o",
    "--output",
    "folder",
    default=Path("plan"),
    show_default=True,
    help="Folder of the plan.",
)
@click.option(
    "--overwrite", is_flag=True, help="Plan again; results of the old plan cannot be merged then."
)
@table_option
@roster_option()
@variants_key_option
@zone_option
@no_pages_option("Results only, no pages.")
@recordings_option("A Rerun recording of every run.")
@mend_option()
@no_collisions_option
@engine_option()
@lab_option
@color_option
@guarded
def command(
    task: str,
    submissions: tuple[Path, ...],
    shards: int,
    folder: Path,
    overwrite: bool,
    table: Path | None,
    class_list: Path | None,
    variants_key: Path | None,
    zone: str | None,
    no_pages: bool,
    recordings: bool,
    mend: int,
    no_collisions: bool,
    engine: str | None,
    lab: Path | None,
    color: str,
) -> None:
    """Divide a class into shards that other machines can mark.

    TASK, SUBMISSIONS and options are those of `vrts grade`; its --pseudonyms is for marking on this
    machine only. At the end `vrts grade merge` writes all that `vrts grade` does.

    Every file in PLAN/shards has all that marking needs: the task with its hidden checks, and some
    programs under pseudonyms. It holds no name of a student or of a file, but it does hold what
    students write in their programs, and a secret that signs its results. PLAN/key.json says whose
    results are whose, and holds the programs and the secret of the plan: keep it on your own
    machine, and delete it when the marks are final.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy: threads do not fork
    from vrts.marking.class_plan import plan_class
    from vrts.marking.remote.plan import KEY, SHARDS, write_plan
    from vrts.marking.submission.one import Wanted
    from vrts.marking.variants.of_class import marker_for
    from vrts.marking.whole_class import HowTo

    require_folder(folder)
    if (folder / KEY).exists() and not overwrite:
        hints = ("`--overwrite` plans again; results of the old plan cannot be merged then",)
        fail(f"there is a plan in `{folder}` already", hints)
    place, found = what_to_mark(task, submissions, lab)
    wanted = Wanted(not no_collisions, engine, not no_pages, recordings, mend)
    marker = marker_for(place, wanted, class_list, variants_key)
    how = HowTo(
        os.cpu_count() or 1,
        table=table,
        roster=class_list,
        zone=zone_named(zone) if zone else None,
    )
    planned = plan_class(marker, found, shards, how)
    show_diagnostics((*marker.whole.stamps, *planned.warnings), color)
    for remark in planned.remarks:
        say(f"note: {remark}")
    for old in (folder / SHARDS).glob("shard-*.json"):
        old.unlink()
    key = planned.plan.key
    places = write_plan(planned.plan, folder)
    count = sum(len(sent.entries) for sent in key.shards)
    out(f"{folder / SHARDS}: {len(places)} shards of {count} programs")
    if key.others:
        out(f"{len(key.others)} more have nothing to mark; their results are in the key")
    out(f"{folder / KEY}: whose results are whose; keep it here")
