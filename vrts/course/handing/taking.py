"""Takes hand-ins: one after another, written before they are acknowledged, mended at the start."""

import asyncio
import hashlib
import logging
from typing import Final, NamedTuple

from vrts.course.course import Assignment, Course
from vrts.course.facts import Facts, facts_of
from vrts.course.handing import deposit
from vrts.course.handing.deposit import HandIn
from vrts.course.handing.granted import Grant, Granted
from vrts.course.handing.names import folder_of, stamp_of, time_of, zone_of
from vrts.course.handing.standing import Refusal, Standing, standing
from vrts.course.variants.own_variants import OwnVariants, members_of
from vrts.live.store.course.attempts import (
    Attempt,
    add_attempts,
    all_attempts,
    attempts_of,
    keep_mark,
)
from vrts.live.store.course.people import Person, people, person_of
from vrts.live.store.database import Connection, Database
from vrts.pipeline.files import CannotRead

GONE: Final = "the file is not in the folder of the hand-ins any more"
NOT_LISTED: Final = Refusal(
    "role",
    "only students on the list of the course hand in",
    "ask your teacher to put you on the list",
)
TOO_SOON: Final = Refusal("limit", "you handed in just now", "wait a few seconds")
CHANGED: Final = "changed"
_log = logging.getLogger("vrts.live")


class Taken(NamedTuple):
    """What was handed in."""

    number: int  # of the attempt
    at: int  # Unix time [s]
    late: str  # what lateness costs, in words
    again: bool  # the last attempt is the same program: nothing was written


