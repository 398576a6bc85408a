"""Marking again beside the desk: one at a time, in a process of its own, with its progress."""

import os
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from pathlib import Path

import msgspec

from vrts.desk.again.asked import again
from vrts.desk.again.going_on import goes_on, taken_for_marking
from vrts.desk.again.spoken import LONGEST, Asked, Said
from vrts.desk.book.opened import Opened
from vrts.desk.told import MarkingTold

DIED = "the process that marked ended too early: mark again, what is there stays"
NOT_ENDED = "a marking has begun here and not ended: what is shown is of before; mark again"


class Marking:
    """The one marking of a desk. Any thread may ask."""

    def __init__(self, folder: Path, changed: Callable[[], None] = lambda: None) -> None:
        """Take a folder.

        Args:
            folder: The output of a marking.
            changed: Called from another thread whenever there is something to tell.
        """
        self._folder = folder
        self.changed = changed
        self._lock = threading.Lock()
        self._process: subprocess.Popen[bytes] | None = None
        self._told = MarkingTold()

    def told(self, opened: Opened) -> MarkingTold:
        """Return how far it is; also of what another desk, or `vrts grade`, marks here."""
        with self._lock:
            if self._process is not None or self._told.problem is not None:
                return self._told
        if opened.about.finished is not None:
            return self._told
        if goes_on(self._folder):
            return MarkingTold(True)
        return MarkingTold(problem=NOT_ENDED)

    def begin(self, opened: Opened, students: Sequence[str] | None) -> bool:
        """Begin to mark; return whether nobody else does.

        Raises:
            Refused: What is needed for it is not where it was.
            OSError: The folder cannot be written, or no process begins.
        """
        again(opened.about, opened.layout, 1)  # whether all of it is there
        with self._lock:
            lock = None if self._process is not None else taken_for_marking(self._folder)
            if lock is None:
                return False
            try:
                process = subprocess.Popen(
                    [sys.executable, "-m", "vrts.desk.again.child"],
                    stdin=subprocess.PIPE,
                    stdout=subprocess.PIPE,
                    pass_fds=(lock,),  # who has it, marks
                    start_new_session=True,  # Ctrl-C is for the desk, which ends it
                )
            finally:
                os.close(lock)
            self._process = process
            count = 0 if students is None else len(students)
            self._told = MarkingTold(True, 0, count)
        asked = Asked(str(self._folder), None if students is None else tuple(students))
        threading.Thread(target=self._follow, args=(process, asked), daemon=True).start()
        self.changed()
        return True

    def cancel(self) -> bool:
        """Let it end after what is being marked, which is kept; return whether there is one."""
        with self._lock:
            process = self._process
            if process is None or process.stdin is None:
                return False
            process.stdin.close()
            return True

    def end(self) -> None:
        """Cancel, and wait until it has ended."""
        if self.cancel():
            with self._lock:
                process = self._process
            if process is not None:
                process.wait()

    def _follow(self, process: "subprocess.Popen[bytes]", asked: Asked) -> None:
        assert process.stdin is not None
        assert process.stdout is not None
        problem: str | None = DIED
        try:
            process.stdin.write(msgspec.json.encode(asked) + b"\n")
            process.stdin.flush()
        except (OSError, ValueError):  # it has died, or was cancelled before it began
            problem = DIED
        while line := process.stdout.readline(LONGEST):
            said = msgspec.json.decode(line, type=Said)
            if said.ended:
                problem = said.problem or None
            with self._lock:
                self._told = MarkingTold(True, said.done, said.all)
            self.changed()
        process.wait()
        process.stdout.close()
        with self._lock:
            self._process = None
            self._told = MarkingTold(False, self._told.done, self._told.all, problem)
        self.changed()
