"""Marks a shard, on whatever machine this is."""

from collections.abc import Callable
from pathlib import Path

from vrts.marking.layout import Layout
from vrts.marking.marking import Done, Entry, mark_class
from vrts.marking.remote.marked import results_zip
from vrts.marking.remote.portable import settle
from vrts.marking.remote.shard import Shard, digest_of
from vrts.marking.submission.marker import Marker
from vrts.marking.variants.marker import VariantsMarker


def run_shard(
    shard: Shard,
    data: bytes,
    work: Path,
    *,
    jobs: int = 1,
    done: Callable[[Done], None] = lambda _: None,
) -> bytes:
    """Return the zip of results of a shard.

    Args:
        shard: What to mark.
        data: Bytes of its file.
        work: Folder of our own. What an interrupted call left there is not made again.
        jobs: Processes at a time.
        done: Told every submission that has its result.

    Raises:
        CannotRead: The task names what is not here.
        Refused: The task has errors.
    """
    work.mkdir(parents=True, exist_ok=True)
    marker = _marker(shard, work)
    entries = [Entry(piece.pseudonym, piece.label, piece.program) for piece in shard.pieces]
    layout = Layout(work / "out")
    rows: dict[str, Done] = {}
    for row in mark_class(marker, entries, layout, jobs=jobs, limits=shard.limits):
        rows[row.entry.identifier] = row
        done(row)
    return results_zip(shard, digest_of(data), rows, layout)


def _marker(shard: Shard, work: Path) -> Marker:
    """Return what marks the programs of a shard, each by its variant where there are such."""
    place = settle(shard.task, work)
    if not shard.variants:
        return Marker(place, shard.wanted)
    variants = [settle(task, work / "variants" / tag) for tag, task in shard.variants.items()]
    tags = {piece.pseudonym: piece.variant for piece in shard.pieces}
    return VariantsMarker(place, shard.wanted, variants, tags)
