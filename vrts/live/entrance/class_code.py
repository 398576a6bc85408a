"""The class code: what a guess at it is answered, and when another takes its place.

The code that is shown is the one that works, for as long as it is shown: it has no end of its own,
and outlasts the server. It stands in a file of the server's folder, beside the database and not in
it: copies of the database let nobody in.
"""

import os
from contextlib import suppress
from enum import Enum
from hmac import compare_digest
from pathlib import Path
from typing import Final

from vrts.live.entrance.guessing import length_after
from vrts.live.tokens import LETTERS, digest, new_code, plain_code

FILE: Final = "class-code"  # in the server's folder
UNREAD: Final = "?"  # in place of a code that cannot be read now: it lets nobody in
FORMER: Final = 16  # codes of before that are known as such


class Guess(Enum):
    """What something typed is."""

    RIGHT = "right"
    FORMER = "former"  # it was the code until it was renewed
    WRONG = "wrong"
    NO_CODE = "no code"  # nothing that can ever be right: it need not be counted


class ClassCode:
    """The code of a server, and how many wrong guesses were made; all in memory."""

    def __init__(self, text: str, wrong: int) -> None:
        """Begin with a code (empty: there is none), after so many wrong guesses in all."""
        self.text = text
        self.wrong = wrong
        self.changes = 0  # how often it was renewed, to tell what was found before
        self._former: list[bytes] = []

    def guess(self, typed: str) -> Guess:
        """Answer a guess; a wrong one is counted."""
        code = plain_code(typed)
        own = bool(self.text) and compare_digest(digest(code), digest(self.text))
        if own:
            return Guess.RIGHT
        if digest(code) in self._former:
            return Guess.FORMER
        if not self.text or len(code) != len(self.text) or not set(code) <= set(LETTERS):
            return Guess.NO_CODE
        self.wrong += 1
        return Guess.WRONG

    @property
    def used_up(self) -> bool:
        """Whether so many wrong guesses were made that a longer code has to take its place."""
        return bool(self.text) and length_after(self.wrong) > len(self.text)

    def fresh(self) -> str:
        """Return another code, as long as it has to be now."""
        return new_code(length_after(self.wrong))

    def replace(self, text: str) -> None:
        """Have another code (empty: none); the one of before is known as such."""
        if self.text:
            self._former = [*self._former, digest(self.text)][-FORMER:]
        self.text = text
        self.changes += 1


def kept_code(folder: Path) -> str:
    """Return the code that stands in a server's folder; empty: none; `UNREAD`: not known now."""
    path = folder / FILE
    try:
        return plain_code(path.read_text("utf-8", "replace")) if path.is_file() else ""
    except OSError:
        return UNREAD


def keep_code(folder: Path, text: str) -> None:
    """Write the code (empty: there is none), readable by the folder's owner only.

    It is theirs even where root writes it: their server has to read it.
    """
    path = folder / FILE
    if not text:
        path.unlink(missing_ok=True)
        return
    part = path.with_name(f"{FILE}.part")
    part.unlink(missing_ok=True)
    descriptor = os.open(part, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o600)
    with os.fdopen(descriptor, "w", encoding="utf-8") as file:
        if os.geteuid() == 0:
            owner = folder.stat()
            with suppress(OSError):  # such as in a container that does not know them
                os.fchown(descriptor, owner.st_uid, owner.st_gid)
        file.write(f"{text}\n")
    part.replace(path)