class Taking:
    """The one who writes hand-ins of a course."""

    def __init__(self, course: Course, database: Database, variants: OwnVariants) -> None:
        """Take a course, and who knows its variants; `mend` comes first."""
        self.course = course  # as its file is now
        self.variants = variants
        self._granted = Granted()
        self._database = database
        self._writing = asyncio.Lock()

    def assignment(self, id_: str) -> Assignment | None:
        """Return an assignment by its id."""
        return next((one for one in self.course.assignments if one.id == id_), None)

    def granted(self, assignment: Assignment, folder: str) -> Grant:
        """Return what was granted to somebody at the desk, by the name of their folder."""
        return self._granted.to(assignment, folder)

    def standing(self, facts: Facts, used: int, at: float, folder: str = "") -> Standing:
        """Return how an assignment stands for somebody.

        Args:
            facts: Of it.
            used: Attempts made.
            at: Unix time [s].
            folder: Name of the folder of their hand-ins; empty: nobody's in particular.
        """
        return standing(facts, used, at, due=self.granted(facts.assignment, folder).due)

    async def take(
        self, account: int, assignment: Assignment, program: bytes, at: float, seen: tuple[int, str]
    ) -> Taken | Refusal:
        """Write a program that somebody hands in; it is acknowledged when this returns.

        Args:
            account: Who hands in.
            assignment: At which.
            program: The bytes.
            at: Now, Unix time [s].
            seen: The number of the attempt and the words about lateness that were agreed to.

        Raises:
            OSError: Nothing could be written.
            CannotRead: The task is not there any more.
        """
        own = await self.variants.of(assignment, account)
        if own.problem:
            return Refusal("variants", own.problem)
        async with self._writing:
            facts = await asyncio.to_thread(facts_of, assignment)
            now = int(at)
            looked = await self._database.do(lambda c: _look(c, account, assignment))
            if looked is None:
                return NOT_LISTED
            members, before, latest = looked
            digest = hashlib.sha256(program).hexdigest()
            last = before[-1] if before else None
            if last is not None and last.digest == digest:
                return Taken(last.number, int(last.at), last.late, again=True)
            used = max((one.number for one in before), default=0)
            folder = folder_of(members[0].key, members[0].email)
            stands = await asyncio.to_thread(self.standing, facts, used, float(now), folder)
            if stands.refusal is not None:
                return stands.refusal
            if seen != (used + 1, stands.late):
                words = stands.late or "on time"
                text = f"this would be attempt {used + 1}, {words}: it was another a moment ago"
                return Refusal(CHANGED, text, "look again, and hand in once more")
            if latest >= now:  # folders of attempts are named by the second
                return TOO_SOON
            hand_in = HandIn(
                assignment.id,
                now,
                stamp_of(now, zone_of(facts)),
                account,
                tuple((one.account, folder_of(one.key, one.email)) for one in members),
                stands.late,
                program,
                own.tag,
            )
            pending = await asyncio.to_thread(deposit.begin, self.course.handed_in, hand_in)
            numbers = await self._finish(hand_in)
            await asyncio.to_thread(deposit.done, pending)
            return Taken(numbers[account], now, stands.late, again=False)

    async def mend(self) -> None:
        """Do what a crash has left undone, and make files and rows fit each other."""
        home = self.course.handed_in
        for path, hand_in in await asyncio.to_thread(lambda: list(deposit.unfinished(home))):
            await self._finish(hand_in)
            await asyncio.to_thread(deposit.done, path)
        for assignment in self.course.assignments:
            try:
                await self._fit(await asyncio.to_thread(facts_of, assignment))
            except CannotRead as problem:
                _log.warning("hand-ins of `%s`: %s", assignment.id, problem.message)

    async def program(self, facts: Facts, attempt: Attempt) -> bytes | None:
        """Return the program of an attempt; None: it is not as it was handed in, or gone."""
        person = await self._database.do(lambda c: person_of(c, attempt.account))
        if person is None:
            return None
        folder = folder_of(person.key, person.email)
        stamp = stamp_of(attempt.at, zone_of(facts))
        data = await asyncio.to_thread(
            deposit.program_of, self.course.handed_in, attempt.assignment, folder, stamp
        )
        same = data is not None and hashlib.sha256(data).hexdigest() == attempt.digest
        return data if same else None

    async def _finish(self, hand_in: HandIn) -> dict[int, int]:
        await asyncio.to_thread(deposit.place, self.course.handed_in, hand_in)

        def write(connection: Connection) -> dict[int, int]:
            there = {one.account for one in people(connection)}
            rows = [_row(hand_in, account) for account, _ in hand_in.people if account in there]
            return add_attempts(connection, rows, hand_in.assignment)

        return await self._database.do(write)

    async def _fit(self, facts: Facts) -> None:
        """Write rows of files without one; say of rows that wait for a file that is gone."""
        id_, home, zone = facts.assignment.id, self.course.handed_in, zone_of(facts)

        def look() -> dict[tuple[str, float], str]:
            return {
                (folder, at): hashlib.sha256(path.read_bytes()).hexdigest()
                for folder, stamp, path in deposit.found(home, id_)
                if (at := time_of(stamp, zone)) is not None
            }

        there = await asyncio.to_thread(look)
        known, rows = await self._database.do(
            lambda c: (
                {folder_of(one.key, one.email): one.account for one in people(c)},
                {(one.account, one.at) for one in all_attempts(c, id_)},
            )
        )
        new = {known[who] for who, at in there if who in known and (known[who], at) not in rows}
        own = {account: await self.variants.of(facts.assignment, account) for account in new}
        stands = await asyncio.to_thread(
            lambda: {one: self.standing(facts, 0, one[1], one[0]).late for one in there}
        )

        def fit(connection: Connection) -> None:
            files = {
                (known[folder], at): (digest, stands[folder, at])
                for (folder, at), digest in there.items()
                if folder in known
            }
            rows = {(one.account, one.at): one for one in all_attempts(connection, id_)}
            for (account, at), (digest, late) in sorted(files.items(), key=lambda one: one[0][1]):
                if (account, at) not in rows:
                    row = Attempt(account, id_, 0, at, account, digest, "waiting")
                    tag = own[account].tag if account in own else ""
                    add_attempts(connection, [row._replace(late=late, variant=tag)], id_)
            for (account, at), row in rows.items():
                if row.state == "waiting" and (account, at) not in files:
                    keep_mark(connection, row._replace(state="failed", said=GONE))

        await self._database.do(fit)


def _row(hand_in: HandIn, account: int) -> Attempt:
    return Attempt(
        account,
        hand_in.assignment,
        0,
        float(hand_in.at),
        hand_in.by,
        hand_in.digest,
        "waiting",
        late=hand_in.late,
        variant=hand_in.variant,
    )


def _look(
    connection: Connection, account: int, assignment: Assignment
) -> tuple[list[Person], list[Attempt], float] | None:
    """Return for whom somebody hands in, what they have handed in, and when any of them did last.

    None: they may not hand in.
    """
    members = list(members_of(connection, account, assignment))
    if not members:
        return None
    every = [attempts_of(connection, one.account, assignment.id) for one in members]
    latest = max((one.at for own in every for one in own), default=0.0)
    return members, every[0], latest
