"""Whole classes: students who wrote alone, and some who did not."""

from dataclasses import dataclass, field
from pathlib import Path
from random import Random

from tests.support_likeness.copying.copies import CHAIN, EARLIER, copied
from tests.support_likeness.copying.sheets import Sheet
from tests.support_likeness.marking import mark
from tests.support_likeness.scenes import JOBS
from tests.support_likeness.students.authors import author
from tests.support_likeness.students.slips import broken, skill, slip
from tests.support_likeness.students.teaching import without_unused
from tests.support_likeness.students.writing import Writer
from tests.support_likeness.students.years import YEARS

ENOUGH = 6.0  # [points] of what anybody would copy


@dataclass(frozen=True)
class Planted:
    """Programs of which one was copied from another."""

    kind: str
    members: tuple[str, ...]  # ids; the first is the source; `NAME/id` of an earlier year
    changes: tuple[str, ...]


@dataclass
class Student:
    """What somebody handed in."""

    identifier: str
    sheet: Sheet
    text: str
    own: bool  # whether more than the text's and the lecture's is in it
    skill: str


@dataclass
class Class:
    """A class, by identifier."""

    job: str
    year: int
    students: dict[str, Student] = field(default_factory=dict[str, Student])
    planted: list[Planted] = field(default_factory=list[Planted])

    @property
    def texts(self) -> dict[str, str]:
        """The programs as files."""
        return {name: one.text for name, one in sorted(self.students.items())}

    def written(self, folder: Path) -> Path:
        """Write a file for each student, and return the folder."""
        folder.mkdir(parents=True)
        for name, text in self.texts.items():
            (folder / f"{name}.v2").write_text(text, encoding="utf-8")
        return folder


def alone(job: str, year: int, seed: object, identifier: str) -> Student:
    """Return a student who wrote alone."""
    key = f"{job} {year} {seed}"
    draw = Random(f"student {key}")
    habits = author(key)
    writer = Writer(habits, JOBS[job], YEARS[year - 1], key)
    program = writer.program()
    level = skill(draw)
    slip(program, JOBS[job], level, draw)
    without_unused(program) if draw.random() < 0.5 else None
    sheet = Sheet(program, habits.layout)
    own = writer.shape != "lecture" and not habits.follows
    text = broken(sheet.text(), draw) if level == "breaks" else sheet.text()
    return Student(identifier, sheet, text, own, level)


def honest(job: str, year: int, size: int, seed: object) -> Class:
    """Return a class in which nobody copied."""
    order = list(range(1, size + 1))
    Random(f"ids {job} {year} {seed}").shuffle(order)
    found = Class(job, year)
    for k, number in enumerate(order):
        name = f"y{year}s{number:04d}"
        found.students[name] = alone(job, year, f"{seed}/{k}", name)
    return found


def with_copies(
    whole: Class,
    kinds: tuple[str, ...],
    seed: object,
    *,
    deep: bool = False,
    earlier: Class | None = None,
    corpus: str = "",
) -> Class:
    """Let some of a class copy: each kind once, from a source of its own.

    What they would have written themselves is lost. A kind that no source of the class allows, as
    other loops where nobody has any, is left out.
    """
    draw = Random(f"plants {seed}")
    names = list(whole.students)
    draw.shuffle(names)
    victims = [name for name in names if whole.students[name].skill != "good"]
    sources = [name for name in names if _worth_copying(whole.students[name])]
    for kind in kinds:
        if kind == EARLIER:
            assert earlier is not None
            old = sorted(name for name, one in earlier.students.items() if _worth_copying(one))
            draw.shuffle(old)
            _plant(whole, kind, victims, [f"{corpus}/{one}" for one in old], earlier, seed, deep)
        else:
            _plant(whole, kind, victims, sources, whole, seed, deep)
    return whole


def _worth_copying(one: Student) -> bool:
    return one.skill in ("good", "slips") and one.own


def _plant(
    whole: Class,
    kind: str,
    victims: list[str],
    sources: list[str],
    origin: Class,
    seed: object,
    deep: bool,
) -> None:
    job = JOBS[whole.job]
    for source in list(sources):
        student = origin.students[source.rpartition("/")[2]]
        if student.identifier in victims or student.skill == "copied":
            continue
        if mark(student.text, job).points < ENOUGH:
            continue
        members, changes, sheet = [source], list[str](), student.sheet
        for link in range(Random(f"{seed}{kind}").choice((2, 3)) if kind == CHAIN else 1):
            copy = copied(sheet, kind, job, f"{seed} {source} {kind} {link}", deep=deep)
            if copy is None:
                break
            members.append(victims[-1 - link])
            changes.append("+".join(copy.changes))
            sheet = copy.sheet
            victim = whole.students[members[-1]]
            victim.sheet, victim.text, victim.skill = sheet, sheet.text(), "copied"
        else:
            sources.remove(source)
            del victims[1 - len(members) :]
            whole.planted.append(Planted(kind, tuple(members), tuple(changes)))
            return
