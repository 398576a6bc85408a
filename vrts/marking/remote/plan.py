"""A plan: the shards of a class, and the key that stays at home and gives results their names."""

import hashlib
import secrets
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Literal, NamedTuple

import msgspec

from vrts.base.diagnostic import Rule, error
from vrts.marking.layout import Layout
from vrts.marking.marking import Entry, without_program
from vrts.marking.remote.at_home import AtHome
from vrts.marking.remote.marked import written
from vrts.marking.remote.names import Naming, named_anew
from vrts.marking.remote.portable import portable
from vrts.marking.remote.shard import Cut, Job, PlanId, cut, digest_of, part_of
from vrts.marking.remote.signed import Secret, new_secret
from vrts.marking.result import Damaged, Digest, Named, Record, decoded
from vrts.marking.submission.marker import Marker, Marks
from vrts.marking.submission.summary import task_named
from vrts.marking.supervise.limits import Limits
from vrts.marking.supervise.scratch import scratch_folder
from vrts.pipeline.files import read_bytes
from vrts.pipeline.refused import Refused
from vrts.pipeline.setting import Setting

BAD_PLAN = Rule("V723", "bad-plan")

SCHEMA = "vrts.plan/2"
UNSIGNED = "vrts.plan/1"  # of a vrts whose shards signed nothing
KEY, SHARDS = "key.json", "shards"  # in the folder of a plan
LARGEST = 512_000_000  # bytes of a key
PRIVATE = 0o600  # a shard holds the hidden checks, the key the names


class Expected(Record, frozen=True):
    """A submission that is marked elsewhere."""

    naming: Naming
    staff: Digest  # keys that its results must have
    student: Digest
    program: Digest
    homes: tuple["Home", "Home"] | None = None  # of its own variant, for staff and student


class Home(Record, frozen=True):
    """How results name task and scene at home."""

    task: Named
    scene: Named
    total: float | None = None  # points; None: of a plan that did not say


class Sent(Record, frozen=True):
    """A shard that goes out."""

    number: int
    sha256: Digest
    entries: tuple[Expected, ...]


class Other(Record, frozen=True):
    """A submission in which there is nothing to mark: its results, and the files about it."""

    marks: Marks
    files: dict[str, bytes]  # by name, as a process writes them


class Key(Record, frozen=True):
    """What stays at home."""

    schema: Literal["vrts.plan/1", "vrts.plan/2"]
    plan: PlanId
    staff: Home
    student: Home
    shards: tuple[Sent, ...]
    others: tuple[Other, ...]
    secret: Secret | None = None  # from it come those of shards; None: of an earlier vrts
    home: AtHome | None = None  # None: of an earlier vrts, or of some programs without a class


class Plan(NamedTuple):
    """What is to be sent out, and the key."""

    cuts: tuple[Cut, ...]
    key: Key


def make_plan(
    marker: Marker, entries: Sequence[Entry], shards: int, limits: Limits | None = None
) -> Plan:
    """Return a plan for marking submissions on other machines.

    Args:
        marker: Of the task.
        entries: What to mark.
        shards: How many there are to be, if there are as many programs.
        limits: Of each process.

    Raises:
        CannotRead: A file of the task cannot be taken along.
        Refused: The task has errors.
    """
    named = [(e, named_anew(e.identifier, e.title)) for e in entries if e.data is not None]
    own = {naming.pseudonym: marker.of(entry.student).place for entry, naming in named}
    tags = {name: place.variant for name, place in own.items() if place.variant}
    job = Job(
        secrets.token_hex(8),
        new_secret(),
        portable(marker.place),
        marker.wanted,
        limits or marker.limits,
        {place.variant: portable(place) for place in own.values() if place.variant},
        tags,
    )
    expected = {naming.pseudonym: _expected(marker, entry, naming) for entry, naming in named}
    cuts = tuple(cut(job, named, shards))
    sent = tuple(
        Sent(c.number, digest_of(c.data), tuple(expected[n.pseudonym] for n in c.names))
        for c in cuts
    )
    others = tuple(_other(marker, entry) for entry in entries if entry.data is None)
    homes = _home(marker.whole), _home(marker.public)
    return Plan(cuts, Key(SCHEMA, job.plan, *homes, sent, others, job.secret))


def write_plan(plan: Plan, folder: Path) -> list[Path]:
    """Write the files of a plan, the key first; return those of the shards."""
    (folder / SHARDS).mkdir(parents=True, exist_ok=True)
    _write(folder / KEY, msgspec.json.format(msgspec.json.encode(plan.key), indent=1) + b"\n")
    digits = max(2, len(str(len(plan.cuts))))
    places: list[Path] = []
    for piece in plan.cuts:
        places.append(folder / SHARDS / f"shard-{piece.number:0{digits}}.json")
        _write(places[-1], piece.data)
    return places


def read_key(place: Path) -> Key:
    """Return the key of a plan; `place` is its file or the folder of the plan.

    Raises:
        CannotRead: It is not there.
        Refused: It is no key, or is damaged.
    """
    path = place / KEY if place.is_dir() else place
    data = read_bytes(path)
    try:
        if len(data) <= LARGEST:
            key = decoded(data, Key)
            if (key.secret is None) == (key.schema == UNSIGNED):
                return key
            why = "its secret is missing"
        else:
            why = f"it has more than {LARGEST:,} bytes"
    except Damaged as problem:
        why = str(problem)
    headline = f"`{path.name}` is not the key of a plan: {why[:200]}"
    remedy = "name the folder that `vrts grade plan` wrote, or plan again"
    raise Refused((error(BAD_PLAN, headline, help=(remedy,)),))


def rest_of(key: Key, whole: Cut, wanted: Collection[str]) -> tuple[Cut, Key]:
    """Return some submissions of a shard as a shard, and the key of what it gives.

    Args:
        key: Of the plan.
        whole: The shard.
        wanted: Identifiers.
    """
    names = tuple(naming for naming in whole.names if naming.identifier in wanted)
    part = part_of(whole, names)
    sent = tuple(
        Sent(
            one.number,
            digest_of(part.data),
            tuple(entry for entry in one.entries if entry.naming in names),
        )
        for one in key.shards
        if one.number == whole.number
    )
    return part, msgspec.structs.replace(key, shards=sent)


def _expected(marker: Marker, entry: Entry, naming: Naming) -> Expected:
    assert entry.data is not None
    data = entry.data
    program = hashlib.sha256(data).hexdigest()
    own = marker.of(entry.student)
    homes = None if own.variant is None else (_home(own.whole), _home(own.public))
    return Expected(naming, own.key(data), own.public_key(data), program, homes)


def _other(marker: Marker, entry: Entry) -> Other:
    with scratch_folder() as folder:
        layout = Layout(folder)
        done = without_program(marker, entry, layout)
        return Other(Marks(done.result, done.student), written(layout, entry.identifier))


def _home(setting: Setting) -> Home:
    scene, task = setting.scene, setting.task
    assert task is not None
    named = Named(scene.name, scene.name, scene.digest)
    return Home(task_named(setting), named, float(task.mark.total))


def _write(path: Path, data: bytes) -> None:
    draft = path.with_name(path.name + ".part")
    draft.touch(PRIVATE)
    draft.chmod(PRIVATE)
    draft.write_bytes(data)
    draft.replace(path)
