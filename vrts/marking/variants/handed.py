"""What was handed out, written down beside the key: marking goes by it, and not by a new draw.

A draw made again gives others as soon as something that it goes by has changed: a choice, an
address in the list. Who has which is sealed with the key.
"""

import hashlib
import hmac
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final, Literal, NamedTuple, TypeAlias

import msgspec

from vrts.assignments.variants.key import BAD_KEY, NAME, place_of_handed, was_handed
from vrts.assignments.variants.of_task import VariedTask
from vrts.base.diagnostic import Diagnostic, Rule, error, warning
from vrts.check.variants.drawn import Variant
from vrts.check.variants.model import Combination, Variants
from vrts.marking.intake.row import Platform
from vrts.marking.variants.class_list import ClassList, Member, shown_names
from vrts.pipeline.files import read_bytes
from vrts.pipeline.refused import Refused

SCHEMA: Final = "vrts.handed/1"
CHANGED: Final = Rule("V918", "changed-after-hand-out")
NO_RECORD: Final = Rule("V779", "handed-out-unknown")
DRAWN_AGAIN: Final = "what was handed out is not beside the key, so variants were drawn again"
NOT_HANDED: Final = "`vrts task variants` has handed out no variant to this student"


class HandedTo(msgspec.Struct, frozen=True):
    """What one student was handed out."""

    tag: str
    values: dict[str, tuple[str, ...]]  # TOML text for each path, by the name of what varies


Students: TypeAlias = dict[str, HandedTo]  # by platform and id: "moodle 4711"
Files: TypeAlias = dict[str, str]  # digests by name


class _File(msgspec.Struct, frozen=True):
    format: Literal["vrts.handed/1"]
    tasks: dict[str, Students]  # by `assignment`: several may have one key
    seal: str  # by the key
    files: dict[str, Files] = {}  # by `assignment`: what the task said then


class Given(NamedTuple):
    """Who has which variant."""

    variants: Mapping[str, Variant]  # by id in the class
    doubts: Mapping[str, str]  # by id: why it may be another one than was handed out
    gone: tuple[Member, ...]  # whose variant the task does not have any more


def variants_of(
    varied: VariedTask,
    members: ClassList,
    key: bytes,
    handed: Students,
    *,
    lost: bool = False,
) -> Given:
    """Return the variant of everybody in a class: the one handed out, else the one drawn.

    Args:
        varied: The task.
        members: The class.
        key: The teacher's.
        handed: What was handed out; nothing: nobody knows, and all are drawn.
        lost: Whether something was handed out of which nothing is known.

    Raises:
        Refused: Hardly any combination is left for students.
    """
    found: dict[str, Variant] = {}
    doubts: dict[str, str] = {}
    gone: list[Member] = []
    for member in members.members:
        was = handed.get(name_of(members.platform, member))
        variant = None if was is None else variant_of(varied.variants, was)
        if variant is not None:
            found[member.number] = variant
            continue
        found[member.number] = varied.drawn(key, member.drawn_by)
        if was is not None:
            gone.append(member)
            words = f"the variant `{was.tag}` was handed out, which `[variants]` does not have now"
            doubts[member.number] = f"{words}; marked by `{found[member.number].tag}`"
        elif handed or lost:
            doubts[member.number] = NOT_HANDED if handed else DRAWN_AGAIN
    return Given(found, doubts, tuple(gone))


def record_gone(place: Path, assignment: str, handed: Students) -> tuple[Diagnostic, ...]:
    """Return a warning where variants were handed out by a key, and nobody knows which.

    Args:
        place: Of the key.
        assignment: Of the task.
        handed: What is written beside the key.
    """
    if handed or not was_handed(place, assignment):
        return ()
    headline = f"variants were handed out by the key `{place}`, and the record of it is not here"
    note = "variants are drawn again: somebody may get another one than was handed out"
    help_ = f"copy the record beside the key: `{place_of_handed(place).name}`"
    return (warning(NO_RECORD, headline, notes=(note,), help=(help_,)),)


def check_some_left(given: Given, key: Path) -> None:
    """Check that not everybody would be marked by another variant than was handed out.

    Raises:
        Refused: Everybody would.
    """
    if given.gone and len(given.doubts) == len(given.variants):
        raise changed(given.gone, key)


def changed(gone: Sequence[Member], key: Path) -> Refused:
    """Return the refusal where a task has not the variants any more that were handed out."""
    headline = f"`[variants]` was changed: what was handed out to {shown_names(gone)} is gone"
    remedies = (
        "put `[variants]` back as it was when variants were handed out",
        f"to draw all again, delete `{place_of_handed(key)}`, and hand out again",
    )
    return Refused((error(BAD_KEY, headline, help=remedies),))


