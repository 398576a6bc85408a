"""A class that was marked, as files: for the desk, without marking anything.

Rows, programs and reports are made up; who handed in which program is true, so that marking again
finds it. Decisions of two graders, contradictions, unsafe marks and likeness can be written too.
"""

from collections.abc import Sequence
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path
from random import Random

import msgspec
from msgspec.structs import replace

from tests.places import ROOT
from tests.support_rows import failed, plain_result
from vrts.marking.about import About
from vrts.marking.by_hand.decisions import records
from vrts.marking.class_files import write_class
from vrts.marking.layout import COMPARED, RESULT, Layout, write_atomically
from vrts.marking.result import Kind, Loss, Metrics, Program, Result, to_bytes
from vrts.marking.row import Class, HandedIn, Lateness, Row, Student, row_of
from vrts.marking.similarity.files import DATA, PAGE
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.report_files import REPORT
from vrts.marking.submission.setting import Place

TITLE = "Cans on bases, group 3"
TASK = ROOT / "examples" / "01-cans-on-bases" / "task.toml"
SOURCE = ROOT / "examples" / "01-cans-on-bases" / "submissions" / "hits-base.v2"
FIRST = ("Anna", "Ben", "Çelik", "Daria", "Eva-Maria", "李", "Femi", "Gül", "Hana", "Iván")
LAST = ("Ady", "Bär", "Ömer", "Dudek", "von der Heide", "小龍", "Okoye", "Şahin", "Novák", "Ruiz")
HOSTILE = '<script>alert(1)</script> "quoted" & </textarea>'
WHEN = datetime(2026, 11, 20, 12, 0, tzinfo=UTC)

HITS = Loss(
    1.5,
    "3/2",
    "contact",
    "at 12.4 s, line 17 `MOVES base2_put`, the held `can1` hits `base1`",
    "what the hand holds reaches below the fingers",
    17,
    12.4,
)
MISSES = Loss(
    2.1,
    "21/10",
    "target",
    "at 9.3 s, line 21 `OPENI`, `can2` is 23 mm from its goal",
    "compare the location with the object's in `vrts scene show`",
    21,
    9.3,
)
SLOW = Loss(0.5, "1/2", "time", "the program takes 31.2 s", None, None, None)
LOSSES = ((HITS,), (MISSES,), (HITS, SLOW), (SLOW,), ())


def write_desk_class(
    root: Path, count: int = 12, *, decisions: bool = True, hostile: bool = False, seed: int = 7
) -> Layout:
    """Write the output of a marking of so many students, and return where it is.

    Args:
        root: Folder; `root/out` is the output, `root/handed-in` what was marked.
        count: Rows.
        decisions: Whether two graders have been at work already.
        hostile: Whether the first row has HTML in its name, its program and its cause.
        seed: Of everything that is drawn.
    """
    layout = Layout(root / "out")
    programs = root / "handed-in"
    programs.mkdir(parents=True)
    draw = Random(seed)
    text = SOURCE.read_text(encoding="utf-8")
    rows: list[Row] = []
    for k in range(count):
        told = HOSTILE if hostile and k == 0 else f"submission {k}"
        data = f"; {told}\n{text}".encode()
        row = _row(k, draw, data, told if hostile and k == 0 else "")
        if row.result.program is not None:
            (programs / f"{row.id}.v2").write_bytes(data)
        rows.append(row)
        page = f"<!doctype html><title>{row.id}</title><p>a report".encode()
        for home in (layout.student(row.id), layout.grader(row.id)):
            write_atomically(home / RESULT, to_bytes(row.result))
            if row.result.program is not None:
                write_atomically(home / REPORT, page)
    write_likeness(layout, [row.id for row in rows if row.result.program is not None])
    write_class(Class("vrts.class/1", TITLE, tuple(rows)), about_of(programs), layout)
    if decisions:
        write_decisions(layout, [row.id for row in rows])
    return layout


def about_of(programs: Path) -> About:
    """Return a marking of a folder that has ended."""
    return About(
        "vrts.marking/1",
        TITLE,
        Place(str(TASK)),
        (str(programs),),
        Wanted(),
        "0.1",
        ("vrts", "grade", str(TASK), str(programs), "-o", "out"),
        WHEN,
        begun=WHEN,
    )


