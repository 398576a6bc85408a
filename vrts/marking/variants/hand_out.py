"""The zips of a whole class, and the table of who has which variant."""

import re
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from vrts.assignments.variants.handed_out import HandedOut, handed_out, pictures_of, told_once
from vrts.assignments.variants.of_task import VariedTask
from vrts.base.diagnostic import Diagnostic, error
from vrts.base.safe_names import LONGEST_ID, safe
from vrts.base.workers import Workers
from vrts.base.zips import packed_in_turn
from vrts.check.variants.drawn import Variant
from vrts.marking.intake.row import Platform
from vrts.marking.intake.tables.table_text import BOM, field
from vrts.marking.variants.class_list import TWICE, ClassList, Member, shown_names
from vrts.pipeline.refused import Refused

TABLE = "variants.csv"
STUDENTS = "students"
MOODLE = "moodle-feedback.zip"
_NUMBER = re.compile(r"-?\d+(\.\d+)?")
MODE = 0o644  # of members
COLUMNS = ("id", "name", "email", "variant", "zip")
ALONE = Workers()
MOST_TOLD = 20  # diagnostics of variants that are no sound tasks


class Handed(NamedTuple):
    """What a class gets."""

    files: Mapping[str, bytes]  # zips by name
    table: bytes  # for staff
    moodle: bytes | None  # all zips as Moodle takes them; None: another platform
    variants: int  # different ones
    told: tuple[Diagnostic, ...]
    same_pictures: tuple[str, ...]  # that are no drawings of the scene: the same for all


def hand_out(
    varied: VariedTask,
    members: ClassList,
    variants: Mapping[str, Variant],
    versions: tuple[str, ...] = (),
    workers: Workers = ALONE,
    told: Callable[[int, int], None] = lambda _, __: None,
) -> Handed:
    """Return a zip for everybody in a class.

    Args:
        varied: The task.
        members: The class.
        variants: Who gets which, by id in the class.
        versions: Of vrts that may mark; none: this one.
        workers: Who writes them.
        told: Told how many different variants are written, and of how many.

    Raises:
        Refused: A variant that somebody has is no sound task.
    """
    pictures = pictures_of(varied)
    handed: list[tuple[Member, str, HandedOut]] = []
    wrong: list[Diagnostic] = []
    made: dict[str, HandedOut] = {}  # by tag: several may have the same
    asked = {one.tag: one for one in (variants[member.number] for member in members.members)}

    def write(variant: Variant) -> HandedOut | tuple[Diagnostic, ...]:
        try:
            return handed_out(varied, variant, pictures, versions)
        except Refused as refused:
            return refused.diagnostics

    answers = workers.answers(write, tuple(asked.values()))
    for done, (tag, one) in enumerate(zip(asked, answers, strict=True), start=1):
        told(done, len(asked))
        if isinstance(one, HandedOut):
            made[tag] = one
        else:
            wrong += one
    if wrong:
        raise Refused(tuple(wrong[:MOST_TOLD]))
    for member in members.members:
        handed.append((member, _file(member), made[variants[member.number].tag]))
    files = {f"{STUDENTS}/{name}": one.data for _, name, one in handed}
    _check_apart(handed)
    moodle = None
    if members.platform is Platform.MOODLE:
        moodle = packed_in_turn(_for_moodle(varied.files.name, handed), MODE)
    table, findings = _table(varied, handed), told_once(made.values())
    return Handed(files, table, moodle, len(made), findings, pictures.kept)


def _file(member: Member) -> str:
    """Return the name of a student's zip."""
    number = safe(member.number)
    room = max(0, LONGEST_ID - len(f"_{number}".encode()))  # a long name must not cut the number
    name = member.student.name.encode()[:room].decode(errors="ignore")
    return f"{safe(f'{name}_{number}')}.zip"


def _check_apart(handed: list[tuple[Member, str, HandedOut]]) -> None:
    """Check that no two students have a zip of one name.

    Raises:
        Refused: Two have.
    """
    seen: dict[str, Member] = {}
    for member, name, _ in handed:
        other = seen.setdefault(name.casefold(), member)
        if other is not member:
            headline = (
                f"two in the class would have the zip `{name}`: {shown_names((other, member))}"
            )
            raise Refused((error(TWICE, headline, help=("give them ids that differ more",)),))


def _for_moodle(
    task: str, handed: list[tuple[Member, str, HandedOut]]
) -> Iterator[tuple[str, bytes]]:
    """Yield what "Upload multiple feedback files in a zip" takes: it goes by the number alone."""
    for member, _, one in handed:
        name = safe(member.student.name.replace("_", "-"))
        folder = f"{name}_{member.number}_assignsubmission_file_"
        yield f"{folder}/{task}-{one.variant.tag}.zip", one.data


def _table(varied: VariedTask, handed: list[tuple[Member, str, HandedOut]]) -> bytes:
    names = [vary.name for vary in varied.variants.varies]
    lines = [[*map(field, (*COLUMNS, *names))]]
    for member, name, one in handed:
        values = varied.variants.values(one.variant.combination)
        student = member.student
        told = (member.number, student.name, student.email, one.variant.tag, name)
        lines.append([*map(field, told), *map(_value, values.values())])
    return BOM + "".join(f"{','.join(line)}\r\n" for line in lines).encode()


def _value(text: str) -> str:
    """Return a value as a field: a number stays one."""
    return text if _NUMBER.fullmatch(text) else field(text)
