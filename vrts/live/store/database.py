"""The SQLite file and the one thread that uses it.

What is done together is committed together: the thread takes all jobs that wait, does each in a
savepoint, and commits once. A job is acknowledged after that, so a killed server loses nothing that
it has acknowledged. What goes wrong in a job, whatever it is, reaches the one who waits for it; the
thread goes on.
"""

import asyncio
import os
import sqlite3
import threading
from collections.abc import Callable, Generator
from concurrent.futures import Future
from contextlib import contextmanager
from pathlib import Path
from queue import SimpleQueue
from types import TracebackType
from typing import Any, TypeVar

from vrts.live.store.migrations import STEPS, NotMigrated, migrate, version_of
from vrts.live.store.seals.connection import SealedConnection
from vrts.live.store.seals.sealing import Seals, seals_for
from vrts.live.store.unusable import require_ours

Answer = TypeVar("Answer")
Connection = sqlite3.Connection
Failed = sqlite3.Error  # of the file or the machine, such as a full disk
Job = Callable[[sqlite3.Connection], Any]

_MAGIC = b"SQLite format 3\0"
_TOGETHER = 200  # jobs of one commit


def opened(path: Path) -> SealedConnection:
    """Open a database, readable by its owner only, with the present tables.

    One of before is copied beside it, with its version in the name, before it is changed.

    Raises:
        CannotRead: It is none of vrts, and was not touched.
        TooNew: It was written by a later vrts, and was not touched.
        NotMigrated: It could not be changed, and is as it was.
    """
    require_ours(path)
    os.close(os.open(path, os.O_CREAT | os.O_RDWR, 0o600))
    connection = sqlite3.connect(
        path, isolation_level=None, check_same_thread=False, factory=SealedConnection
    )
    connection.execute("PRAGMA journal_mode=WAL")
    connection.execute("PRAGMA synchronous=NORMAL")
    connection.execute("PRAGMA foreign_keys=ON")
    connection.execute("PRAGMA busy_timeout=5000")
    connection.execute("PRAGMA secure_delete=ON")  # what is purged is overwritten
    try:
        bring_up_to_date(connection, path)
    except BaseException:
        connection.close()
        raise
    return connection


def bring_up_to_date(
    connection: sqlite3.Connection, path: Path, steps: tuple[str, ...] = STEPS
) -> None:
    """Give a database the present tables; one of before is copied beside it first.

    Raises:
        TooNew: It was written by a later vrts.
        NotMigrated: It could not be changed, and is as it was.
    """
    version = version_of(connection)
    kept = ""
    if 0 < version < len(steps):
        copy = copy_of_before(path, version)
        backup(path, copy)
        kept = f", and a copy of it is in `{copy}`"
    try:
        migrate(connection, steps)
    except NotMigrated as problem:
        raise NotMigrated(f"{problem}{kept}") from problem


def copy_of_before(path: Path, version: int) -> Path:
    """Return where a database of a version is copied before it is changed."""
    return path.with_name(f"{path.stem}.version-{version}{path.suffix}")


def is_database(path: Path) -> bool:
    """Return whether a file is a SQLite database."""
    with path.open("rb") as file:
        return file.read(len(_MAGIC)) == _MAGIC


@contextmanager
def read_only(path: Path) -> Generator[sqlite3.Connection]:
    """Open a database to read, while a server uses it or not; nothing is changed.

    Raises:
        ValueError: It is none that this version can read.
    """
    try:
        connection = sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", uri=True)
        try:
            (version,) = connection.execute("PRAGMA user_version").fetchone()
            if not 0 < version <= len(STEPS):
                raise ValueError("it is no database of this version of vrts")
            yield connection
        finally:
            connection.close()
    except sqlite3.Error as problem:
        raise ValueError(str(problem)) from problem


def backup(path: Path, target: Path) -> None:
    """Copy a database while a server uses it; the copy is of one moment, and whole."""
    part = target.with_name(target.name + ".part")
    os.close(os.open(part, os.O_CREAT | os.O_TRUNC | os.O_RDWR, 0o600))
    source = sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", uri=True)
    try:
        copy = sqlite3.connect(part)
        try:
            source.backup(
                copy, pages=-1
            )  # in one go: it begins again whenever something is written
        finally:
            copy.close()
    finally:
        source.close()
    part.replace(target)