def write_likeness(layout: Layout, names: Sequence[str]) -> None:
    """Write which programs are alike, as vrts did at first: two pairs, no groups."""
    pairs = [
        {"first": first, "second": second, "score": 0.9 - 0.1 * k, "code": 0.8, "taught": 0.2}
        for k, (first, second) in enumerate(zip(names[0:4:2], names[1:4:2], strict=False))
    ]
    ranking = {"schema": "vrts.similarity/1", "compared": len(names), "pairs": pairs}
    write_atomically(layout.staff / DATA, msgspec.json.encode(ranking))
    write_atomically(layout.staff / PAGE, b"<!doctype html><title>Similar programs</title>")
    pair = b"<!doctype html><title>Two programs</title>"
    write_atomically(layout.staff / COMPARED / "pair-001.html", pair)


def write_decisions(layout: Layout, names: Sequence[str]) -> None:
    """Write what two graders decided: an item, comments, assigned rows, and a contradiction."""
    at = "2026-11-21T09:00:00+01:00"
    half = len(names) // 2
    write_grader(
        layout,
        "huber",
        "R. Huber",
        [
            records.Item(1, at, "grip", "The grip is not checked", "-1/2"),
            records.Give(2, at, "grip", tuple(names[:3]), line=17),
            records.Comment(3, at, names[0], "Well laid out.", line=4),
            records.Comment(4, at, names[0], "Ask about this in the lab.", private=True),
            records.Assign(5, at, tuple(names[:half]), ("huber",)),
            records.Assign(6, at, tuple(names[half:]), ("huber", "mayr")),
            records.ChangeMark(7, at, (names[1],), "the table was moved", delta="1"),
            records.Finish(8, at, names[-1], "8"),
        ],
    )
    write_grader(
        layout,
        "mayr",
        "S. Mayr",
        [
            records.ChangeMark(1, at, (names[1],), "marked from paper", mark="6"),
            records.Finish(2, at, names[-1], "7"),
            records.Excuse(3, at, (names[-2],), "ill, with a certificate"),
        ],
    )


def write_grader(layout: Layout, who: str, name: str, said: Sequence[records.Decision]) -> Path:
    """Write the file of one grader."""
    lines = [records.Beginning(records.SCHEMA, who, name), *said]
    place = layout.staff / "decisions" / f"{who}.jsonl"
    write_atomically(place, b"".join(msgspec.json.encode(line) + b"\n" for line in lines))
    return place


def _row(k: int, draw: Random, data: bytes, told: str) -> Row:
    name = told or f"{FIRST[k % len(FIRST)]} {LAST[(k // len(FIRST) + k) % len(LAST)]}"
    program = Program(f"s{k:04d}.v2", sha256(data).hexdigest(), len(data))
    result = replace(plain_result(f"s{k:04d}"), program=program)
    result = _drawn(k, result, draw)
    if told:
        result = replace(result, cause=told)
    late = Lateness(90_000, "1/2", "1 day 1 h late: 0.5 points less") if k % 9 == 4 else None
    file = "" if result.program is None else program.name
    student = Student(name, f"s{k}@example.org", f"login{k}")
    return row_of(result, student, HandedIn(file, "the only file", WHEN.isoformat()), late)


def _drawn(k: int, result: Result, draw: Random) -> Result:
    if k % 11 == 7:
        cause = "nothing was handed in"
        nothing = replace(result, kind=Kind.MISSING, mark=None, ready=False, checks=())
        return replace(nothing, program=None, cause=cause, metrics=Metrics())
    if k % 11 == 8:
        words = "the process was ended: it took more than 2 GB of memory"
        lost = replace(result, kind=Kind.RESOURCE, mark=None, ready=False, checks=(), cause=words)
        return replace(lost, review=(words,), metrics=Metrics())
    losses = draw.choice(LOSSES)
    mark = round(10.0 - sum(loss.points for loss in losses), 1)
    wrong = [
        name for name, loss in (("target can2", MISSES), ("collision", HITS)) if loss in losses
    ]
    if not losses:
        return result
    first = losses[0]
    changed = replace(
        result,
        mark=mark,
        ready=False,
        cause=f"{first.sentence} (−{first.points})",
        hint=first.hint,
        line=first.line,
        time_s=first.time_s,
        losses=losses,
        checks=failed(result, *wrong),
    )
    if k % 11 == 5:
        lowest = round(mark - 1.5, 1)
        return replace(changed, lowest=lowest, review=("left finger and can1: too close to call",))
    return changed
