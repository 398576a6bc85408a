"""A course with hand-ins as its database holds them: many students, assignments, attempts."""

import hashlib
from contextlib import closing
from pathlib import Path
from random import Random

from vrts.live.settings import DATABASE
from vrts.live.store.accounts import add_account
from vrts.live.store.course.attempts import Attempt, Loss, add_attempt, keep_mark
from vrts.live.store.course.people import Person, keep_person
from vrts.live.store.database import Connection, opened

NOON = 1_795_780_800.0  # Unix time [s]
CAUSES = (
    ("at 3.2 s, line 14 `MOVE p2`, the hand hits `base1`", "2"),
    ("`can1` rests 21 mm from its place; at most 10 mm are allowed", "3"),
    ("`can2` was never picked up", "2.5"),
    ("at 7.9 s, line 22 `MOVES p5`, joint 3 is faster than it can be", "1"),
    ("it takes 31.4 s; 25 s are asked for", "0.5"),
)
GIVEN = ("Ada", "Bo", "Chen", "Dana", "Emre", "Finn", "Grace", "Hana", "Ivo", "Jun")
FAMILY = ("Ahlgren", "Baumann", "Castro", "Dvořák", "Eriksen", "Fischer", "Greco", "Horvat")


def write_course(folder: Path, assignments: int = 1) -> Path:
    """Write a course that guests may visit; return its folder."""
    lines = ['[course]\ntitle = "Robotics 2026"\nguests = true\nrooms = ["Class"]\n']
    for number in range(1, assignments + 1):
        task = folder / "tasks" / f"pick-{number}"
        task.mkdir(parents=True)
        task.joinpath("task.toml").write_text(
            f'[task]\ntitle = "Pick and place {number}"\nscene = "cans-on-bases"\n'
            '[[goal]]\nobject = "can1"\non = "base1"\n'
            f"[late]\ndue = 2026-11-{number + 10:02d}T12:00:00+01:00\nper_day = 1\n",
            encoding="utf-8",
        )
        lines.append(f'[[assignment]]\ntask = "tasks/pick-{number}"\n')
    folder.joinpath("course.toml").write_text("\n".join(lines), encoding="utf-8")
    return folder


def fill(folder: Path, students: int, assignments: int, most: int = 6, seed: int = 1) -> list[int]:
    """Write students and their attempts into the database of a server; return their accounts.

    Args:
        folder: Of the server.
        students: How many.
        assignments: The first of so many that `write_course` writes; the last are not begun by all.
        most: Attempts of a student at an assignment at most.
        seed: Of all that is by chance.
    """
    chance = Random(seed)
    accounts: list[int] = []
    folder.mkdir(parents=True, exist_ok=True)
    with closing(opened(folder / DATABASE)) as connection:
        connection.execute("BEGIN")
        for number in range(students):
            name = f"{chance.choice(GIVEN)} {chance.choice(FAMILY)} {number}"
            email = f"s{number:04d}@example.org"
            account = add_account(connection, name, NOON, password="x").id
            ids = {"moodle": str(9000 + number)}
            team = f"Team {number // 3 + 1}"
            keep_person(connection, Person(account, name, email, email, ids, "student", team))
            accounts.append(account)
            for one in range(1, assignments + 1):
                if chance.random() < 0.9 - 0.06 * one:
                    _attempts(connection, account, f"pick-{one}", chance.randint(1, most), chance)
        connection.execute("COMMIT")
    return accounts


def _attempts(
    connection: Connection, account: int, assignment: str, count: int, chance: Random
) -> None:
    left = [cause for cause in CAUSES if chance.random() < 0.6]
    for k in range(count):
        at = NOON + 3600.0 * k + chance.random() * 1e6
        digest = hashlib.sha256(f"{account} {assignment} {k}".encode()).hexdigest()
        number = add_attempt(connection, account, assignment, at, account, digest)
        if k and left and chance.random() < 0.4:
            left.pop()
        if k == count - 1 and chance.random() < 0.03:
            continue  # still to be marked
        causes = tuple(Loss(*cause) for cause in left)
        mark = 10.0 - sum(float(points) for _, points in left)
        late = "2 h 10 min late: 1 point" if chance.random() < 0.08 else ""
        keep_mark(
            connection,
            Attempt(
                account,
                assignment,
                number,
                at,
                account,
                digest,
                "marked",
                str(mark),
                "10",
                late,
                causes,
            ),
        )
