"""`vrts grade run`."""

import os
import shutil
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import guarded, out, write_file
from vrts.cli.shared.options import color_option, file_option, jobs_option

if TYPE_CHECKING:
    from vrts.marking.marking import Done

PRIVATE = 0o700

EPILOG = """\b
Examples:
  vrts grade run plan/shards/shard-07.json -o results
  vrts grade run shard-07.json -o shard-07.zip --jobs 4
"""


@click.command(name="run", epilog=EPILOG)
@click.argument("shard", type=click.Path(path_type=Path))
@file_option(
    "-o",
    "--output",
    "target",
    default=Path("."),
    help="The zip to write, or a folder for it; without it this folder.",
)
@jobs_option("Programs at a time.", default=1)
@color_option
@guarded
def command(shard: Path, target: Path, jobs: int, color: str) -> None:
    """Mark one SHARD of `vrts grade plan`, on any machine that has the same vrts.

    It writes a zip of results and pages for `vrts grade merge`. The limits are those of `vrts
    grade`. After an interruption the same call goes on where it was. If the zip of this
    shard is there already, it does nothing.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy: threads do not fork
    from vrts.cli.shared.progress import Progress
    from vrts.marking.remote.marked import is_of
    from vrts.marking.remote.run_shard import run_shard
    from vrts.marking.remote.shard import digest_of, read_shard
    from vrts.pipeline.files import read_bytes

    data = read_bytes(shard)
    found = read_shard(data)
    path = target if target.suffix.lower() == ".zip" else target / f"{shard.stem}.zip"
    if path.is_file() and is_of(path, found, digest_of(data)):
        out(f"{path}: there already")
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    work = path.with_name(f".{path.stem}-{digest_of(data)[:12]}")
    work.mkdir(exist_ok=True)
    work.chmod(PRIVATE)  # programs and hidden checks are in it
    progress = Progress()
    progress.begin(len(found.pieces))

    def done(row: "Done") -> None:
        progress.step(reused=row.reused)
        progress.show()

    with progress.interruptible("the same call goes on"):
        results = run_shard(found, data, work, jobs=jobs, done=done)
    progress.clear()
    write_file(path, results, private=True)
    shutil.rmtree(work, ignore_errors=True)
    out(f"{path}: {len(found.pieces)} marked")