def read_handed(place: Path, key: bytes, assignment: str) -> Students:
    """Return what was handed out by a key; nothing where nothing is written.

    Args:
        place: Of the key.
        key: The teacher's.
        assignment: Of the task.

    Raises:
        Refused: It was not written with this key, or is of another assignment.
    """
    path = place_of_handed(place)
    tasks = _read(path, key).tasks
    if place.name == NAME and tasks and assignment not in tasks:  # the key of one task
        headline = f"`assignment` is `{assignment}`, and variants were handed out for"
        headline += f" `{next(iter(tasks))}`"
        remedies = ("put it back: variants are drawn by it", f"to draw all again, delete `{path}`")
        raise Refused((error(BAD_KEY, headline, help=remedies),))
    return tasks.get(assignment, {})


def changed_since(place: Path, key: bytes, varied: VariedTask) -> tuple[Diagnostic, ...]:
    """Return a warning where a task says something else than when it was handed out.

    Args:
        place: Of the key.
        key: The teacher's.
        varied: The task as it is now.

    Raises:
        Refused: What is written beside the key was not written with it.
    """
    was = _read(place_of_handed(place), key).files.get(varied.variants.assignment)
    now = varied.meanings()
    if was is None or was == now:
        return ()
    names = [name for name in sorted({*was, *now}) if was.get(name) != now.get(name)]
    shown = ", ".join(f"`{name}`" for name in names)
    verb = "is another" if len(names) == 1 else "are others"
    note = "students have it as it was then, and all are marked by what it says now"
    remedies = (
        "put it back as it was, or tell the students what has changed",
        "nothing is to be done if it only became easier, such as a tolerance that is wider now",
    )
    headline = f"{shown} {verb} than when variants were handed out"
    return (warning(CHANGED, headline, notes=(note,), help=remedies),)


def handed_bytes(
    place: Path, key: bytes, varied: VariedTask, members: ClassList, given: Given
) -> bytes:
    """Return what is written down beside a key; what others were handed out by it stays.

    Raises:
        Refused: What is there was not written with this key.
    """
    students = {
        name_of(members.platform, member): handed_to(varied.variants, given.variants[member.number])
        for member in members.members
    }
    return sealed_with(place, key, varied.variants.assignment, students, varied.meanings())


def sealed_with(
    place: Path, key: bytes, assignment: str, students: Students, files: Files | None = None
) -> bytes:
    """Return what is written down beside a key with more students in it, or others' variants.

    Args:
        place: Of the key.
        key: The teacher's.
        assignment: Of the task.
        students: Who is handed out what now.
        files: What the task says; kept is what it said to the first of them. None: not known.

    Raises:
        Refused: What is there was not written with this key.
    """
    record = _read(place_of_handed(place), key)
    tasks, said = dict(record.tasks), dict(record.files)
    if files is not None and assignment not in tasks:
        said[assignment] = files
    tasks[assignment] = {**tasks.get(assignment, {}), **students}
    data = msgspec.json.encode(_File(SCHEMA, tasks, _seal(key, tasks, said), said), order="sorted")
    return msgspec.json.format(data, indent=1) + b"\n"


def handed_to(variants: Variants, variant: Variant) -> HandedTo:
    """Return a variant as it is written down for somebody."""
    chosen = zip(variants.varies, variant.combination, strict=True)
    return HandedTo(variant.tag, {vary.name: vary.choices[choice] for vary, choice in chosen})


def variant_of(variants: Variants, was: HandedTo) -> Variant | None:
    """Return the variant that was handed out; None: the task does not have it any more."""
    combination = _combination(variants, was.values)
    return None if combination is None else Variant(combination, was.tag)


def _read(path: Path, key: bytes) -> _File:
    if not os.path.lexists(path):
        return _File(SCHEMA, {}, "")
    try:
        found = msgspec.json.decode(b"" if path.is_symlink() else read_bytes(path), type=_File)
        sealed = hmac.compare_digest(found.seal, _seal(key, found.tasks, found.files))
    except (msgspec.DecodeError, UnicodeDecodeError, TypeError):
        found, sealed = _File(SCHEMA, {}, ""), False
    if not sealed:
        headline = f"`{path}` was changed, or belongs to another key"
        remedies = (
            "put it back, or the key: they tell who was handed out what",
            "to draw all again, delete it, and hand out again",
        )
        raise Refused((error(BAD_KEY, headline, help=remedies),))
    return found


def _seal(key: bytes, tasks: Mapping[str, Students], files: Mapping[str, Files]) -> str:
    told = (tasks, files) if files else tasks  # before there were files: a record of an older vrts
    return hmac.new(key, msgspec.json.encode(told, order="sorted"), hashlib.sha256).hexdigest()


def name_of(platform: Platform, member: Member) -> str:
    """Return by what the record knows somebody."""
    return f"{platform.value} {member.number}"


def _combination(variants: Variants, values: Mapping[str, tuple[str, ...]]) -> Combination | None:
    """Return the combination with some values; None: there is none with just these."""
    if set(values) != {vary.name for vary in variants.varies}:
        return None
    chosen = [(vary.choices, values[vary.name]) for vary in variants.varies]
    if any(value not in choices for choices, value in chosen):
        return None
    return tuple(choices.index(value) for choices, value in chosen)
