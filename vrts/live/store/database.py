"""The SQLite file and the one thread that uses it.

What is done together is committed together: the thread takes all jobs that wait, does each in a
savepoint, and commits once. A job is acknowledged after that, so a killed server loses nothing that
it has acknowledged.
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
from typing import Any, TypeVar

from vrts.live.store.migrations import STEPS, migrate

Answer = TypeVar("Answer")
Connection = sqlite3.Connection
Job = Callable[[sqlite3.Connection], Any]

_MAGIC = b"SQLite format 3\0"
_TOGETHER = 200  # jobs of one commit


def opened(path: Path) -> sqlite3.Connection:
    """Open a database, readable by its owner only, with the present tables."""
    os.close(os.open(path, os.O_CREAT | os.O_RDWR, 0o600))
    connection = sqlite3.connect(path, isolation_level=None, check_same_thread=False)
    connection.execute("PRAGMA journal_mode=WAL")
    connection.execute("PRAGMA synchronous=NORMAL")
    connection.execute("PRAGMA foreign_keys=ON")
    connection.execute("PRAGMA busy_timeout=5000")
    connection.execute("PRAGMA secure_delete=ON")  # what is purged is overwritten
    migrate(connection)
    return connection


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
            source.backup(copy, pages=500, sleep=0.01)
        finally:
            copy.close()
    finally:
        source.close()
    part.replace(target)


class Database:
    """Does jobs one after another in a thread of its own."""

    def __init__(self, path: Path) -> None:
        """Open the file and start the thread."""
        self.path = path
        self._connection = opened(path)
        self._jobs: SimpleQueue[tuple[Job, Future[Any]] | None] = SimpleQueue()
        self._thread = threading.Thread(target=self._work, name="database", daemon=True)
        self._thread.start()

    def submit(self, job: Callable[[sqlite3.Connection], Answer]) -> "Future[Answer]":
        """Have a job done; the future is fulfilled after the commit."""
        future: Future[Answer] = Future()
        self._jobs.put((job, future))
        return future

    async def do(self, job: Callable[[sqlite3.Connection], Answer]) -> Answer:
        """Have a job done and committed, and return its answer."""
        return await asyncio.wrap_future(self.submit(job))

    def close(self) -> None:
        """Finish what waits, and close the file."""
        self._jobs.put(None)
        self._thread.join()
        self._connection.close()

    def _work(self) -> None:
        while True:
            first = self._jobs.get()
            if first is None:
                return
            together = [first]
            last = False
            while len(together) < _TOGETHER and not self._jobs.empty():
                job = self._jobs.get()
                if job is None:
                    last = True
                    break
                together.append(job)
            self._do(together)
            if last:
                return

    def _do(self, together: list[tuple[Job, "Future[Any]"]]) -> None:
        connection = self._connection
        done: list[tuple[Future[Any], Any]] = []
        try:
            connection.execute("BEGIN IMMEDIATE")
            for job, future in together:
                connection.execute("SAVEPOINT job")
                try:
                    answer = job(connection)
                except (sqlite3.Error, ValueError, LookupError) as problem:
                    connection.execute("ROLLBACK TO job")
                    future.set_exception(problem)
                else:
                    done.append((future, answer))
                connection.execute("RELEASE job")
            connection.execute("COMMIT")
        except sqlite3.Error as problem:  # such as a full disk: nothing of it is acknowledged
            if connection.in_transaction:
                connection.execute("ROLLBACK")
            for _, future in together:
                if not future.done():
                    future.set_exception(problem)
            return
        for future, answer in done:
            future.set_result(answer)