class Database:
    """Does jobs one after another in a thread of its own."""

    def __init__(self, path: Path, key: Path | None = None, *, signs: bool = False) -> None:
        """Open the file and start the thread.

        Args:
            path: Of the database.
            key: File with the key of the logs, if not the usual one.
            signs: Whether logs are signed.

        Raises:
            CannotRead: There is no key that fits.
        """
        self.path = path
        self._connection = opened(path)
        self.seals: Seals | None = None
        if signs:
            try:
                self.seals = seals_for(path, key, self._connection)
                self.seals.attach(self._connection)
            except BaseException:
                self._connection.close()
                raise
        self._jobs: SimpleQueue[tuple[Job, Future[Any]] | None] = SimpleQueue()
        self._thread = threading.Thread(target=self._work, name="database", daemon=True)
        self._thread.start()

    def submit(self, job: Callable[[sqlite3.Connection], Answer]) -> "Future[Answer]":
        """Have a job done; the future is fulfilled after the commit.

        What the job raises is raised where the future is waited for, whatever it is.
        """
        future: Future[Answer] = Future()
        self._jobs.put((job, future))
        if not self._thread.is_alive():  # nobody may wait for ever
            self._give_up()
        return future

    async def do(self, job: Callable[[sqlite3.Connection], Answer]) -> Answer:
        """Have a job done and committed, and return its answer."""
        return await asyncio.wrap_future(self.submit(job))

    def close(self) -> None:
        """Finish what waits, and close the file."""
        self._jobs.put(None)
        self._thread.join()
        if self.seals is not None:
            self.seals.remember(self._connection, at_once=True)
        self._connection.close()

    def _work(self) -> None:
        try:
            while (first := self._jobs.get()) is not None:
                together = [first]
                while len(together) < _TOGETHER and not self._jobs.empty():
                    following = self._jobs.get()
                    if following is None:
                        self._jobs.put(None)
                        break
                    together.append(following)
                waiting = [one for one in together if one[1].set_running_or_notify_cancel()]
                with _PassedOn(*(future for _, future in waiting)):
                    self._do(waiting)
        finally:
            self._give_up()

    def _give_up(self) -> None:
        """Tell those who wait that nothing is done any more."""
        while not self._jobs.empty():
            left = self._jobs.get()
            if left is not None:
                left[1].set_exception(sqlite3.ProgrammingError("the database is closed"))

    def _do(self, together: list[tuple[Job, "Future[Any]"]]) -> None:
        connection = self._connection
        done: list[tuple[Future[Any], Any]] = []
        try:
            connection.execute("BEGIN IMMEDIATE")
            connection.touched.clear()
            for job, future in together:
                connection.execute("SAVEPOINT job")
                with _PassedOn(future):
                    done.append((future, job(connection)))
                if future.done():  # it failed
                    connection.execute("ROLLBACK TO job")
                connection.execute("RELEASE job")
            if self.seals is not None:
                self.seals.seal(connection)
            connection.execute("COMMIT")
        finally:
            if connection.in_transaction:  # such as with a full disk: nothing is acknowledged
                connection.execute("ROLLBACK")
        for future, answer in done:
            future.set_result(answer)
        if self.seals is not None:
            self.seals.remember(connection)


class _PassedOn:
    """Has an exception raised where futures are waited for, instead of in the thread."""

    def __init__(self, *futures: "Future[Any]") -> None:
        """Take the futures; those that are done already stay as they are."""
        self._futures = futures

    def __enter__(self) -> None:
        """Begin."""

    def __exit__(
        self,
        kind: type[BaseException] | None,
        problem: BaseException | None,
        trace: TracebackType | None,
    ) -> bool:
        """Pass an exception on, if there is one; what is to end the thread ends it all the same."""
        if problem is None:
            return False
        for future in self._futures:
            if not future.done():
                future.set_exception(problem)
        return isinstance(problem, Exception)
