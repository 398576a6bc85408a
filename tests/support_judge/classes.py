"""Classes of 300 with ten copies, without any, and with copies of last year's programs."""

import json
from collections.abc import Sequence
from pathlib import Path
from random import Random
from typing import NamedTuple

from tests.support_judge.deciding import Advice, Mind
from tests.support_judge.disguises import DISGUISES, new_layout
from tests.support_judge.layout import Layout, written
from tests.support_judge.people import FAMILIES, NAMES, some_person
from tests.support_judge.slips import with_slip
from tests.support_judge.source import Source, loops
from tests.support_judge.writing import CANS, PROJECT, Assignment, written_by

STUDENTS, SECTIONS, COPIES = 300, 12, 10
TASKS = {one.name: one for one in (CANS, PROJECT)}
SINGLE = tuple((name,) for name in DISGUISES)


class HandIn(NamedTuple):
    """What somebody hands in, and all that was decided on the way."""

    id: str
    source: Source
    layout: Layout
    decided: dict[str, str]


class Copy(NamedTuple):
    """A planted copy: of whom, and how it was disguised."""

    id: str
    of: str
    how: tuple[str, ...]


class Class(NamedTuple):
    """All that a class handed in, and what is true of it."""

    hand_ins: tuple[HandIn, ...]
    copies: tuple[Copy, ...]
    partners: tuple[tuple[str, str], ...]  # who talked with whom, and wrote alone

    def write(self, folder: Path) -> None:
        """Write a file for each, and beside the folder what is true."""
        folder.mkdir(parents=True)
        for one in self.hand_ins:
            (folder / f"{one.id}.v2").write_text(written(one.source, one.layout), "utf-8")
        told = {"copies": [one._asdict() for one in self.copies], "partners": self.partners}
        folder.with_name(folder.name + "-truth.json").write_text(
            json.dumps(told, indent=1), "utf-8"
        )


def a_class(task: Assignment, seed: int, copies: int = 0, earlier: Class | None = None) -> Class:
    """Return a class; its copies are of its own people, or of those of an earlier year."""
    rng = Random(f"{task.name} {seed} {copies} {earlier is not None}")
    ids = [f"h{number}" for number in rng.sample(range(1000, 10000), STUDENTS)]
    honest, partners = _honest(rng, task, ids[: STUDENTS - copies])
    sources = list(honest) if earlier is None else list(earlier.hand_ins)
    planted: list[HandIn] = []
    told: list[Copy] = []
    for new, how in zip(ids[STUDENTS - copies :], _ways(rng, copies), strict=True):
        fitting = [one for one in sources if _fits(one.source, how)]
        source = rng.choice(fitting)
        sources.remove(source)
        planted.append(_copied(rng, source, new, how))
        told.append(Copy(new, source.id, how))
    hand_ins = sorted((*honest, *planted), key=lambda one: one.id)
    return Class(tuple(hand_ins), tuple(told), tuple(partners))


def _honest(
    rng: Random, task: Assignment, ids: Sequence[str]
) -> tuple[list[HandIn], list[tuple[str, str]]]:
    sections = [_advice(rng, task) for _ in range(SECTIONS)]
    out: list[HandIn] = []
    partners: list[tuple[str, str]] = []
    talked: dict[str, Advice] = {}
    for at, one in enumerate(ids):
        advice = sections[at * SECTIONS // len(ids)]
        hand_in = _hand_in(rng, task, one, advice, talked.get(one, {}))
        out.append(hand_in)
        if one not in talked and at + 1 < len(ids) and rng.random() < 0.16:
            # they sit side by side: one plan, and some numbers said aloud; each writes alone
            talked[ids[at + 1]] = _said(rng, hand_in.decided)
            partners.append((one, ids[at + 1]))
    return out, partners


def _hand_in(rng: Random, task: Assignment, who: str, advice: Advice, talked: Advice) -> HandIn:
    lecture: Advice = task.lecture if rng.random() < 0.55 else {}
    person = some_person(rng)
    mind = Mind(rng, lecture, advice, talked)
    source = with_slip(mind, written_by(mind, person, task))
    mind.note("names", person.words)
    return HandIn(who, source, person.layout, mind.decided)


def _advice(rng: Random, task: Assignment) -> Advice:
    """Return what the tutor of a section tells everybody: what another person once decided."""
    mind = Mind(rng, task.lecture, {}, {})
    written_by(mind, some_person(rng), task)
    keys = [key for key in mind.decided if not key.startswith(("name", "place"))]
    return {key: mind.decided[key] for key in rng.sample(keys, 4)}


def _said(rng: Random, decided: dict[str, str]) -> Advice:
    said = {
        key: value
        for key, value in decided.items()
        if not key.startswith(("name", "place", "slip", "head"))
    }
    return {
        key: value
        for key, value in said.items()
        if key == "plan" or rng.random() < (0.35 if key.startswith("n ") else 0.5)
    }


def _ways(rng: Random, copies: int) -> list[tuple[str, ...]]:
    if copies == 0:
        return []
    names = list(DISGUISES)
    more = [
        ("rename", "shift"),
        ("reorder steps", "filler", "rename"),
        ("split", "rename", "shift"),
    ]
    random = [tuple(rng.sample(names, rng.choice((2, 3)))) for _ in range(3)]
    return [*SINGLE, *(rng.choice((a, b)) for a, b in zip(more, random, strict=True))][:copies]


def _fits(source: Source, how: tuple[str, ...]) -> bool:
    """Return whether a program can be disguised so: it needs a loop, or several programs."""
    found = [loop for one in source.programs for loop in loops(one.body)]
    if "for to while" in how and not any(one.kind == "FOR" for one in found):
        return False
    return "reorder programs" not in how or len(source.programs) > 1


def _copied(rng: Random, source: HandIn, who: str, how: tuple[str, ...]) -> HandIn:
    out = source.source
    for name in how:
        out = DISGUISES[name](rng, out)
    head = tuple(
        f"{rng.choice(NAMES)} {rng.choice(FAMILIES)}" if line.count(" ") == 1 else line
        for line in out.head
    )
    return HandIn(who, out._replace(head=head), new_layout(rng, source.layout, how), source.decided)
